#include "scenarios/random_faults.hpp"

#include <algorithm>

namespace geminga::scenarios {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;

constexpr base::Duration calm = seconds(10);  ///< at either end of a run

/// The host, the beginning and the length of a fault.
class Draw {
 public:
  Draw(Script& script, base::Random& random, base::Duration time)
      : hosts_(script.participants()), random_(random), last_(std::max(calm + seconds(1), time - calm)) {}

  [[nodiscard]] base::Duration when() { return random_.between(calm, last_); }
  [[nodiscard]] std::size_t host() { return random_.below(hosts_); }
  [[nodiscard]] std::size_t other(std::size_t than) { return (than + 1 + random_.below(hosts_ - 1)) % hosts_; }
  [[nodiscard]] base::Duration short_time() { return random_.between(milliseconds(20), seconds(5)); }
  /// Short or long, each as often: what is shorter than a deadline is another matter than what is longer.
  [[nodiscard]] base::Duration time() {
    return random_.chance(0.5) ? short_time() : random_.between(seconds(5), seconds(40));
  }
  [[nodiscard]] bool coin() { return random_.chance(0.5); }
  [[nodiscard]] Lie lie() { return static_cast<Lie>(random_.below(lie_count)); }
  /// Some of the team, and never all.
  [[nodiscard]] Hosts part() {
    Hosts hosts;
    const std::size_t wanted = 1 + random_.below(std::max<std::size_t>(hosts_ / 2, 1));
    while (hosts.size() < wanted) {
      const std::size_t one = host();
      if (std::ranges::find(hosts, one) == hosts.end()) hosts.push_back(one);
    }
    std::ranges::sort(hosts);
    return hosts;
  }

 private:
  std::size_t hosts_;
  base::Random& random_;
  base::Duration last_;
};

void restart(Script& script, Draw& draw) {
  const base::Duration at = draw.when();
  const std::size_t host = draw.host();
  const base::Duration off = draw.time();
  switch (draw.coin() ? 2 : draw.coin() ? 1 : 0) {
    case 0:
      return script.leave(at, host, off);
    case 1:
      return script.restart(at, host, off, Memory::lost);
    default:
      return script.restart(at, host, off, Memory::kept);
  }
}

void sleep(Script& script, Draw& draw) {
  const base::Duration at = draw.when();
  const std::size_t host = draw.host();
  if (draw.coin()) return script.sleep(at, host, draw.time());
  script.stall(at, host, draw.time());
}

sim::Air random_air(base::Random& random) {
  sim::Air air;
  const double losses[] = {0, 0, 0.05, 0.1, 0.3, 0.3, 0.5};
  air.loss = losses[random.below(std::size(losses))];
  air.longest_delay = random.between(milliseconds(1), milliseconds(40));
  if (random.chance(0.3)) air.duplicate = 0.1;
  if (random.chance(0.3)) air.late = 0.05;
  if (random.chance(0.3)) air.burst = 0.1;
  air.burst_length = random.between(milliseconds(50), milliseconds(1500));
  return air;
}

}  // namespace

void write_faults(Script& script, base::Random& random, const Counts& counts, base::Duration time) {
  Draw draw(script, random, time);
  const bool has_others = script.participants() > 1;
  for (unsigned i = 0; i < counts.restarts; ++i) restart(script, draw);
  for (unsigned i = 0; i < counts.crashes; ++i) script.crash(draw.when(), draw.host());
  for (unsigned i = 0; i < counts.sleeps; ++i) sleep(script, draw);
  for (unsigned i = 0; i < counts.lies; ++i) script.lie(draw.when(), draw.lie(), draw.host());
  for (unsigned i = 0; i < counts.partitions && has_others; ++i) script.separate(draw.when(), draw.part(), draw.time());
  for (unsigned i = 0; i < counts.deaf && has_others; ++i) {
    const std::size_t deaf = draw.host();
    script.deafen(draw.when(), deaf, draw.other(deaf), draw.time());
  }
}

Conditions random_conditions(std::uint64_t seed) {
  base::Random random(seed ^ 0x6661756c7473U);
  Conditions conditions;
  conditions.seed = seed;
  conditions.participants = 2 + random.below(7);
  conditions.time = seconds(60 + static_cast<std::int64_t>(random.below(120)));
  conditions.air = random_air(random);
  conditions.changes_per_minute = static_cast<unsigned>(random.below(30));
  conditions.services = random.chance(0.3) ? 0 : 1 + random.below(4);
  if (random.chance(0.3)) conditions.drift = 1 + static_cast<std::int64_t>(random.below(2000));
  Counts counts;
  for (unsigned* count : {&counts.restarts, &counts.sleeps, &counts.partitions, &counts.deaf}) {
    *count = static_cast<unsigned>(random.below(4));
  }
  if (random.chance(0.2)) counts.crashes = 1;
  if (random.chance(0.2)) counts.lies = 1 + static_cast<unsigned>(random.below(4));
  const bool has_flips = random.chance(0.1);
  conditions.write = [counts, has_flips, time = conditions.time, air = conditions.air](Script& script,
                                                                                       base::Random& chance) {
    write_faults(script, chance, counts, time);
    if (!has_flips) return;
    sim::Air spoiled = air;
    spoiled.flip = 0.02;
    script.weather(time / 3, spoiled, "the air turns bits over", seconds(15));
  };
  return conditions;
}

}  // namespace geminga::scenarios
