// The events of the world, one at a time; env/asio tells them to the owner of the participant.
#ifndef GEMINGA_ENV_ASIO_EVENT_SINK_HPP
#define GEMINGA_ENV_ASIO_EVENT_SINK_HPP

#include <cstddef>
#include <span>
#include <string_view>

#include "env/env.hpp"

namespace geminga::env {

/// The functions of a participant that env/asio calls, always from the event loop and never from within an Env call.
/// Arguments are borrowed for the call.
class EventSink {
 public:
  virtual ~EventSink() = default;

  virtual void on_timer() = 0;
  /// `source` is the sender's numeric address. A datagram longer than max_datagram_bytes arrives cut to one octet more,
  /// so that it can be counted and refused.
  virtual void on_datagram(InterfaceIndex interface, std::string_view source, std::span<const std::byte> datagram) = 0;
  virtual void on_interfaces_changed() = 0;
  /// Env::route() may answer otherwise than before.
  virtual void on_routes_changed() = 0;
  /// `user` is the user that connected over a Unix socket, where the system tells; empty over TCP.
  virtual void on_stream_opened(StreamId stream, std::string_view user) = 0;
  virtual void on_stream_bytes(StreamId stream, std::string_view bytes) = 0;
  /// Everything that was written has been sent, after some of it had to wait.
  virtual void on_stream_drained(StreamId stream) = 0;
  virtual void on_stream_closed(StreamId stream) = 0;
};

}  // namespace geminga::env

#endif
