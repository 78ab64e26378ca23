// The alerts of the rules that were given, looked at again and again.
#ifndef GEMINGA_WEB_SITE_ALERTING_HPP
#define GEMINGA_WEB_SITE_ALERTING_HPP

#include <boost/json/array.hpp>
#include <cstddef>
#include <vector>

#include "base/time.hpp"
#include "query/alerts/alert_watch.hpp"
#include "query/alerts/rules.hpp"
#include "web/asking/asker.hpp"
#include "web/site/exposition.hpp"

namespace geminga::web {

/// Neither copies nor moves. Not thread-safe.
class Alerting {
 public:
  /// Borrows the asker. Without rules it asks for nothing.
  Alerting(Asker& asker, std::vector<query::alerts::Rule> rules)
      : asker_(asker), rules_(std::move(rules)), watch_(rules_), is_asked_(rules_.size()) {}
  Alerting(const Alerting&) = delete;
  Alerting& operator=(const Alerting&) = delete;

  [[nodiscard]] bool has_rules() const { return !rules_.empty(); }
  /// Counts for each rule as of `now`, perhaps after it returns. A rule whose last question waits is left out.
  void look(base::Instant now);
  /// The state of each rule, in the order of the file.
  [[nodiscard]] boost::json::array document() const;
  /// `geminga_alert`, 1 for what is raised; `geminga_alert_count`, the last count; `geminga_alerts_raised`, since the
  /// start.
  [[nodiscard]] std::vector<Family> families() const;

 private:
  void take(std::size_t rule, const Outcome& outcome, base::Instant now);

  Asker& asker_;
  const std::vector<query::alerts::Rule> rules_;
  query::alerts::AlertWatch watch_;
  std::vector<bool> is_asked_;                                                     ///< by rule: its question waits
  base::Instant looked_{};                                                         ///< the last look
  std::vector<std::uint64_t> raised_ = std::vector<std::uint64_t>(rules_.size());  ///< by rule, since the start
};

}  // namespace geminga::web

#endif
