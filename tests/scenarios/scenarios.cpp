#include "scenarios/scenarios.hpp"

#include <algorithm>
#include <vector>

#include "scenarios/script.hpp"

namespace geminga::scenarios {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;

/// All hosts from one to another, both included.
Hosts range(std::size_t first, std::size_t last) {
  Hosts hosts;
  for (std::size_t host = first; host <= last; ++host) hosts.push_back(host);
  return hosts;
}

/// The one access point of the field loses its power: nobody hears anybody for 20 s.
void access_point_dies(Script& script, base::Random&) {
  for (std::size_t host = 0; host < script.participants(); ++host) script.separate(minutes(2), {host}, seconds(20));
}

/// Half of the robots walk over to the other field, one by one, and come back by and by.
void handover(Script& script, base::Random& random) {
  for (std::size_t host = 0; host < script.participants() / 2; ++host) {
    script.separate(minutes(1) + seconds(10) * static_cast<int>(host), {host},
                    random.between(milliseconds(200), seconds(15)));
  }
}

/// A laptop in the pits is closed and opened again: its clock stands still, and nothing waits for it.
void lid_closed(Script& script, base::Random&) {
  script.sleep(minutes(1), 0, seconds(3));
  script.sleep(minutes(2), 0, minutes(1));
  script.sleep(minutes(4), 0, minutes(10));
}

/// A match of two halves on bad air, with a referee who takes robots out, a fall, and a battery that is changed.
void match_day(Script& script, base::Random& random) {
  script.leave(minutes(4), 2, seconds(30));
  script.restart(minutes(7), 4, seconds(12));
  script.separate(minutes(9), {1}, seconds(8));
  script.weather(minutes(10), {.loss = 0.5, .longest_delay = milliseconds(20)}, "everybody films: half of all is lost",
                 minutes(2));
  for (std::size_t host = 0; host < script.participants(); ++host) {
    script.restart(minutes(15) + random.between(seconds(0), seconds(5)), host, random.between(seconds(5), seconds(40)),
                   Memory::lost);
  }
  script.crash(minutes(22), 3);
}

/// Somebody in the hall sends without end: losses come in long bursts.
void noisy_neighbour(Script& script, base::Random&) {
  script.weather(minutes(1), {.loss = 0.1, .burst = 0.3, .burst_length = milliseconds(800)},
                 "a neighbour sends without end", minutes(3));
}

/// Every daemon is updated in turn while the team works.
void rolling_restart(Script& script, base::Random&) {
  for (std::size_t host = 0; host < script.participants(); ++host) {
    script.leave(minutes(1) + seconds(8) * static_cast<int>(host), host, milliseconds(400));
  }
}

/// A daemon dies again and again as soon as it has started.
void crash_loop(Script& script, base::Random&) {
  for (int i = 0; i < 20; ++i) script.restart(minutes(1) + seconds(4) * i, 1, milliseconds(500));
}

/// The switch loses power and the team falls apart into two halves for a minute.
void split(Script& script, base::Random&) {
  script.separate(minutes(1), range(0, script.participants() / 2 - 1), minutes(1));
}

/// One robot drives through a tunnel: first it hears less and less, then nothing, then all at once.
void tunnel(Script& script, base::Random&) {
  script.deafen(minutes(1), 0, 1, seconds(50));
  script.deafen(minutes(1) + seconds(3), 0, 2, seconds(47));
  script.separate(minutes(1) + seconds(10), {0}, seconds(40));
}

/// Somebody on the link says in the name of one robot whatever may hurt it.
void liar(Script& script, base::Random&) {
  for (std::size_t i = 0; i < 20; ++i) {
    script.lie(minutes(1) + seconds(20) * static_cast<int>(i), static_cast<Lie>(i % lie_count), 0);
  }
}

/// A daemon gets no processor for a while, because something else on its host takes all.
void overload(Script& script, base::Random&) {
  for (int i = 0; i < 6; ++i) script.stall(minutes(1) + seconds(30) * i, 2, seconds(2 << i));
}

Conditions conditions(std::size_t participants, base::Duration time, const sim::Air& air,
                      void (*write)(Script& script, base::Random& random)) {
  Conditions one;
  one.participants = participants;
  one.time = time;
  one.air = air;
  if (write != nullptr) one.write = write;
  return one;
}

std::vector<Scenario> make_all() {
  const sim::Air clean = {};
  const sim::Air field = {.loss = 0.05, .duplicate = 0.01, .longest_delay = milliseconds(10)};
  const sim::Air bad = {.loss = 0.3, .longest_delay = milliseconds(10)};
  return {
      {"access-point-dies", "nobody hears anybody for 20 s", conditions(8, minutes(4), field, access_point_dies)},
      {"crash-loop", "one daemon dies every 4 s, twenty times", conditions(8, minutes(4), field, crash_loop)},
      {"handover", "half of the team is out of reach, one robot after the other",
       conditions(8, minutes(4), field, handover)},
      {"half-deaf", "half of all datagrams are lost for ten minutes",
       conditions(10, minutes(10), {.loss = 0.5}, nullptr)},
      {"liar", "somebody forges a robot's announcements", conditions(6, minutes(9), clean, liar)},
      {"lid-closed", "one laptop sleeps for 3 s, 1 min and 10 min", conditions(8, minutes(16), field, lid_closed)},
      {"match-day", "a match of two halves on bad air", conditions(11, minutes(25), bad, match_day)},
      {"noisy-neighbour", "losses come in long bursts for 3 min", conditions(8, minutes(6), field, noisy_neighbour)},
      {"overload", "one daemon gets no processor for 2 to 64 s", conditions(8, minutes(6), field, overload)},
      {"rolling-restart", "every daemon is updated in turn", conditions(12, minutes(4), field, rolling_restart)},
      {"split", "the team falls into two halves for a minute", conditions(10, minutes(4), bad, split)},
      {"tunnel", "one robot is out of reach for 40 s, one way first", conditions(6, minutes(4), field, tunnel)},
  };
}

}  // namespace

std::span<const Scenario> all_scenarios() {
  static const std::vector<Scenario> all = make_all();
  return all;
}

const Scenario* find_scenario(std::string_view name) {
  const auto all = all_scenarios();
  const auto found = std::ranges::find(all, name, &Scenario::name);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace geminga::scenarios
