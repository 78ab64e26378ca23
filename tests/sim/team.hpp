// A team of robots with modules as scripted GCNP clients, and the oracle that knows what each of them should be told.
#ifndef GEMINGA_TESTS_SIM_TEAM_HPP
#define GEMINGA_TESTS_SIM_TEAM_HPP

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "sim/client.hpp"
#include "sim/host.hpp"
#include "sim/world.hpp"

namespace geminga::sim {

/// One module on one host: a client that says hello, offers and asks, and connects again when its daemon returns. Every
/// offer has a port of its own on its host, so that an event's address and port tell whose it is.
class Module {
 public:
  struct Offer {
    std::string text;
    std::string mode;
    std::uint16_t port = 0;
  };
  struct Wish {
    std::string text;
    std::string mode;
  };

  Module(World& world, Host& host, const std::string& name);

  [[nodiscard]] Host& host() { return host_; }
  [[nodiscard]] Client& client() { return client_; }
  [[nodiscard]] const std::map<std::uint32_t, Offer>& offers() const { return offers_; }
  [[nodiscard]] const std::map<std::uint32_t, Wish>& wishes() const { return wishes_; }

  /// Each returns the number of the request.
  std::uint32_t offer(const std::string& text, const std::string& mode);
  std::uint32_t wish(const std::string& text, const std::string& mode);
  void withdraw(std::uint32_t number);
  /// Connects and says everything, now and whenever the host is on again.
  void run();
  void end();

 private:
  void connect();

  World& world_;
  Host& host_;
  Client& client_;
  std::uint32_t next_ = 1;
  bool is_running_ = false;
  std::map<std::uint32_t, Offer> offers_;
  std::map<std::uint32_t, Wish> wishes_;
};

/// How long a view may be wrong, by what is wrong with it.
struct Bounds {
  base::Duration missing = std::chrono::seconds(4);   ///< a service is there and its consumer has not been told
  base::Duration surplus = std::chrono::seconds(25);  ///< a service is gone and its consumer has not been told
};

/// Watches all modules of a world all the time. Every failure says the seed and the time.
class Team {
 public:
  explicit Team(World& world, Bounds bounds = {});

  Module& add(Host& host, const std::string& name);
  [[nodiscard]] const std::vector<std::unique_ptr<Module>>& modules() const { return modules_; }

  /// Whether every view is exactly right now.
  [[nodiscard]] bool is_right() const;
  /// What is wrong with the views now, in words; empty: nothing.
  [[nodiscard]] std::string complaints() const;
  /// Until every view is right, in steps; false after `at_most`.
  bool settle(base::Duration at_most);

  /// Each time that one host was told `del reason=expired` of another one which was well all the time, in words.
  [[nodiscard]] const std::set<std::string>& false_departures() const { return false_departures_; }
  [[nodiscard]] std::size_t events() const { return events_; }
  /// While true, wrong views are not held against anybody: the network is cut, say.
  bool is_excused = false;

 private:
  /// "7:5003": the port of a host.
  using Place = std::string;
  using Places = std::set<Place>;

  /// By island, text and mode: what there is to be told of.
  using Offered = std::map<std::tuple<int, std::string, std::string>, Places>;

  [[nodiscard]] Offered offered() const;
  [[nodiscard]] static Places seen(Module& consumer, std::uint32_t wish);
  void check_views();
  void check_identifiers();
  void watch(Module& module);
  void see(Module& module, std::string_view line, const gcnp::Statement& statement);

  World& world_;
  Bounds bounds_;
  std::vector<std::unique_ptr<Module>> modules_;
  std::map<std::string, base::Instant> wrong_since_;
  base::Instant same_identifier_since_ = base::never;
  std::set<std::string> false_departures_;
  std::size_t events_ = 0;
};

}  // namespace geminga::sim

#endif
