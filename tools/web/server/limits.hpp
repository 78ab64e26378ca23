// Limits of HTTP on the wire, and its times.
#ifndef GEMINGA_WEB_SERVER_LIMITS_HPP
#define GEMINGA_WEB_SERVER_LIMITS_HPP

#include <chrono>
#include <cstddef>

namespace geminga::web {

/// The limits of readers. Tests use shorter times. A request has no body.
struct Limits {
  /// Octets of a request line and its fields; a longer head is answered by 431.
  std::size_t head_octets = std::size_t{8} * 1024;
  /// Connections at once. For one more, the one that has waited longest for a request is closed; where each is being
  /// answered, the new one is told 503.
  std::size_t connections = 64;
  /// Of these, streams of events; one more is told 503.
  std::size_t streams = 16;
  /// Requests of one connection, which is closed after the last one's response.
  std::size_t requests = 1000;
  /// The time for a whole head, from the end of the response before.
  std::chrono::milliseconds request_patience{10'000};
  /// The time in which a reader takes a whole response, or what a stream tells at once.
  std::chrono::milliseconds response_patience{10'000};
  /// The silence after which a stream says an empty comment, so that a reader which is gone is noticed.
  std::chrono::milliseconds heartbeat{15'000};
  /// The time, and the octets, for which a connection is read after a response that ends it before its request was
  /// read: a reader that still sends would lose the response otherwise (RFC 9112, 9.6).
  std::chrono::milliseconds linger{1000};
  std::size_t linger_octets = std::size_t{256} * 1024;
};

}  // namespace geminga::web

#endif
