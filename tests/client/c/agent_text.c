#define _POSIX_C_SOURCE 200809L
#include "client/c/agent_text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

void say(const char* format, ...) {
  va_list values;
  va_start(values, format);
  vprintf(format, values);
  va_end(values);
  putchar('\n');
  fflush(stdout);
}

void* room_for(size_t size) {
  void* made = calloc(1, size + 1);
  if (made == NULL) abort();
  return made;
}

char* copy_of(const char* text) { return strcpy(room_for(strlen(text)), text); }

char* next_word(char** rest) {
  char* word = *rest + strspn(*rest, " ");
  char* end = word + strcspn(word, " ");
  *rest = end + strspn(end, " ");
  if (*end != '\0') *end = '\0';
  return word;
}

unsigned char* from_hex(const char* text, size_t* size) {
  *size = strlen(text) / 2;
  unsigned char* octets = room_for(*size);
  for (size_t i = 0; i < *size; ++i) {
    const char digits[3] = {text[2 * i], text[2 * i + 1], '\0'};
    octets[i] = (unsigned char)strtoul(digits, NULL, 16);
  }
  return octets;
}

int64_t now(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return (int64_t)time.tv_sec * 1000 + time.tv_nsec / 1000000;
}
