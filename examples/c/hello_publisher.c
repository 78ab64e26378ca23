/* Says where the ball is, ten times a second, to whoever asks for it: needs a gemingad with the soccer ontology. */
#include <geminga/geminga.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char** argv) {
  const unsigned long count = argc > 1 ? strtoul(argv[1], NULL, 10) : (unsigned long)-1;
  geminga_error error;
  geminga_node* node = geminga_open(NULL, "hello-publisher", &error);
  geminga_publisher* ball =
      node == NULL ? NULL : geminga_publish(node, "mode=otm/pubsub concept=soccer:BallInfo camera=front", &error);
  if (ball == NULL) {
    fprintf(stderr, "hello_publisher: %s\n", error.text);
    geminga_close(node);
    return 2;
  }
  int status = 0;
  while (status == 0 && geminga_sent(ball) < count) { /* only what reaches somebody is counted */
    char text[64];
    const int size = snprintf(text, sizeof text, "{\"x\": 1.5, \"y\": -0.2, \"number\": %lu}",
                              (unsigned long)geminga_sent(ball) + 1);
    if (geminga_send(ball, text, (size_t)size, &error) < 0) {
      fprintf(stderr, "hello_publisher: %s\n", error.text);
      status = 3;
    }
    geminga_run(node, 100);
  }
  geminga_close(node);
  return status;
}
