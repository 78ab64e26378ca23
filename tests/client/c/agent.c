// The agent of C: does what it is told on standard input, and says what happens (tests/client/conformance/AGENT.md).
#define _POSIX_C_SOURCE 200809L
#include <inttypes.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "client/c/agent_text.h"
#include "geminga/geminga.h"

enum { MESSAGES_AT_ONCE = 64, SHOWN_OCTETS = 32, READ_OCTETS = 65536 };

/* An event of a channel whose label is not known yet, or has not been said ok. */
typedef struct kept_event {
  uint32_t channel;
  char* word;
  char* rest;
  struct kept_event* next;
} kept_event;

typedef struct conversion {
  char* label;
  char* from_to;
  unsigned char* before;
  size_t size;
  struct conversion* next;
} conversion;

typedef struct channel {
  char* label;
  geminga_publisher* publisher; /* or */
  geminga_subscriber* subscriber;
  uint32_t number;
  int is_accepted, is_quiet, is_deaf, is_streaming;
  uint64_t taken, next_message, message_count, message_size;
  int64_t interval, due; /* of a stream, in milliseconds */
  struct channel* next;
} channel;

typedef struct agent {
  geminga_node* node;
  channel* channels;
  conversion* conversions;
  kept_event* events;
  int is_asking, is_quitting;
} agent;

static channel* labelled(agent* agent, const char* label) {
  channel* one = agent->channels;
  while (one != NULL && strcmp(one->label, label) != 0) one = one->next;
  return one;
}

static channel* numbered(agent* agent, uint32_t number) {
  channel* one = agent->channels;
  while (one != NULL && one->number != number) one = one->next;
  return one;
}

static void forget(kept_event* event) {
  free(event->word);
  free(event->rest);
  free(event);
}

static void keep(agent* agent, uint32_t number, const char* word, const char* rest) {
  kept_event** last = &agent->events;
  while (*last != NULL) last = &(*last)->next;
  *last = room_for(sizeof **last);
  **last = (kept_event){number, copy_of(word), copy_of(rest), NULL};
}

/* Forgets what was kept about a channel, or about all; says it, if there is a label. */
static void release(agent* agent, uint32_t number, const char* label) {
  for (kept_event** each = &agent->events; *each != NULL;) {
    kept_event* event = *each;
    if (number != 0 && event->channel != number) {
      each = &event->next;
      continue;
    }
    *each = event->next;
    if (label != NULL) say("%s %s %s", event->word, label, event->rest);
    forget(event);
  }
}

static void say_about(agent* agent, uint32_t number, const char* word, const char* rest) {
  channel* const known = numbered(agent, number);
  if (known != NULL && known->is_accepted) {
    say("%s %s %s", word, known->label, rest);
  } else if (known != NULL || agent->is_asking) {
    keep(agent, number, word, rest);
  }
}

static void accept(agent* agent, channel* one) {
  if (one->is_accepted) return;
  one->is_accepted = 1;
  say("ok %s", one->label);
  release(agent, one->number, one->label);
}

static void on_event(void* context, const geminga_event* event) {
  static const char* const changes[] = {"added", "modified", "removed"};
  agent* const agent = context;
  channel* const known = event->channel == 0 ? NULL : numbered(agent, event->channel);
  char rest[512];
  switch (event->kind) {
    case GEMINGA_CONNECTED:
      say("connected");
      break;
    case GEMINGA_DISCONNECTED:
      say("disconnected");
      break;
    case GEMINGA_ACCEPTED:
      if (known != NULL) accept(agent, known);
      if (known == NULL && agent->is_asking) keep(agent, event->channel, "accepted", "");
      break;
    case GEMINGA_REQUEST_REFUSED:
      if (known != NULL) say("error %s %s", known->label, event->text);
      break;
    case GEMINGA_PROBLEM:
      say_about(agent, event->channel, "problem", event->text);
      break;
    default: {
      const int is_provider = event->kind <= GEMINGA_PROVIDER_REMOVED;
      const int change = event->kind - (is_provider ? GEMINGA_PROVIDER_ADDED : GEMINGA_CONSUMER_ADDED);
      snprintf(rest, sizeof rest, "%s %016" PRIx64 " %s", changes[change], event->life,
               *event->text == '\0' ? "-" : event->text);
      say_about(agent, event->channel, is_provider ? "provider" : "consumer", rest);
    }
  }
}

/* Whether the daemon said before the call returned that it has taken what was asked for. */
static int was_accepted(agent* agent, uint32_t number) {
  for (kept_event** each = &agent->events; *each != NULL; each = &(*each)->next) {
    kept_event* const event = *each;
    if (event->channel != number || strcmp(event->word, "accepted") != 0) continue;
    *each = event->next;
    forget(event);
    return 1;
  }
  return 0;
}

static int convert(void* context, const void* payload, size_t size, geminga_writer* to) {
  const conversion* const one = context;
  geminga_write(to, one->before, one->size);
  geminga_write(to, payload, size);
  return 0;
}

static geminga_subscriber* subscribe(agent* agent, const char* label, const char* parameters, geminga_error* error) {
  size_t count = 0;
  for (conversion* one = agent->conversions; one != NULL; one = one->next) ++count;
  geminga_conversion* const given = room_for(count * sizeof *given);
  count = 0;
  for (conversion* one = agent->conversions; one != NULL; one = one->next) {
    if (strcmp(one->label, label) == 0) given[count++] = (geminga_conversion){one->from_to, convert, one};
  }
  geminga_subscriber* const made = geminga_subscribe_converting(agent->node, parameters, given, count, error);
  free(given);
  return made;
}

static void ask(agent* agent, int is_offer, const char* label, const char* parameters) {
  geminga_error error;
  channel* const made = room_for(sizeof *made);
  agent->is_asking = 1;
  if (is_offer) {
    made->publisher = geminga_publish(agent->node, parameters, &error);
    if (made->publisher != NULL) made->number = geminga_publisher_number(made->publisher);
  } else {
    made->subscriber = subscribe(agent, label, parameters, &error);
    if (made->subscriber != NULL) made->number = geminga_subscriber_number(made->subscriber);
  }
  agent->is_asking = 0;
  if (made->publisher == NULL && made->subscriber == NULL) {
    free(made);
    say("error %s %s", label, error.text);
    return;
  }
  made->label = copy_of(label);
  made->next = agent->channels;
  agent->channels = made;
  if (was_accepted(agent, made->number)) accept(agent, made);
}

static void drop(agent* agent, channel* gone) {
  for (channel** each = &agent->channels; *each != NULL; each = &(*each)->next) {
    if (*each != gone) continue;
    *each = gone->next;
    break;
  }
  release(agent, gone->number, NULL);
  free(gone->label);
  free(gone);
}

static void send_hex(channel* to, const char* hex) {
  geminga_error error;
  size_t size;
  unsigned char* const payload = from_hex(hex, &size);
  if (geminga_send(to->publisher, payload, size, &error) != 0) say("error %s %s", to->label, error.text);
  free(payload);
}

static void begin_stream(channel* of, char* rest) {
  of->message_count = strtoull(next_word(&rest), NULL, 10);
  of->message_size = strtoull(next_word(&rest), NULL, 10);
  if (of->message_size < 8) of->message_size = 8;
  of->interval = strtoll(next_word(&rest), NULL, 10);
  of->next_message = 1;
  of->due = now();
  of->is_streaming = 1;
}

static void count(const channel* of) {
  if (of->publisher != NULL) {
    say("count %s sent=%" PRIu64 " left_out=%" PRIu64 " dropped=0", of->label, geminga_sent(of->publisher),
        geminga_left_out(of->publisher));
  } else {
    say("count %s received=%" PRIu64 " missed=%" PRIu64 " dropped=%" PRIu64, of->label, of->taken,
        geminga_missed(of->subscriber), geminga_dropped(of->subscriber));
  }
}

static void identity(char* rest) {
  const char* const kind = next_word(&rest);
  uint32_t number = (uint32_t)strtoul(rest, NULL, 10);
  if (strcmp(kind, "text") == 0) number = geminga_text_identity(rest);
  if (strcmp(kind, "concept") == 0 || strcmp(kind, "expression") == 0) {
    // An expression has spaces, too; its last word is a representation unless it closes a bracket of the expression.
    const size_t size = strlen(rest);
    char* const space = size > 0 && rest[size - 1] == ')' ? NULL : strrchr(rest, ' ');
    if (space != NULL) *space = '\0';
    number = geminga_concept_identity(rest, space == NULL ? NULL : space + 1);
  }
  say("identity %" PRIu32, number);
}

static void add_conversion(agent* agent, const char* label, char* rest) {
  conversion* const made = room_for(sizeof *made);
  const char* const from = next_word(&rest);
  const char* const to = next_word(&rest);
  made->label = copy_of(label);
  made->from_to = room_for(strlen(from) + strlen(to) + 1);
  sprintf(made->from_to, "%s>%s", from, to);
  made->before = from_hex(rest, &made->size);
  made->next = agent->conversions;
  agent->conversions = made;
}

static void obey_about(agent* agent, const char* word, channel* one, char* rest) {
  geminga_error error = {0, 0, ""};
  if (strcmp(word, "count") == 0) {
    count(one);
  } else if (strcmp(word, "modify") == 0) {
    const int status = one->publisher != NULL ? geminga_modify_publisher(one->publisher, rest, &error)
                                              : geminga_modify_subscriber(one->subscriber, rest, &error);
    if (status != 0) say("error %s %s", one->label, error.text);
  } else if (strcmp(word, "close") == 0) {
    if (one->publisher != NULL) geminga_withdraw_publisher(one->publisher);
    if (one->subscriber != NULL) geminga_withdraw_subscriber(one->subscriber);
    say("closed %s", one->label);
    drop(agent, one);
  } else if (one->publisher != NULL) {
    if (strcmp(word, "send") == 0) send_hex(one, rest);
    if (strcmp(word, "stream") == 0) begin_stream(one, rest);
  } else {
    if (strcmp(word, "quiet") == 0) one->is_quiet = 1;
    if (strcmp(word, "deaf") == 0) one->is_deaf = 1;
    if (strcmp(word, "reading") == 0) one->is_deaf = 0;
  }
}

static void obey(agent* agent, char* line) {
  const char* const word = next_word(&line);
  if (*word == '\0') return;
  if (strcmp(word, "quit") == 0) {
    agent->is_quitting = 1;
  } else if (strcmp(word, "identity") == 0) {
    identity(line);
  } else if (strcmp(word, "frame") == 0 || strcmp(word, "line") == 0) {
    say("%s unknown", word);  // The interface shows neither.
  } else {
    const char* const label = next_word(&line);
    channel* const one = labelled(agent, label);
    if (strcmp(word, "pub") == 0 || strcmp(word, "sub") == 0) {
      ask(agent, *word == 'p', label, line);
    } else if (strcmp(word, "convert") == 0) {
      add_conversion(agent, label, line);
    } else if (one != NULL) {
      obey_about(agent, word, one, line);
    } else {
      say("error %s there is none of this name", label);
    }
  }
}

static void show(channel* of, const geminga_message* message) {
  ++of->taken;
  if (of->is_quiet) return;
  char hex[2 * SHOWN_OCTETS + 1] = "";
  const unsigned char* const payload = message->payload;
  for (size_t i = 0; i < message->size && i < SHOWN_OCTETS; ++i) snprintf(hex + 2 * i, 3, "%02x", payload[i]);
  say("message %s %016" PRIx64 " %" PRIu64 " %" PRIu64 " %zu %s", of->label, message->life, message->sequence,
      message->missed, message->size, hex);
}

static void stream(channel* of) {
  for (int i = 0; i < MESSAGES_AT_ONCE && of->is_streaming; ++i) {
    if (of->next_message > of->message_count) {
      of->is_streaming = 0;
      say("streamed %s", of->label);
      return;
    }
    if (of->interval > 0 ? now() < of->due : !geminga_wait_for_room(of->publisher, of->message_size, 0)) return;
    of->due += of->interval;
    unsigned char* const payload = room_for(of->message_size);
    for (int octet = 0; octet < 8; ++octet) payload[octet] = (unsigned char)(of->next_message >> (56 - 8 * octet));
    ++of->next_message;
    geminga_error error;
    if (geminga_send(of->publisher, payload, of->message_size, &error) != 0) {
      of->is_streaming = 0;
      say("error %s %s", of->label, error.text);
    }
    free(payload);
  }
}

/* Messages that came, and streams whose next message is due; the milliseconds until the next one is, or -1. */
static int look_around(agent* agent) {
  int left = -1;
  for (channel* one = agent->channels; one != NULL; one = one->next) {
    if (one->subscriber != NULL && one->is_accepted && !one->is_deaf) {
      for (const geminga_message* message; (message = geminga_receive(one->subscriber, 0)) != NULL;) show(one, message);
    }
    if (!one->is_streaming) continue;
    stream(one);
    if (!one->is_streaming) continue;
    const int64_t until = one->interval > 0 ? one->due - now() : 0;
    const int has_room = one->interval > 0 || geminga_wait_for_room(one->publisher, one->message_size, 0);
    if (has_room && (left < 0 || until < left)) left = until > 0 ? (int)until : 0;
  }
  return left;
}

static void run(agent* agent) {
  char* text = room_for(READ_OCTETS);
  size_t room = READ_OCTETS, size = 0;
  while (!agent->is_quitting) {
    geminga_process(agent->node);
    const int left = look_around(agent);
    struct pollfd waiting[] = {{STDIN_FILENO, POLLIN, 0}, {geminga_descriptor(agent->node), POLLIN, 0}};
    poll(waiting, 2, left);
    if ((waiting[0].revents & (POLLIN | POLLHUP)) == 0) continue;
    if (room - size < READ_OCTETS) text = realloc(text, (room *= 2) + 1);
    if (text == NULL) abort();
    const ssize_t count = read(STDIN_FILENO, text + size, READ_OCTETS);
    if (count <= 0) break;
    char* end = memchr(text + size, '\n', (size_t)count);
    size += (size_t)count;
    char* begin = text;
    for (; end != NULL && !agent->is_quitting; end = memchr(begin, '\n', (size_t)(text + size - begin))) {
      *end = '\0';
      obey(agent, begin);
      begin = end + 1;
    }
    size -= (size_t)(begin - text);
    memmove(text, begin, size);
  }
  free(text);
}

int main(int argc, char** argv) {
  geminga_error error;
  agent agent = {geminga_open(NULL, argc > 1 ? argv[1] : NULL, &error), NULL, NULL, NULL, 0, 0};
  if (agent.node == NULL) {
    fprintf(stderr, "agent: %s\n", error.text);
    return 2;
  }
  geminga_on_event(agent.node, on_event, &agent);
  run(&agent);
  geminga_close(agent.node);
  while (agent.channels != NULL) drop(&agent, agent.channels);
  release(&agent, 0, NULL);
  while (agent.conversions != NULL) {
    conversion* const gone = agent.conversions;
    agent.conversions = gone->next;
    free(gone->label);
    free(gone->from_to);
    free(gone->before);
    free(gone);
  }
  return 0;
}
