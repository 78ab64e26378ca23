#include "scenarios/simulation.hpp"

#include <algorithm>

#include "discovery/membership/schedule/deadline.hpp"
#include "scenarios/moment.hpp"
#include "scenarios/script.hpp"
#include "scenarios/tables.hpp"
#include "scenarios/traffic.hpp"
#include "scenarios/workload.hpp"
#include "sim/liar.hpp"
#include "sim/team.hpp"
#include "sim/world.hpp"

namespace geminga::scenarios {
namespace {

constexpr std::size_t most_violations = 100;
constexpr base::Duration step = std::chrono::milliseconds(100);
constexpr base::Duration progress_step = std::chrono::milliseconds(5);

base::Duration intervals(const Conditions& conditions, double count) {
  return std::chrono::duration_cast<base::Duration>(conditions.interval * count);
}

/// Views may show somebody who is gone until its deadline, which counts on a clock that may be slow, and for a little
/// longer where the viewer itself came late (ANNOUNCEMENT.md, "Deadlines").
sim::Bounds bounds(const Conditions& conditions) {
  const base::Duration longest = intervals(conditions, membership::longest_deadline);
  const base::Duration slow = longest / 1'000'000 * conditions.drift;
  return {.missing = agreement_bound(conditions), .surplus = longest + 2 * slow + std::chrono::milliseconds(2000)};
}

/// A line that sums up a period in which something happened.
class Narrator {
 public:
  Narrator(const sim::World& world, sim::Team& team, const Workload& workload, Tell tell)
      : world_(world), team_(team), workload_(workload), tell_(std::move(tell)) {}

  void say(const std::string& words) const {
    if (tell_) tell_(moment(world_.now().time_since_epoch()) + "  " + words);
  }
  void sum_up() {
    const auto& delays = team_.ledger().delays();
    const std::size_t departures = team_.false_departures().size();
    std::string words;
    const auto add = [&](const std::string& what) { words += (words.empty() ? "" : ", ") + what; };
    if (workload_.changes() > changes_) add(std::to_string(workload_.changes() - changes_) + " new services");
    add_quantile(words, "told", delays.told, told_);
    add_quantile(words, "withdrawn ones told", delays.withdrawn, withdrawn_);
    add_quantile(words, "deaths told", delays.crashed, crashed_);
    if (departures > departures_) add(std::to_string(departures - departures_) + " false departures");
    changes_ = workload_.changes();
    departures_ = departures;
    if (!words.empty()) say(words);
  }

 private:
  static void add_quantile(std::string& words, const std::string& what, const std::vector<base::Duration>& all,
                           std::size_t& seen) {
    if (all.size() > seen) {
      const std::vector<base::Duration> fresh(all.begin() + static_cast<std::ptrdiff_t>(seen), all.end());
      words += (words.empty() ? "" : ", ") + what + " to 95 % in " + in_words(quantile(fresh, 95));
    }
    seen = all.size();
  }

  const sim::World& world_;
  sim::Team& team_;
  const Workload& workload_;
  Tell tell_;
  std::size_t changes_ = 0;
  std::size_t told_ = 0;
  std::size_t withdrawn_ = 0;
  std::size_t crashed_ = 0;
  std::size_t departures_ = 0;
};

class Simulation {
 public:
  Simulation(const Conditions& conditions, const Tell& tell, const OnProgress& progress)
      : conditions_(conditions),
        script_(conditions.participants),
        world_(conditions.seed, conditions.air, [this](const std::string& complaint) { complain(complaint); }),
        team_(world_, bounds(conditions)),
        liar_(world_),
        workload_(world_, team_, conditions_),
        traffic_(world_),
        tables_(world_, team_),
        narrator_(world_, team_, workload_, tell),
        stage_{
            .world = world_, .team = team_, .liar = liar_, .usual = conditions.air, .interval = conditions.interval} {
    if (progress) world_.every(progress_step, [&] { progress(world_.now().time_since_epoch(), world_.datagrams()); });
  }

  Result run() {
    base::Random random(conditions_.seed ^ 0x7363726970740000U);
    if (conditions_.write) conditions_.write(script_, random);
    for (const Script::Step& one : script_.steps()) {
      world_.at(base::Instant(one.at), [this, one] {
        narrator_.say(one.words);
        one.act(stage_);
      });
    }
    if (!script_.is_empty()) team_.ledger().excuse_missing_until(base::Instant(script_.end()));
    workload_.start();
    agree();
    const base::Duration period = period_of(conditions_.time);
    const base::Instant end{std::max(conditions_.time, script_.end())};
    while (world_.now() < end) {
      const base::Instant next{(world_.now().time_since_epoch() / period + 1) * period};
      world_.run_for(std::min(next, end) - world_.now());
      narrator_.sum_up();
    }
    finish();
    return result();
  }

 private:
  void complain(const std::string& complaint) {
    if (violations_.size() == most_violations) violations_.emplace_back("and more");
    if (violations_.size() > most_violations) return;
    violations_.push_back(complaint);
    narrator_.say("VIOLATION " + complaint);
  }

  /// After the start, unless something goes wrong before.
  void agree() {
    const base::Duration bound = agreement_bound(conditions_);
    const base::Instant last{script_.is_empty() ? bound : std::min(bound, script_.steps().front().at)};
    while (world_.now() < last && (world_.now() < base::Instant(std::chrono::seconds(1)) || !team_.is_right())) {
      world_.run_for(step);
    }
    agreed_after_ = world_.now().time_since_epoch();
    if (team_.is_right()) narrator_.say("all " + std::to_string(conditions_.participants) + " know all");
  }

  /// Nothing changes any more, and what went wrong is over: now all must agree.
  void finish() {
    workload_.stop();
    const base::Instant over = world_.now();
    const base::Instant last = over + agreement_bound(conditions_);
    while (!team_.is_right() && world_.now() < last) world_.run_for(step);
    if (!team_.is_right()) {
      complain("agreement: not all views are right, " + world_.when() + "\n" + team_.complaints());
    } else if (world_.now() > over) {
      narrator_.say("all agree, " + in_words(world_.now() - over) + " after the end");
    }
    if (!violations_.empty()) return;
    world_.run_for(
        std::chrono::duration_cast<base::Duration>(conditions_.interval * (membership::longest_deadline + 2)));
    tables_.check_all();
  }

  /// A round number of which there are ten to thirty.
  static base::Duration period_of(base::Duration time) {
    for (const int count : {1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 3600}) {
      if (time / std::chrono::seconds(count) <= 30) return std::chrono::seconds(count);
    }
    return std::chrono::hours(6);
  }

  Result result() const {
    Result result;
    result.trace_hash = world_.trace_hash();
    result.violations = violations_;
    result.delays = team_.ledger().delays();
    result.never_told = team_.ledger().never_told();
    result.false_departures = team_.false_departures().size();
    result.events = team_.events();
    result.datagrams = world_.datagrams();
    result.octets = world_.datagram_bytes() + header_octets * world_.datagrams();
    result.simulated = world_.now().time_since_epoch();
    result.agreed_after = agreed_after_;
    result.participants = conditions_.participants;
    return result;
  }

  const Conditions& conditions_;
  std::vector<std::string> violations_;
  Script script_;
  sim::World world_;
  sim::Team team_;
  sim::Liar liar_;
  Workload workload_;
  Traffic traffic_;
  Tables tables_;
  Narrator narrator_;
  Stage stage_;
  base::Duration agreed_after_{};
};

}  // namespace

double Result::octets_per_host_second() const {
  const double seconds = std::chrono::duration<double>(simulated).count();
  return static_cast<double>(octets) / seconds / static_cast<double>(participants);
}

base::Duration agreement_bound(const Conditions& conditions) {
  return intervals(conditions, 8) + std::chrono::milliseconds(50) * static_cast<std::int64_t>(conditions.participants);
}

Result simulate(const Conditions& conditions, const Tell& tell, const OnProgress& progress) {
  return Simulation(conditions, tell, progress).run();
}

}  // namespace geminga::scenarios
