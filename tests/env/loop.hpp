// An event loop for a test: runs until a condition holds, and keeps what the sink was told.
#ifndef GEMINGA_TESTS_ENV_LOOP_HPP
#define GEMINGA_TESTS_ENV_LOOP_HPP

#include <sys/socket.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/log.hpp"
#include "env/asio/asio_env.hpp"
#include "env/asio/event_sink.hpp"

namespace geminga::env {

/// The patience of a test: far longer than anything takes.
inline constexpr std::chrono::seconds patience{30};

/// Runs handlers until `holds`. False: patience ended first.
[[nodiscard]] inline bool run_until(boost::asio::io_context& context, const std::function<bool()>& holds) {
  const auto until = std::chrono::steady_clock::now() + patience;
  context.restart();
  while (!holds()) {
    if (std::chrono::steady_clock::now() > until) return false;
    if (context.run_one_until(until) == 0) return holds();
  }
  return true;
}

/// A TCP and UDP port of the loopback interface that is free at this moment.
[[nodiscard]] inline std::uint16_t free_port() {
  boost::asio::io_context context;
  boost::asio::ip::tcp::acceptor probe(context, {boost::asio::ip::address_v4::loopback(), 0});
  return probe.local_endpoint().port();
}

/// Keeps the lines of a log.
class KeptLog final : public base::LogSink {
 public:
  void write(base::LogLevel, std::string_view line, const base::LogFields&) override { lines.emplace_back(line); }
  std::vector<std::string> lines;
};

/// Keeps the events that it is told; `on_event` is called after each.
class KeptEvents final : public EventSink {
 public:
  struct Datagram {
    InterfaceIndex interface;
    std::string source;
    std::string bytes;
  };

  void on_timer() override {
    ++timers;
    tell();
  }
  void on_datagram(InterfaceIndex interface, std::string_view source, std::span<const std::byte> datagram) override {
    datagrams.push_back(
        {interface, std::string(source), std::string(reinterpret_cast<const char*>(datagram.data()), datagram.size())});
    tell();
  }
  void on_interfaces_changed() override {
    ++changes;
    tell();
  }
  void on_routes_changed() override {
    ++route_changes;
    tell();
  }
  void on_stream_opened(StreamId stream, std::string_view user) override {
    opened.push_back(stream);
    users.emplace_back(user);
    tell();
  }
  void on_stream_bytes(StreamId stream, std::string_view bytes) override {
    said[stream] += bytes;
    tell();
  }
  void on_stream_drained(StreamId stream) override {
    drained.push_back(stream);
    tell();
  }
  void on_stream_closed(StreamId stream) override {
    closed.push_back(stream);
    tell();
  }

  int timers = 0;
  int changes = 0;
  int route_changes = 0;
  std::vector<Datagram> datagrams;
  std::vector<StreamId> opened;
  std::map<StreamId, std::string> said;
  std::vector<std::string> users;
  std::vector<StreamId> drained;
  std::vector<StreamId> closed;
  std::function<void()> on_event = [] {};

 private:
  void tell() { on_event(); }
};

[[nodiscard]] inline std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

}  // namespace geminga::env

#endif
