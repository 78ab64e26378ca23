// Lines, words and time of the agent of C.
#ifndef GEMINGA_TESTS_CLIENT_C_AGENT_TEXT_H
#define GEMINGA_TESTS_CLIENT_C_AGENT_TEXT_H

#include <stddef.h>
#include <stdint.h>

/* Writes a line, and sees to it that it is read. */
void say(const char* format, ...);
/* Zeros, one more than asked for. Never null. */
void* room_for(size_t size);
char* copy_of(const char* text);
/* Takes the next word, and the spaces behind it. */
char* next_word(char** rest);
/* The octets that a text is in hexadecimal digits; freed by the caller. */
unsigned char* from_hex(const char* text, size_t* size);
/* Milliseconds that never go back. */
int64_t now(void);

#endif
