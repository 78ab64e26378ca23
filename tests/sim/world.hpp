// A small seeded world: virtual time, and a network that loses, delays, copies and reorders what participants send.
#ifndef GEMINGA_TESTS_SIM_WORLD_HPP
#define GEMINGA_TESTS_SIM_WORLD_HPP

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/random.hpp"
#include "base/time.hpp"
#include "discovery/participant/air/shared.hpp"
#include "discovery/registry/stored.hpp"
#include "env/env.hpp"
#include "sim/agenda.hpp"
#include "sim/air.hpp"
#include "sim/fail_test.hpp"
#include "sim/links.hpp"

namespace geminga::sim {

class Client;
class Host;

/// Owns the hosts and the time. The same seed and the same calls give the same run, which trace_hash() proves.
class World {
 public:
  /// Where a checker says what must not be.
  using Complain = std::function<void(const std::string& complaint)>;

  explicit World(std::uint64_t seed, Air air = {}, Complain complain = fail_test);
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
  /// The things that hosts which are added from now on share; null: each decodes and keeps everything for itself.
  std::shared_ptr<participant::Shared> shared = std::make_shared<participant::Shared>();
  std::shared_ptr<registry::SharedEntries> shared_entries = std::make_shared<registry::SharedEntries>();

  /// Something is that must not be. The complaint begins with a word for the checker, and gets seed and time.
  void complain(const std::string& complaint) { complain_(complaint + " " + when()); }

  /// A host that is switched off yet and connected to the network `segment` by the interface eth0.
  Host& add_host(const std::string& name, std::uint32_t segment = 0);
  [[nodiscard]] const std::vector<std::unique_ptr<Host>>& hosts() const { return hosts_; }

  /// A GCNP client that lives as long as the world.
  Client& add_client(const std::string& name);
  /// The lines of the answer to a query of a client that comes for it. Takes two milliseconds.
  std::vector<std::string> ask(Host& host, const std::string& query);

  /// Calls back at an instant, after everything that was asked for the same instant before.
  void at(base::Instant instant, std::function<void()> what);
  void after(base::Duration delay, std::function<void()> what) { at(now_ + delay, std::move(what)); }
  /// Calls back again and again, for as long as the world runs.
  void every(base::Duration period, std::function<void()> what);

  /// Lets all happen that is due within this time, and leaves the clock at its end.
  void run_for(base::Duration duration);

  /// Whether what `from` sends can get to `to`, if nothing is lost.
  [[nodiscard]] bool is_reached(const Host& from, const Host& to) const;
  /// `to` hears nothing of `from` any more; or hears it again.
  void cut(const Host& from, const Host& to);
  void mend(const Host& from, const Host& to);
  /// When a process that had been stopped last read what waited for it. It takes old words for new ones, and tells
  /// others so in its next presence.
  base::Instant old_words_read{};
  /// Called when somebody hears others than before: islands, cuts, hosts that sleep.
  std::function<void()> on_reach_changed;

  /// Hands a datagram to everybody on the sender's network, the sender too, as multicast does.
  void transmit(const Host& sender, env::InterfaceIndex interface, std::string_view datagram);
  /// Hands a datagram to the host at this address, if it hears what comes to it alone.
  void transmit_alone(const Host& sender, env::InterfaceIndex interface, std::string_view address,
                      std::string_view datagram);

  /// Hands a datagram to everybody on a network, as if it came from this address.
  void inject(const std::string& source, std::string_view datagram, std::uint32_t segment = 0);
  /// Called with each datagram that a host sends, before anybody hears it: for who listens in on the air.
  std::function<void(const Host& sender, std::string_view datagram)> on_transmit;

  /// Lets a host's timer ring at an instant; it knows itself whether that still counts.
  void ring_at(base::Instant instant, const Host& host);

  /// Enters something observable into the trace.
  void trace(std::string_view who, std::string_view what);
  [[nodiscard]] std::uint64_t trace_hash() const { return trace_; }

  [[nodiscard]] std::uint64_t datagrams() const { return datagrams_; }
  [[nodiscard]] std::uint64_t datagram_bytes() const { return datagram_bytes_; }

 private:
  /// One copy of a datagram that is on its way to one receiver.
  struct Arrival {
    base::Instant instant;
    std::uint32_t host = 0;  ///< its place in hosts_
    env::InterfaceIndex interface{};
    std::uint64_t incarnation = 0;
  };
  /// A datagram and all copies that are on their way, the next one last.
  struct Flight {
    std::string source;
    std::string datagram;
    bool is_alone = false;  ///< it is for one host
    std::vector<Arrival> arrivals;
  };
  struct Due {
    enum class Kind : std::uint8_t { call, flight, ring } kind{};
    std::uint32_t index = 0;  ///< in calls_, flights_ or hosts_
  };

  std::uint32_t take_off(std::string_view source, std::string_view datagram);
  void add_arrival(std::uint32_t flight, const Host& receiver, env::InterfaceIndex interface);
  void depart(std::uint32_t flight);
  void fly(std::uint32_t flight, base::Instant end);
  void call(std::uint32_t index);
  [[nodiscard]] std::string bent(std::string_view datagram);

  Complain complain_;
  std::uint64_t seed_;
  base::Random random_;
  base::Instant now_{};
  std::uint64_t trace_ = 0;
  std::uint64_t datagrams_ = 0;
  std::uint64_t datagram_bytes_ = 0;
  Links links_;
  Agenda<Due> agenda_;
  std::vector<std::function<void()>> calls_;
  std::vector<std::uint32_t> free_calls_;
  std::vector<std::unique_ptr<Flight>> flights_;
  std::vector<std::uint32_t> free_flights_;
  std::vector<std::unique_ptr<Client>> clients_;
  std::vector<std::unique_ptr<Host>> hosts_;
};

}  // namespace geminga::sim

#endif
