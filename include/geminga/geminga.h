// Geminga in C: services of a robot team are offered and asked for, and messages sent and received
// (src/client/c/README.md).
//
// The ABI is stable: structures of the library only grow at their end, and symbols have versions. Handles are opaque
// and belong to one thread at a time; the library starts no thread. Texts are UTF-8. A call that fails returns null or
// a negative number, and fills `error` if that is not null.
#ifndef GEMINGA_GEMINGA_H
#define GEMINGA_GEMINGA_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct geminga_node geminga_node;
typedef struct geminga_publisher geminga_publisher;
typedef struct geminga_subscriber geminga_subscriber;

enum {
  GEMINGA_WRONG_USE = -1, /* parameters that cannot be read, a port that is taken */
  GEMINGA_REFUSED = -2,   /* the daemon refused it; `code` says why */
  GEMINGA_TOO_LARGE = -3, /* a message over the limit of its protocol */
  GEMINGA_CLOSED = -4,    /* withdrawn or refused before */
  GEMINGA_FAILED = -5     /* no memory or no descriptor is left */
};

typedef struct geminga_error {
  int status;     /* one of the above */
  int code;       /* of GCNP, e.g. 422, if it was refused; else 0 */
  char text[248]; /* one line, cut where it is longer */
} geminga_error;

/* Begins to look for the daemon and does not wait for it. `connect` is ADDRESS:PORT or the path of a socket; null or
 * empty: the environment variable GEMINGA_CONNECT, or the usual address. `name` is shown to others; it may be null. */
geminga_node* geminga_open(const char* connect, const char* name, geminga_error* error);
/* As geminga_open(), for a program that needs so many subscriptions to streams beside the 256 of every client. */
geminga_node* geminga_open_with_room(const char* connect, const char* name, uint32_t room, geminga_error* error);
/* Withdraws everything cleanly and frees the node, its publishers and its subscribers. Null does nothing. */
void geminga_close(geminga_node* node);

/* A descriptor for poll(2): readable when geminga_process() has something to do, and when another call has read
 * messages or events that the program has not taken. Messages that were here when geminga_process() was called do not
 * make it readable: take them first. Owned by the node. */
int geminga_descriptor(const geminga_node* node);
/* Reads and writes what is ready, calls callbacks, and never waits. */
void geminga_process(geminga_node* node);
/* As geminga_process(), and waits for something to do for so many milliseconds; negative: as long as it takes. */
void geminga_wait(geminga_node* node, int milliseconds);
/* Drives the node for so many milliseconds, for example between two messages. */
void geminga_run(geminga_node* node, int milliseconds);
int geminga_is_connected(const geminga_node* node);

/* Offers a service. `parameters` are those of `pub create` in GCNP, e.g. "mode=otm/pubsub concept=soccer:BallInfo
 * rate=30"; without a port, any port is used. Waits for the daemon's answer if there is a daemon. */
geminga_publisher* geminga_publish(geminga_node* node, const char* parameters, geminga_error* error);
/* Asks for a service, by the parameters of `sub create`. */
geminga_subscriber* geminga_subscribe(geminga_node* node, const char* parameters, geminga_error* error);

/* The output of a conversion. geminga_write() appends to it and may be called several times. */
typedef struct geminga_writer geminga_writer;
void geminga_write(geminga_writer* to, const void* octets, size_t size);
/* Turns a payload of one representation into another. A result other than 0 drops the message. */
typedef int (*geminga_convert)(void* context, const void* payload, size_t size, geminga_writer* to);
typedef struct geminga_conversion {
  const char* from_to; /* "A>B", the names as events write them */
  geminga_convert convert;
  void* context;
} geminga_conversion;
/* As geminga_subscribe(), with conversions, which are copied. */
geminga_subscriber* geminga_subscribe_converting(geminga_node* node, const char* parameters,
                                                 const geminga_conversion* conversions, size_t count,
                                                 geminga_error* error);

/* Changes a request, by the parameters of `pub modify` and `sub modify`. Returns 0, or a negative number. */
int geminga_modify_publisher(geminga_publisher* publisher, const char* parameters, geminga_error* error);
int geminga_modify_subscriber(geminga_subscriber* subscriber, const char* parameters, geminga_error* error);
/* Withdraws cleanly and frees the handle. Null does nothing. */
void geminga_withdraw_publisher(geminga_publisher* publisher);
void geminga_withdraw_subscriber(geminga_subscriber* subscriber);

/* Sends to every consumer and never waits. Returns 0, or a negative number. */
int geminga_send(geminga_publisher* publisher, const void* payload, size_t size, geminga_error* error);
/* Waits until every consumer has room for one more message of this size. Returns 1, or 0 if the time passes first. */
int geminga_wait_for_room(geminga_publisher* publisher, size_t size, int milliseconds);

typedef struct geminga_message {
  uint64_t life; /* of the publisher; 0: it states none */
  uint64_t sequence;
  uint64_t missed; /* messages that did not come between the one before and this one */
  const void* payload;
  size_t size;
} geminga_message;

/* The next message, for which it waits so many milliseconds; negative: as long as it takes. Null: none came. The
 * message lives until the next call with this subscriber. */
const geminga_message* geminga_receive(geminga_subscriber* subscriber, int milliseconds);
/* Gives every further message to this function, within geminga_process() and the calls that wait. The message lives as
 * long as the call. */
typedef void (*geminga_on_message_call)(void* context, geminga_subscriber* subscriber, const geminga_message* message);
void geminga_on_message(geminga_subscriber* subscriber, geminga_on_message_call call, void* context);

enum {
  GEMINGA_CONNECTED = 1, /* the daemon was reached */
  GEMINGA_DISCONNECTED,  /* it is gone; the node looks for it again, and channels go on */
  GEMINGA_ACCEPTED,      /* it has accepted a request */
  GEMINGA_REQUEST_REFUSED,
  GEMINGA_PROVIDER_ADDED,
  GEMINGA_PROVIDER_MODIFIED,
  GEMINGA_PROVIDER_REMOVED,
  GEMINGA_CONSUMER_ADDED,
  GEMINGA_CONSUMER_MODIFIED,
  GEMINGA_CONSUMER_REMOVED,
  GEMINGA_PROBLEM /* something that a person should know */
};
typedef struct geminga_event {
  int kind;         /* one of the above; there may be more */
  uint32_t channel; /* geminga_publisher_number() or geminga_subscriber_number(); 0: the node */
  uint64_t life;    /* of the provider or consumer */
  const char* text; /* the reason, what is wrong, or empty */
  const char* name; /* of the provider or consumer, or empty */
  const char* host; /* the name of its participant, or empty */
} geminga_event;
/* Gives every further event to this function, within geminga_process() and the calls that wait. The event lives as long
 * as the call. */
typedef void (*geminga_on_event_call)(void* context, const geminga_event* event);
void geminga_on_event(geminga_node* node, geminga_on_event_call call, void* context);

/* Gives every further line that says what the node waits for and what was refused to this function, without an end.
 * Until then, and for a null function, lines go to standard error with "geminga: " before them. */
typedef void (*geminga_on_log_call)(void* context, const char* line);
void geminga_on_log(geminga_node* node, geminga_on_log_call call, void* context);

uint32_t geminga_publisher_number(const geminga_publisher* publisher);
uint32_t geminga_subscriber_number(const geminga_subscriber* subscriber);
uint64_t geminga_publisher_life(const geminga_publisher* publisher);
uint64_t geminga_subscriber_life(const geminga_subscriber* subscriber);
/* Messages that had a consumer, and copies that were left out for a consumer that does not keep up. */
uint64_t geminga_sent(const geminga_publisher* publisher);
uint64_t geminga_left_out(const geminga_publisher* publisher);
/* Messages that were taken or wait to be taken; messages that did not come between them, or were lost in a full inbox;
 * datagrams and frames that were not believed or could not be converted. */
uint64_t geminga_received(const geminga_subscriber* subscriber);
uint64_t geminga_missed(const geminga_subscriber* subscriber);
uint64_t geminga_dropped(const geminga_subscriber* subscriber);

/* The 32-bit identity of a text, or of a concept with a representation (null or empty: none), both full IRIs. */
uint32_t geminga_text_identity(const char* text);
uint32_t geminga_concept_identity(const char* concept_iri, const char* representation_iri);

#ifdef __cplusplus
}
#endif

#endif
