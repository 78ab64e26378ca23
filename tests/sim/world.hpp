// A small seeded world: virtual time, and a network that loses, delays, copies and reorders what participants send.
#ifndef GEMINGA_TESTS_SIM_WORLD_HPP
#define GEMINGA_TESTS_SIM_WORLD_HPP

#include <cstdint>
#include <functional>
#include <memory>
#include <queue>
#include <string>
#include <string_view>
#include <vector>

#include "base/random.hpp"
#include "base/time.hpp"
#include "env/env.hpp"

namespace geminga::sim {

class Client;
class Host;

/// How the air is. Every receiver's fortune is drawn for itself, as with radio.
struct Air {
  double loss = 0;       ///< share of datagrams that a receiver misses
  double duplicate = 0;  ///< share that comes twice
  base::Duration shortest_delay = std::chrono::microseconds(200);
  base::Duration longest_delay = std::chrono::milliseconds(2);  ///< longer than a gap between two datagrams: reorders
};

/// Owns the hosts and the time. The same seed and the same calls give the same run, which trace_hash() proves.
class World {
 public:
  explicit World(std::uint64_t seed, Air air = {});
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// The seed that the environment variable GEMINGA_SEED gives, or `otherwise`; said in every failure message.
  static std::uint64_t seed_or(std::uint64_t otherwise);
  /// "seed 7, at 12.345 s": for failure messages.
  [[nodiscard]] std::string when() const;

  [[nodiscard]] base::Instant now() const { return now_; }
  [[nodiscard]] base::Random& random() { return random_; }
  [[nodiscard]] std::uint64_t seed() const { return seed_; }

  Air air;

  /// A host that is switched off yet and connected to the network `segment` by the interface eth0.
  Host& add_host(const std::string& name, std::uint32_t segment = 0);
  [[nodiscard]] const std::vector<std::unique_ptr<Host>>& hosts() const { return hosts_; }

  /// A GCNP client that lives as long as the world.
  Client& add_client(const std::string& name);

  /// Calls back at an instant, after everything that was asked for the same instant before.
  void at(base::Instant instant, std::function<void()> what);
  void after(base::Duration delay, std::function<void()> what) { at(now_ + delay, std::move(what)); }
  /// Calls back again and again, for as long as the world runs.
  void every(base::Duration period, std::function<void()> what);

  /// Lets all happen that is due within this time, and leaves the clock at its end.
  void run_for(base::Duration duration);

  /// Hands a datagram to everybody on the sender's network, the sender too, as multicast does.
  void transmit(const Host& sender, env::InterfaceIndex interface, std::string_view datagram);

  /// Hands a datagram to everybody on the network 0, as if it came from this address.
  void inject(const std::string& source, std::string_view datagram);
  /// Called with each datagram that a host sends, before anybody hears it: for who listens in on the air.
  std::function<void(const Host& sender, std::string_view datagram)> on_transmit;

  /// Enters something observable into the trace.
  void trace(std::string_view who, std::string_view what);
  [[nodiscard]] std::uint64_t trace_hash() const { return trace_; }

  [[nodiscard]] std::uint64_t datagrams() const { return datagrams_; }
  [[nodiscard]] std::uint64_t datagram_bytes() const { return datagram_bytes_; }

 private:
  struct Due {
    base::Instant instant;
    std::uint64_t sequence;
    std::function<void()> what;
    bool operator>(const Due& other) const {
      return instant != other.instant ? instant > other.instant : sequence > other.sequence;
    }
  };

  void deliver(Host& receiver, env::InterfaceIndex interface, const std::string& source,
               const std::shared_ptr<const std::string>& datagram);

  std::uint64_t seed_;
  base::Random random_;
  base::Instant now_{};
  std::uint64_t sequence_ = 0;
  std::uint64_t trace_ = 0;
  std::uint64_t datagrams_ = 0;
  std::uint64_t datagram_bytes_ = 0;
  std::priority_queue<Due, std::vector<Due>, std::greater<>> due_;
  std::vector<std::unique_ptr<Client>> clients_;
  std::vector<std::unique_ptr<Host>> hosts_;
};

}  // namespace geminga::sim

#endif
