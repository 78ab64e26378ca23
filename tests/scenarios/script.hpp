// The script of a run: what goes wrong and when, as a list of steps that a scenario writes in plain words.
#ifndef GEMINGA_TESTS_SCENARIOS_SCRIPT_HPP
#define GEMINGA_TESTS_SCENARIOS_SCRIPT_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/time.hpp"
#include "sim/air.hpp"
#include "sim/liar.hpp"
#include "sim/team.hpp"
#include "sim/world.hpp"

namespace geminga::scenarios {

/// Hosts by their place in the team, from 0.
using Hosts = std::vector<std::size_t>;

/// Where a step acts.
struct Stage {
  sim::World& world;
  sim::Team& team;
  sim::Liar& liar;
  const sim::Air usual;  ///< the air when nothing is wrong with it
  base::Duration interval;

  [[nodiscard]] sim::Host& host(std::size_t index) const { return *world.hosts().at(index); }
};

/// How a participant that was killed comes back.
enum class Memory : std::uint8_t {
  kept,  ///< its modules offer again what they offered, at the same ports
  lost,  ///< its modules are new programs at other ports
};

/// A lie of an attacker who hears everything and speaks in the name of others.
enum class Lie : std::uint8_t {
  goodbye,   ///< that it leaves
  emptied,   ///< that it offers nothing any more
  moved,     ///< that its services are elsewhere
  repeated,  ///< everything that it has said so far, from another address
  reborn,    ///< that its identifier belongs to another incarnation
};
inline constexpr std::size_t lie_count = 5;

/// Times count from the start of the run. Each function enters a step, or two where something lasts and is over again.
class Script {
 public:
  explicit Script(std::size_t participants) : participants_(participants) {}
  [[nodiscard]] std::size_t participants() const { return participants_; }

  void crash(base::Duration at, std::size_t host);
  /// The daemon is killed and started again after a while.
  void restart(base::Duration at, std::size_t host, base::Duration off, Memory memory = Memory::kept);
  /// It says goodbye and comes back after a while.
  void leave(base::Duration at, std::size_t host, base::Duration off);
  /// The computer sleeps: its clock stands still and nothing waits for it.
  void sleep(base::Duration at, std::size_t host, base::Duration lasts);
  /// The daemon gets no processor; datagrams wait for it.
  void stall(base::Duration at, std::size_t host, base::Duration lasts);
  /// These hear each other and nobody else, nor does anybody else hear them.
  void separate(base::Duration at, const Hosts& hosts, base::Duration lasts);
  /// One host does not hear another one, which hears it.
  void deafen(base::Duration at, std::size_t deaf, std::size_t unheard, base::Duration lasts);
  /// The air is another one for a while. Two at a time are not meant to be.
  void weather(base::Duration at, const sim::Air& air, const std::string& words, base::Duration lasts);
  void lie(base::Duration at, Lie lie, std::size_t victim);

  struct Step {
    base::Duration at;
    std::string words;
    std::function<void(Stage&)> act;
  };
  /// In the order of their times; at one time as they were entered.
  [[nodiscard]] std::vector<Step> steps() const;
  [[nodiscard]] bool is_empty() const { return steps_.empty(); }
  /// When all is over and mended.
  [[nodiscard]] base::Duration end() const { return end_; }

 private:
  void add(base::Duration at, std::string words, std::function<void(Stage&)> act);

  std::size_t participants_;
  std::vector<Step> steps_;
  base::Duration end_{};
  int islands_ = 0;
};

}  // namespace geminga::scenarios

#endif
