#include "scenarios/command_line.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <cmath>

#include "base/text.hpp"
#include "discovery/announcement/limits.hpp"
#include "scenarios/random_faults.hpp"
#include "scenarios/scenarios.hpp"

namespace geminga::scenarios {
namespace {

constexpr std::size_t most_participants = announcement::max_participants + 1;  // each may know all others
constexpr double most_minutes = 7 * 24 * 60;

/// A number in the fewest digits that are read as the same number.
std::string decimal(double number) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  return {digits.data(), end};
}

/// A check of a flag: a number from `least` to `most`.
CLI::Validator between(double least, double most) {
  return CLI::Validator(
      [least, most](std::string& text) {
        double read = 0;
        const bool is_read = CLI::detail::lexical_cast(text, read);
        return is_read && read >= least && read <= most
                   ? std::string()
                   : "'" + text + "' is no number from " + decimal(least) + " to " + decimal(most);
      },
      decimal(least) + ".." + decimal(most));
}

double number(const std::string& flag, std::string_view text, double least, double most) {
  double read = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read);
  const bool is_read = !text.empty() && error == std::errc() && end == text.data() + text.size();
  if (is_read && read >= least && read <= most) return read;
  throw CLI::ValidationError(
      flag, "'" + std::string(text) + "' is no number from " + decimal(least) + " to " + decimal(most));
}

/// "30%" or "0.3".
double share(const std::string& flag, std::string_view text) {
  if (text.empty()) return 0;
  if (!text.ends_with('%')) return number(flag, text, 0, 0.95);
  return number(flag, text.substr(0, text.size() - 1), 0, 95) / 100;
}

base::Duration milliseconds(double count) {
  return std::chrono::microseconds(static_cast<std::int64_t>(std::llround(count * 1000)));
}

}  // namespace

void Flags::add_to(CLI::App& app) {
  app.add_option("--scenario", scenario, "A named scenario; see --list")->type_name("NAME");
  app.add_flag("--list", is_list, "List the scenarios and exit");
  app.add_option("--participants", participants, "The number of participants")
      ->type_name("N")
      ->check(CLI::Range(1UL, most_participants));
  app.add_option("--sites", sites, "Simulate so many sites that know each other by summaries, instead of one team")
      ->type_name("N")
      ->check(CLI::Range(1UL, 10'000UL));
  app.add_option("--minutes", minutes, "Simulated time")->type_name("M")->check(between(0.1, most_minutes));
  app.add_option("--seed", seed, "The seed of all random decisions (default: 1)")->type_name("N");
  app.add_option("--seeds", seeds, "Run all of these seeds until one finds something")->type_name("A..B");
  app.add_option("--threads", threads, "With --seeds: how many at once (default: the number of processors)")
      ->type_name("N");
  app.add_option("--services", services, "Publications of a participant (default: those of a robot of the paper)")
      ->type_name("N")
      ->check(CLI::Range(0UL, 200UL));
  app.add_option("--changes", changes, "New services in the team in a minute (default: 6)")
      ->type_name("N")
      ->check(CLI::Range(0U, 6000U));
  app.add_option("--interval", interval, "Time between two announcements (default: 2)")
      ->type_name("SECONDS")
      ->check(between(0.05, 60.0));
  app.add_option("--loss", loss, "Share of datagrams that each receiver misses, e.g. 30%")->type_name("SHARE");
  app.add_option("--burst", burst,
                 "Share of the time in which a receiver hears nothing, and how long a burst takes, e.g. 10%x300")
      ->type_name("SHARE[xMS]");
  app.add_option("--duplicate", duplicate, "Share of datagrams that come twice")->type_name("SHARE");
  app.add_option("--late", late, "Share of datagrams that later ones overtake, by up to 150 ms")->type_name("SHARE");
  app.add_option("--flip", flip, "Share of datagrams in which one to eight bits are flipped")->type_name("SHARE");
  app.add_option("--delay", delay, "Least and longest time on the air (default: 0.2..2)")->type_name("MS..MS");
  app.add_option("--drift", drift, "Clocks run fast or slow by up to so many millionths")
      ->type_name("PPM")
      ->check(between(0.0, 50'000.0));
  app.add_option("--restarts", counts.restarts, "Daemons that are killed and started again")->type_name("N");
  app.add_option("--crashes", counts.crashes, "Daemons that are killed for good")->type_name("N");
  app.add_option("--sleeps", counts.sleeps, "Hosts that sleep or get no processor for a while")->type_name("N");
  app.add_option("--partitions", counts.partitions, "Times that a part of the team is cut off")->type_name("N");
  app.add_option("--one-way", counts.deaf, "Times that one host does not hear another one that hears it")
      ->type_name("N");
  app.add_option("--lies", counts.lies, "Forged datagrams in the name of others")->type_name("N");
  app.add_flag("--faults", has_random_faults, "A small team, an air and faults of all kinds that the seed chooses");
  app.add_flag(
      "--start", is_start,
      "Switch the team on at one instant, and measure until all know all; with --seeds: print how that is spread");
  app.add_option("--spread", spread, "With --start: the milliseconds within which the daemons begin")
      ->type_name("MS")
      ->check(between(0.0, 60'000.0));
  app.add_flag("--json", is_json, "Print one JSON document");
  app.add_flag("--quiet", is_quiet, "Print the table only");
}

Conditions Flags::conditions() const {
  Conditions conditions;
  conditions.seed = seed;
  if (!scenario.empty()) {
    const Scenario* found = find_scenario(scenario);
    if (found == nullptr) {
      throw CLI::ValidationError("--scenario", "there is no '" + scenario + "': see tools/simulate --list");
    }
    conditions = found->conditions;
    conditions.name = scenario;
    conditions.seed = seed;
  } else if (has_random_faults) {
    conditions = random_conditions(seed);
  } else if (counts.restarts + counts.crashes + counts.sleeps + counts.partitions + counts.deaf + counts.lies > 0) {
    conditions.write = [counts = counts, minutes = minutes.value_or(10)](Script& script, base::Random& random) {
      write_faults(script, random, counts, milliseconds(minutes * 60'000));
    };
  }
  if (participants) conditions.participants = *participants;
  if (minutes) conditions.time = milliseconds(*minutes * 60'000);
  if (services != 0) conditions.services = services;
  if (changes) conditions.changes_per_minute = *changes;
  if (interval) conditions.interval = milliseconds(*interval * 1000);
  conditions.start_spread = milliseconds(spread);
  if (drift > 0) conditions.drift = static_cast<std::int64_t>(drift);
  if (!loss.empty()) conditions.air.loss = share("--loss", loss);
  if (!burst.empty()) {
    const std::size_t x = burst.find('x');
    conditions.air.burst = share("--burst", std::string_view(burst).substr(0, x));
    if (x != std::string::npos)
      conditions.air.burst_length = milliseconds(number("--burst", std::string_view(burst).substr(x + 1), 1, 60'000));
  }
  if (!duplicate.empty()) conditions.air.duplicate = share("--duplicate", duplicate);
  if (!late.empty()) conditions.air.late = share("--late", late);
  if (!flip.empty()) conditions.air.flip = share("--flip", flip);
  if (!delay.empty()) {
    const std::size_t dots = delay.find("..");
    const std::string_view text = delay;
    conditions.air.longest_delay =
        milliseconds(number("--delay", dots == std::string::npos ? text : text.substr(dots + 2), 0, 150));
    conditions.air.shortest_delay = dots == std::string::npos
                                        ? conditions.air.longest_delay
                                        : milliseconds(number("--delay", text.substr(0, dots), 0, 150));
    if (conditions.air.shortest_delay > conditions.air.longest_delay) {
      throw CLI::ValidationError("--delay", "the first time is the shorter one");
    }
  }
  return conditions;
}

std::optional<Seeds> Flags::range() const {
  if (seeds.empty()) return std::nullopt;
  const std::size_t dots = seeds.find("..");
  const std::string_view text = seeds;
  const auto first = base::parse_number<std::uint64_t>(text.substr(0, dots));
  const auto last = dots == std::string::npos ? first : base::parse_number<std::uint64_t>(text.substr(dots + 2));
  if (!first || !last || *first > *last) throw CLI::ValidationError("--seeds", "'" + seeds + "' is not like 1..10000");
  return Seeds{.first = *first, .last = *last};
}

std::string Flags::replay(std::uint64_t one) const {
  std::string command = "tools/simulate --seed " + std::to_string(one);
  const auto word = [&](const std::string& flag, const std::string& value) {
    if (!value.empty()) command += " " + flag + " " + value;
  };
  const auto count = [&](const std::string& flag, std::uint64_t value) {
    if (value != 0) word(flag, std::to_string(value));
  };
  const auto decimal = [&](const std::string& flag, std::optional<double> value) {
    char text[40] = {};
    if (value) word(flag, std::string(text, std::to_chars(text, text + sizeof text, *value).ptr));
  };
  word("--scenario", scenario);
  if (has_random_faults) command += " --faults";
  if (is_start) command += " --start";
  if (participants) count("--participants", *participants);
  decimal("--minutes", minutes);
  count("--services", services);
  if (changes) word("--changes", std::to_string(*changes));
  decimal("--interval", interval);
  word("--loss", loss);
  word("--burst", burst);
  word("--duplicate", duplicate);
  word("--late", late);
  word("--flip", flip);
  word("--delay", delay);
  if (spread > 0) decimal("--spread", spread);
  if (drift > 0) decimal("--drift", drift);
  count("--restarts", counts.restarts);
  count("--crashes", counts.crashes);
  count("--sleeps", counts.sleeps);
  count("--partitions", counts.partitions);
  count("--one-way", counts.deaf);
  count("--lies", counts.lies);
  return command;
}

}  // namespace geminga::scenarios
