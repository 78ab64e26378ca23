/* See ../clients. */
#include <arpa/inet.h>
#include <geminga/geminga.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

static char payload[65536];

static int plain_socket(int is_tcp, const struct sockaddr_in* there) {
  const int sock = socket(AF_INET, is_tcp ? SOCK_STREAM : SOCK_DGRAM, 0);
  const int on = 1;
  if (!is_tcp) return sock;
  if (connect(sock, (const struct sockaddr*)there, sizeof *there) != 0) return -1;
  setsockopt(sock, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  return sock;
}

static long long now(void) {
  struct timespec at;
  clock_gettime(CLOCK_MONOTONIC, &at);
  return at.tv_sec * 1000000000LL + at.tv_nsec;
}

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const int is_tcp = strcmp(argv[2], "tcp") == 0;
  geminga_error error;
  geminga_node* node = geminga_open(NULL, "sender", &error);
  if (node == NULL) return 3;
  char offer[256];
  snprintf(offer, sizeof offer, "mode=%s text=%s protocol=%s", argv[1], argv[3], argv[2]);
  geminga_publisher* publisher = geminga_publish(node, offer, &error);
  struct sockaddr_in there;
  memset(&there, 0, sizeof there);
  there.sin_family = AF_INET;
  there.sin_port = htons((unsigned short)atoi(argv[4]));
  there.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int plain = plain_socket(is_tcp, &there);
  if (publisher == NULL || plain < 0) return 2;
  while (geminga_sent(publisher) == 0) { /* nobody tells of the consumers of a stream */
    geminga_send(publisher, "there?", 6, &error);
    geminga_run(node, 10);
  }
  puts("ready");
  fflush(stdout);
  char how[16];
  unsigned count;
  size_t size;
  while (scanf("%15s", how) == 1 && strcmp(how, "quit") != 0 && scanf("%u %zu", &count, &size) == 2) {
    if (size > sizeof payload) break;
    const long long begin = now();
    if (how[0] == 'l') {
      for (unsigned i = 0; i < count; ++i) geminga_send(publisher, payload, size, &error);
    } else if (is_tcp) {
      for (unsigned i = 0; i < count; ++i) send(plain, payload, size, MSG_NOSIGNAL);
    } else {
      for (unsigned i = 0; i < count; ++i) {
        sendto(plain, payload, size, MSG_NOSIGNAL, (const struct sockaddr*)&there, sizeof there);
      }
    }
    printf("%lld\n", now() - begin);
    fflush(stdout);
  }
  close(plain);
  geminga_close(node);
  return 0;
}
