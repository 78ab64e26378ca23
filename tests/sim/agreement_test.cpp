// Both sides agree on who serves whom: whatever three hosts offer and ask for, when nothing changes any more each
// consumer has been told of exactly those providers that have been told of it.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/client.hpp"
#include "sim/host.hpp"
#include "sim/small_ontology.hpp"
#include "sim/world.hpp"
#include "support/rounds.hpp"

namespace geminga::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// Three hosts with two clients each, that say what chance says.
class Agreement {
 public:
  enum class Crowd : std::uint8_t {
    mixed,
    crowded,     ///< many offer the same
    converting,  ///< many convert, and all ask for that
  };

  Agreement(std::uint64_t seed, Air air, Crowd crowd) : crowd_(crowd), world_(seed, air), random_(world_.random()) {
    for (const char* name : {"robot1", "robot2", "robot3"}) {
      Host& host = world_.add_host(name);
      host.ontology = small_ontology("frames");
      host.switch_on();
      hosts_.push_back(&host);
      for (const char* module : {"vision", "base"}) {
        Client& client = world_.add_client(std::string(name) + '/' + module);
        client.keeps_lines = false;
        clients_.push_back({&client, &host, module});
      }
    }
    world_.run_for(seconds(2));
    for (auto& one : clients_) connect(one);
  }

  void step() {
    const std::uint64_t dice = random_.below(100);
    auto& one = clients_[random_.below(clients_.size())];
    if (dice < 4) {
      restart(*one.host);
    } else if (dice < 5) {
      reload();
    } else if (dice < 7) {
      one.client->say("0 sys hello name=" + one_of<3>({"vision", "base", "eye"}));
    } else if (dice < 10) {
      one.client->hang_up();
      connect(one);
    } else if (dice < (crowd_ == Crowd::crowded ? 85 : 55)) {
      offer(one);
    } else {
      ask(one);
    }
    if (random_.chance(0.3)) world_.run_for(milliseconds(random_.below(2000)));
  }

  /// The difference between the two sides, after all that is on its way has come.
  std::string difference() {
    world_.run_for(must_expire_ ? seconds(40) : seconds(8));
    must_expire_ = false;
    std::map<Pair, std::string> given;
    std::map<Pair, std::string> taken;
    for (const auto& one : clients_) {
      const std::string own = one.client->participant() + '/' + one.client->peer() + '/';
      for (const auto& [number, request] : one.asked) {
        for (const auto& [service, event] : one.client->view(number)) {
          if (event.value("mode") == "otm/stream") continue;  // its provider is not told
          given.emplace(Pair(own + std::to_string(number), service), match_of(event));
        }
      }
      for (const auto& [number, request] : one.offered) {
        for (const auto& [subscription, event] : one.client->view(number)) {
          taken.emplace(Pair(subscription, own + std::to_string(number)), match_of(event));
        }
      }
    }
    pairs_ += given.size();
    std::string words;
    for (const auto& [pair, match] : given) {
      const auto found = taken.find(pair);
      if (found == taken.end()) {
        words += describe(pair) + ": the provider is not told\n";
      } else if (found->second != match) {
        words += describe(pair) + ": the consumer is told " + match + ", the provider " + found->second + '\n';
      }
    }
    for (const auto& [pair, match] : taken) {
      if (!given.contains(pair)) words += describe(pair) + ": the consumer is not told\n";
    }
    return words;
  }

  [[nodiscard]] std::size_t pairs() const { return pairs_; }
  [[nodiscard]] std::string when() const { return world_.when(); }

 private:
  using Pair = std::pair<std::string, std::string>;
  /// A client and what it has stated, number by number.
  struct Module {
    Client* client = nullptr;
    Host* host = nullptr;
    std::string name;
    std::map<std::uint32_t, std::string> offered{};
    std::map<std::uint32_t, std::string> asked{};
  };

  static std::string match_of(const gcnp::Statement& event) {
    return std::string(event.value("degree").value_or("?")) + ' ' + std::string(event.value("distance").value_or("?"));
  }

  std::string describe(const Pair& pair) const {
    std::string words = pair.first + " by " + pair.second;
    for (const auto& one : clients_) {
      const std::string own = one.client->participant() + '/' + one.client->peer() + '/';
      for (const auto& [number, said] : one.asked) {
        if (own + std::to_string(number) == pair.first) words += "\n  " + one.client->name() + " " + said;
      }
      for (const auto& [number, said] : one.offered) {
        if (own + std::to_string(number) == pair.second) words += "\n  " + one.client->name() + " " + said;
      }
    }
    return words + "\n ";
  }

  template <std::size_t size>
  std::string one_of(const std::array<const char*, size>& words) {
    return words[random_.below(size)];
  }

  void connect(Module& one) {
    one.offered.clear();
    one.asked.clear();
    one.client->connect(*one.host);
    one.client->say("0 sys hello name=" + one.name);
    world_.run_for(milliseconds(5));
  }

  void restart(Host& host) {
    const bool is_silent = random_.chance(0.5);
    if (is_silent) {
      host.crash();
    } else {
      host.stop();
    }
    must_expire_ = true;
    world_.run_for(seconds(random_.chance(0.5) ? 1 : 40));
    if (random_.chance(0.3)) host.settings.name = host.name() + (host.settings.name == host.name() ? "b" : "");
    host.switch_on();
    world_.run_for(seconds(3));
    for (auto& one : clients_) {
      if (one.host == &host) connect(one);
    }
  }

  /// All of them, one after the other.
  void reload() {
    const auto next = small_ontology(one_of<5>({"frames", "frames", "other-frames", "other-frames", "soccer"}));
    for (Host* host : hosts_) {
      host->ontology = next;
      host->reload(next);
      if (random_.chance(0.5)) world_.run_for(seconds(1));
    }
  }

  std::string mode() { return crowd_ != Crowd::mixed ? "oto" : one_of<4>({"oto", "oto", "otm/pubsub", "otm/stream"}); }
  std::string identity(bool is_offer) {
    if (crowd_ == Crowd::crowded)
      return is_offer && random_.chance(0.7) ? " concept=soccer:Ball representation=soccer:RobotFrame"
                                             : " concept=soccer:Ball";
    if (random_.chance(0.1)) return " text=goalie";
    if (!is_offer && random_.chance(0.1)) return " concept=\"soccer:TrackedObject and not soccer:Ball\"";
    if (!is_offer && random_.chance(0.1)) return " concept=\"soccer:Ball or soccer:RobotFrame\"";
    std::string words = random_.chance(0.7) ? " concept=soccer:Ball" : " concept=soccer:TrackedObject";
    if (!is_offer && random_.chance(0.3)) return words;
    return words + " representation=soccer:" + frame();
  }
  std::string frame() {
    return one_of<7>(
        {"RobotPolar", "MyRobotPolar", "FieldPolar", "FieldCartesian", "RobotCartesian", "CameraPixels", "RobotFrame"});
  }

  void say(Module& one, std::map<std::uint32_t, std::string>& stated, const std::string& kind,
           const std::string& create, const std::string& change, std::uint32_t number) {
    const auto known = stated.find(number);
    if (known != stated.end() && random_.chance(0.15)) {
      world_.run_for(milliseconds(1));
      one.client->say(std::to_string(number) + ' ' + kind + " remove");
      world_.run_for(milliseconds(1));  // what was told before comes before the number is used again
      stated.erase(known);
    } else if (known != stated.end()) {
      one.client->say(std::to_string(number) + ' ' + kind + " modify" + change);
      known->second += " | " + change;
    } else {
      one.client->say(std::to_string(number) + ' ' + kind + " create" + create + change);
      stated.emplace(number, create + change);
    }
  }

  std::string conversion() {
    return " converts=soccer:" + frame() + ">soccer:" + frame() + " cost=" + std::to_string(1 + random_.below(4));
  }

  void offer(Module& one) {
    const auto number =
        static_cast<std::uint32_t>(1 + random_.below(std::array{4U, 10U, 40U}[std::to_underlying(crowd_)]));
    const std::string create = " mode=" + mode() + identity(true) + " port=" + std::to_string(5000 + number);
    std::string change;
    switch (random_.below(10)) {
      case 0:
        change = " priority=" + std::to_string(random_.below(3));
        break;
      case 1:
        change = " scope=" + one_of<6>({"\"\"", "host", "!host", "any", "robot1", "robot*/base,!robot3"});
        break;
      case 2:
        change =
            " for=" + one_of<4>({"\"\"", "\"name = ba*\"", "\"participant_name in (robot1, robot2)\"", "\"role = x\""});
        break;
      case 3:
        change = " protocol=" + one_of<2>({"udp", "tcp"});
        break;
      case 4:
      case 5:
        change = " rate=" + std::to_string(random_.below(5));
        break;
      case 6:
        change = " rate=" + std::to_string(random_.below(5)) + one_of<3>({"m", "cm", "Hz"});
        break;
      case 7:
        change = conversion();
        break;
      case 8:
        if (!one.offered.contains(number)) break;
        change = " port=" + std::to_string(6000 + random_.below(3));
        break;
      default:
        break;
    }
    if (crowd_ == Crowd::converting && random_.chance(0.5)) change = conversion();
    say(one, one.offered, "pub", create, change, number);
  }

  void ask(Module& one) {
    const auto number = static_cast<std::uint32_t>(101 + random_.below(3));
    const std::string create =
        " mode=" + mode() + identity(false) + (crowd_ == Crowd::converting ? " match=broader" : "");
    std::string change = crowd_ == Crowd::converting && !one.asked.contains(number) ? " convert=yes" : "";
    switch (change.empty() ? random_.below(14) : 14) {
      case 0:
      case 1:
        change = " limit=" + std::to_string(random_.below(crowd_ == Crowd::crowded ? 30 : 4));
        break;
      case 2:
      case 3:
        change = " convert=" + one_of<5>({"yes", "no", "1", "3", "11"});
        break;
      case 4:
        change = " favour=" + one_of<5>({"\"\"", "robot2", "robot1b,robot3/base", "robot3", "robot1/vision"});
        break;
      case 5:
      case 6:
        change = " prefer=" + one_of<5>({"\"\"", "\"rate desc\"", "\"rate asc by 2\"", "\"rate asc by 50 cm\"",
                                         "\"port desc by 2\""});
        break;
      case 7:
        change = " rank=" + one_of<4>({"\"\"", "degree", "prefer,degree", "distance,priority"});
        break;
      case 8:
        change = " scope=" + one_of<5>({"\"\"", "host", "!host", "robot2", "!robot1"});
        break;
      case 9:
        change = " protocol=" + one_of<3>({"\"\"", "tcp", "udp,tcp"});
        break;
      case 10:
        change = " match=" + one_of<5>({"exact", "equivalent", "narrower", "broader", "overlapping"});
        break;
      case 11:
        change = " where=" + one_of<4>({"\"\"", "\"rate >= 2\"", "\"rate < 3 m\"", "\"rate in (1, 2)\""});
        break;
      case 12:
        change = " provider=" + one_of<3>({"\"\"", "robot1,robot2", "robot3/base"});
        break;
      case 13:
        change = " role=" + one_of<2>({"x", "y"});
        break;
      default:
        break;
    }
    say(one, one.asked, "sub", create, change, number);
  }

  Crowd crowd_;
  World world_;
  base::Random& random_;
  std::vector<Host*> hosts_;
  std::vector<Module> clients_;
  bool must_expire_ = false;
  std::size_t pairs_ = 0;
};

TEST(Agreement, BothSidesSayTheSameWhenNothingChanges) {
  const std::uint64_t first = World::seed_or(1);
  std::size_t pairs = 0;
  for (std::uint64_t seed = first; seed < first + test::rounds(12U); ++seed) {
    const auto crowd = static_cast<Agreement::Crowd>(seed % 3);
    const Air air = seed % 4 == 0 ? Air{.loss = 0.2, .duplicate = 0.05, .longest_delay = milliseconds(50)} : Air{};
    Agreement agreement(seed, air, crowd);
    for (int round = 0; round < 20; ++round) {
      for (int i = 0; i < (crowd == Agreement::Crowd::mixed ? 6 : 60); ++i) agreement.step();
      ASSERT_EQ(agreement.difference(), "") << agreement.when() << ", round " << round;
    }
    pairs += agreement.pairs();
  }
  EXPECT_GT(pairs, test::rounds(500U));
}

}  // namespace
}  // namespace geminga::sim
