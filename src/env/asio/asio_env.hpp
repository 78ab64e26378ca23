// The real world on one Boost.Asio event loop: the Env of gemingad.
#ifndef GEMINGA_ENV_ASIO_ASIO_ENV_HPP
#define GEMINGA_ENV_ASIO_ASIO_ENV_HPP

#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "env/asio/endpoint.hpp"
#include "env/asio/event_sink.hpp"
#include "env/asio/reception.hpp"
#include "env/asio/unicast.hpp"
#include "env/env.hpp"

namespace boost::asio {
class io_context;
}

namespace geminga::env {

/// Which interfaces, groups and hosts are spoken with.
struct AirSettings {
  std::vector<std::string> interfaces;  ///< empty: every one that can multicast, without the loopback
  std::vector<std::string> groups;      ///< numeric multicast addresses
  std::uint16_t port = 0;
  std::vector<HostPort> peers;  ///< unicast copies go there
  /// What others send to us alone is heard, too: all that is heard is sealed.
  bool admits_guests = false;
  friend bool operator==(const AirSettings&, const AirSettings&) = default;
};

/// One event loop, one thread. Everything that happens reaches the EventSink as one event, within which now() stands
/// still and after which what was written goes out. No function throws, but for want of memory.
class AsioEnv final : public Env {
 public:
  /// Borrows all for its life. No socket is opened yet.
  AsioEnv(boost::asio::io_context& context, base::LogSink& log);
  ~AsioEnv() override;
  AsioEnv(const AsioEnv&) = delete;
  AsioEnv& operator=(const AsioEnv&) = delete;

  /// Listens for GCNP clients, who wait until serve(). An address that `may_be_missing` and does not exist on this host
  /// is left out with a line in the log. The error is one line that says what to do.
  [[nodiscard]] std::expected<void, std::string> listen(const Endpoint& endpoint, bool may_be_missing);
  /// The same at a path: a Unix socket (env/asio/socket_file.hpp).
  [[nodiscard]] std::expected<void, std::string> listen(const std::string& path);
  /// Opens the interfaces; interfaces() is filled when this returns. Called again, it changes to other settings and
  /// tells the sink of the change.
  void open_air(AirSettings settings);
  /// From now on `sink` is told what happens. It is borrowed for the life of this object.
  void serve(EventSink& sink);
  /// Takes no more clients; for the end.
  void stop_listening();
  /// Calls `action` as one event: for what the owner itself does with the participant.
  void event(const std::function<void()>& action);
  /// The datagrams that were not handed over.
  [[nodiscard]] const AirCounts& air_counts() const;
  /// The hosts that are spoken to alone.
  [[nodiscard]] UnicastCounts unicast_counts() const;
  /// Whether bytes for a client are still on their way.
  [[nodiscard]] bool is_writing() const;

  [[nodiscard]] base::Instant now() const override;
  void wake_at(base::Instant instant) override;
  [[nodiscard]] std::uint64_t random_bits() override;
  [[nodiscard]] const std::vector<Interface>& interfaces() const override;
  void send(InterfaceIndex interface, std::span<const std::byte> datagram) override;
  [[nodiscard]] bool is_sender_unnamed() const override;
  void answer_sender(base::Duration time) override;
  void write(StreamId stream, std::string_view bytes) override;
  [[nodiscard]] std::size_t unsent(StreamId stream) const override;
  void want(StreamId stream, bool is_wanted) override;
  void close(StreamId stream) override;
  [[nodiscard]] base::LogSink& log() override;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace geminga::env

#endif
