// Alerts as lines and as JSON.
#ifndef GEMINGA_QUERY_ALERTS_WORDS_HPP
#define GEMINGA_QUERY_ALERTS_WORDS_HPP

#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "query/alerts/alert_watch.hpp"
#include "query/alerts/rules.hpp"

namespace geminga::query::alerts {

[[nodiscard]] std::string_view to_string(Happening::Kind kind);
[[nodiscard]] std::string_view to_string(Alert::State state);

/// `raised ball: 0 services are soccer:BallInfo, wanted are at least 1: for 3.0 s`
[[nodiscard]] std::string line(const Rule& rule, const Happening& happening);
/// `event` is raised, cleared or problem; `alert` the name of the rule.
[[nodiscard]] boost::json::object to_json(const Rule& rule, const Happening& happening);
/// The state of each rule, in their order.
[[nodiscard]] boost::json::array to_json(const std::vector<Rule>& rules, const std::vector<Alert>& alerts,
                                         base::Instant now);

}  // namespace geminga::query::alerts

#endif
