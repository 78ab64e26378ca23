// The connections of clients to one simulated host, as its streams carry them.
#ifndef GEMINGA_TESTS_SIM_CONNECTIONS_HPP
#define GEMINGA_TESTS_SIM_CONNECTIONS_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "env/env.hpp"

namespace geminga::sim {

class Client;
class Host;

/// Each way is a queue: what was written at one side waits until the other one reads, all of it.
class Connections {
 public:
  /// Borrows the host for its life.
  explicit Connections(Host& host) : host_(host) {}
  Connections(const Connections&) = delete;
  Connections& operator=(const Connections&) = delete;

  /// A number that no stream has had.
  [[nodiscard]] env::StreamId next() { return env::StreamId(next_++); }
  /// Borrows the client until it is closed, lost or dropped.
  void open(env::StreamId stream, Client& client);
  /// Ends all; each client is told that it has lost its connection.
  void drop();
  /// After a pause of the host: octets that wait are heard again.
  void resume();

  /// The client's side.
  void from_client(env::StreamId stream, std::string bytes);
  void client_closed(env::StreamId stream);
  /// Whether the client reads what it is told; what it does not read waits here, all of it.
  void set_reading(env::StreamId stream, bool is_reading);
  /// A client that does not read otherwise reads so many octets of what waits for it.
  void read(env::StreamId stream, std::size_t octets);

  /// The participant's side, as in env::Env.
  void write(env::StreamId stream, std::string_view bytes);
  [[nodiscard]] std::size_t unsent(env::StreamId stream) const;
  void want(env::StreamId stream, bool is_wanted);
  void close(env::StreamId stream);
  /// Has what was written go on its way. Call at the end of each event.
  void flush();

 private:
  /// One connection: what waits in either direction.
  struct Stream {
    Client* client = nullptr;
    bool is_reading = true;  ///< the client
    bool is_wanted = true;   ///< by the participant
    bool has_hung_up = false;
    mutable bool is_behind = false;  ///< the participant knows that something waits
    std::string unsent{};
    std::string unheard{};
  };

  void give(env::StreamId stream, std::string bytes);
  void hear(env::StreamId stream);
  /// Does something in an event of its own, unless the participant has ended by then.
  void soon(std::function<void()> what);

  Host& host_;
  std::uint64_t next_ = 1;
  std::map<env::StreamId, Stream> streams_;
};

}  // namespace geminga::sim

#endif
