#include "web/site/alerting.hpp"

#include <string>

#include "query/alerts/words.hpp"

namespace geminga::web {

void Alerting::look(base::Instant now) {
  looked_ = now;
  for (std::size_t rule = 0; rule < rules_.size(); ++rule) {
    if (is_asked_[rule]) continue;
    is_asked_[rule] = true;
    const auto& question = rules_[rule].question;
    asker_.ask({question.kind, question.parameters},
               [this, rule, now](const Outcome& outcome) { take(rule, outcome, now); });
  }
}

void Alerting::take(std::size_t rule, const Outcome& outcome, base::Instant now) {
  is_asked_[rule] = false;
  const auto happening = outcome->has_value() ? watch_.counted(rule, outcome->value().records.size(), now)
                                              : watch_.not_counted(rule, outcome->error().text);
  if (happening && happening->kind == query::alerts::Happening::Kind::raised) ++raised_[rule];
}

boost::json::array Alerting::document() const { return query::alerts::to_json(rules_, watch_.alerts(), looked_); }

std::vector<Family> Alerting::families() const {
  Family raised{"geminga_alert", Family::Type::gauge, "", "Whether a rule does not hold, and has not for its time"};
  Family counts{"geminga_alert_count", Family::Type::gauge, "", "What a rule counted last"};
  Family times{"geminga_alerts_raised", Family::Type::counter, "", "Times that an alert was raised"};
  for (std::size_t rule = 0; rule < rules_.size(); ++rule) {
    const query::alerts::Alert& alert = watch_.alerts()[rule];
    const Labels labels{{"alert", rules_[rule].name}};
    raised.samples.push_back({labels, alert.state == query::alerts::Alert::State::raised ? "1" : "0"});
    if (alert.count) counts.samples.push_back({labels, std::to_string(*alert.count)});
    times.samples.push_back({labels, std::to_string(raised_[rule])});
  }
  return {std::move(raised), std::move(counts), std::move(times)};
}

}  // namespace geminga::web
