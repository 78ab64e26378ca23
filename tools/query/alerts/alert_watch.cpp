#include "query/alerts/alert_watch.hpp"

#include <algorithm>

namespace geminga::query::alerts {

std::optional<Happening> AlertWatch::counted(std::size_t rule, std::uint64_t count, base::Instant now) {
  const Rule& wanted = rules_.at(rule);
  Alert& alert = alerts_.at(rule);
  alert.count = count;
  alert.problem.clear();
  if (wanted.holds(count)) {
    const bool was_raised = alert.state == Alert::State::raised;
    const base::Duration lasted = alert.since ? now - *alert.since : base::Duration{};
    alert.state = Alert::State::holds;
    alert.since.reset();
    if (!was_raised) return std::nullopt;
    return Happening{.kind = Happening::Kind::cleared, .rule = rule, .count = count, .lasted = lasted};
  }
  if (!alert.since) alert.since = now;
  if (alert.state == Alert::State::raised) return std::nullopt;
  const base::Duration lasted = now - *alert.since;
  alert.state = lasted >= wanted.time ? Alert::State::raised : Alert::State::waits;
  if (alert.state != Alert::State::raised) return std::nullopt;
  return Happening{.kind = Happening::Kind::raised, .rule = rule, .count = count, .lasted = lasted};
}

std::optional<Happening> AlertWatch::not_counted(std::size_t rule, const std::string& problem) {
  Alert& alert = alerts_.at(rule);
  if (alert.state != Alert::State::raised) {
    alert.state = Alert::State::unknown;
    alert.since.reset();
  }
  if (alert.problem == problem) return std::nullopt;
  alert.problem = problem;
  return Happening{.kind = Happening::Kind::problem, .rule = rule, .problem = problem};
}

base::Instant AlertWatch::next_due() const {
  base::Instant due = base::never;
  for (std::size_t rule = 0; rule < alerts_.size(); ++rule) {
    if (alerts_[rule].state == Alert::State::waits) due = std::min(due, *alerts_[rule].since + rules_[rule].time);
  }
  return due;
}

}  // namespace geminga::query::alerts
