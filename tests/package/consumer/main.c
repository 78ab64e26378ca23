/* Uses the installed C library: prints an identity, or what it says to parameters that it cannot read. */
#include <geminga/geminga.h>
#include <stdio.h>

int main(int argc, char** argv) {
  geminga_error error;
  geminga_node* node = geminga_open("127.0.0.1:1", "consumer", &error); /* nobody listens on tcpmux here */
  (void)argv;
  if (node == NULL) return 1;
  if (argc > 1) {
    printf("%u\n", geminga_concept_identity("https://geminga.example/soccer#BallInfo", NULL));
  } else {
    if (geminga_publish(node, "mode=none", &error) != NULL || error.status != GEMINGA_WRONG_USE) return 1;
    printf("linked and refused as it should be: %s\n", error.text);
  }
  geminga_close(node);
  return 0;
}
