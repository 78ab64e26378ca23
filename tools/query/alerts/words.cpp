#include "query/alerts/words.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>

namespace geminga::query::alerts {
namespace {

double seconds(base::Duration duration) { return std::chrono::duration<double>(duration).count(); }

std::string shown_seconds(base::Duration duration) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f s", seconds(duration));
  return text;
}

std::string_view counted_kind(const Rule& rule) {
  return rule.question.kind == "participants" ? "participants" : "services";
}

void add_rule(boost::json::object& object, const Rule& rule) {
  object["counted"] = counted_kind(rule);
  object["of"] = counted_words(rule);
  object["at_least"] = rule.at_least;
  if (rule.at_most) object["at_most"] = *rule.at_most;
  object["for"] = seconds(rule.time);
}

}  // namespace

std::string_view to_string(Happening::Kind kind) {
  switch (kind) {
    case Happening::Kind::raised:
      return "raised";
    case Happening::Kind::cleared:
      return "cleared";
    case Happening::Kind::problem:
      break;
  }
  return "problem";
}

std::string_view to_string(Alert::State state) {
  switch (state) {
    case Alert::State::unknown:
      return "unknown";
    case Alert::State::holds:
      return "holds";
    case Alert::State::waits:
      return "waits";
    case Alert::State::raised:
      break;
  }
  return "raised";
}

std::string line(const Rule& rule, const Happening& happening) {
  const std::string beginning = std::string(to_string(happening.kind)) + ' ' + rule.name + ": ";
  if (happening.kind == Happening::Kind::problem) return beginning + happening.problem;
  return beginning + std::to_string(happening.count) + ' ' + std::string(counted_kind(rule)) + " (" +
         counted_words(rule) + "), wanted " + (rule.at_most == 0 ? "is " : "are ") + wanted_words(rule) +
         (happening.kind == Happening::Kind::raised ? ": wrong for " : ": was wrong for ") +
         shown_seconds(happening.lasted);
}

boost::json::object to_json(const Rule& rule, const Happening& happening) {
  boost::json::object object{{"event", to_string(happening.kind)}, {"alert", rule.name}};
  add_rule(object, rule);
  if (happening.kind == Happening::Kind::problem) {
    object["problem"] = happening.problem;
  } else {
    object["count"] = happening.count;
    object["seconds"] = std::round(seconds(happening.lasted) * 1000) / 1000;
  }
  return object;
}

boost::json::array to_json(const std::vector<Rule>& rules, const std::vector<Alert>& alerts, base::Instant now) {
  boost::json::array all;
  for (std::size_t at = 0; at < rules.size(); ++at) {
    const Alert& alert = alerts[at];
    boost::json::object object{{"alert", rules[at].name}, {"state", to_string(alert.state)}};
    add_rule(object, rules[at]);
    if (alert.count) object["count"] = *alert.count;
    if (alert.since) object["seconds"] = std::round(seconds(now - *alert.since) * 1000) / 1000;
    if (!alert.problem.empty()) object["problem"] = alert.problem;
    all.push_back(std::move(object));
  }
  return all;
}

}  // namespace geminga::query::alerts
