/* Prints where the ball is, whoever in the team knows it: needs a gemingad with the soccer ontology. */
#include <geminga/geminga.h>
#include <stdio.h>
#include <stdlib.h>

static void told(void* context, const geminga_event* event) {
  (void)context;
  if (event->kind == GEMINGA_PROVIDER_ADDED) fprintf(stderr, "%s on %s added\n", event->name, event->host);
  if (event->kind == GEMINGA_PROVIDER_REMOVED) fprintf(stderr, "%s removed: %s\n", event->name, event->text);
}

int main(int argc, char** argv) {
  const unsigned long count = argc > 1 ? strtoul(argv[1], NULL, 10) : (unsigned long)-1;
  geminga_error error;
  geminga_node* node = geminga_open(NULL, "hello-subscriber", &error);
  geminga_subscriber* balls =
      node == NULL ? NULL : geminga_subscribe(node, "mode=otm/pubsub concept=soccer:TrackedObject", &error);
  if (balls == NULL) {
    fprintf(stderr, "hello_subscriber: %s\n", error.text);
    geminga_close(node);
    return 2;
  }
  geminga_on_event(node, told, NULL);
  int status = 0;
  for (unsigned long number = 0; number < count; ++number) {
    const geminga_message* ball = geminga_receive(balls, -1);
    if (ball == NULL) {
      fprintf(stderr, "hello_subscriber: the daemon took the request back\n");
      status = 3;
      break;
    }
    printf("%.*s\n", (int)ball->size, (const char*)ball->payload);
    fflush(stdout);
  }
  geminga_close(node);
  return status;
}
