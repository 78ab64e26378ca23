// The alerts of a team: which rules do not hold, for how long, and what changes.
#ifndef GEMINGA_QUERY_ALERTS_ALERT_WATCH_HPP
#define GEMINGA_QUERY_ALERTS_ALERT_WATCH_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/time.hpp"
#include "query/alerts/rules.hpp"

namespace geminga::query::alerts {

/// The state of one rule.
struct Alert {
  enum class State : std::uint8_t {
    unknown,  ///< it was not counted yet, or the last count failed before any
    holds,
    waits,   ///< its count is wrong, not yet for its time
    raised,  ///< its count has been wrong for its time
  };
  State state = State::unknown;
  std::optional<std::uint64_t> count;    ///< the last one
  std::optional<base::Instant> since{};  ///< since when its count is wrong
  std::string problem{};                 ///< why the last look gave no count; empty where it did
  friend bool operator==(const Alert&, const Alert&) = default;
};

/// A change of an alert.
struct Happening {
  enum class Kind : std::uint8_t { raised, cleared, problem };
  Kind kind = Kind::raised;
  std::size_t rule = 0;     ///< its place in the file
  std::uint64_t count = 0;  ///< of raised and cleared
  base::Duration lasted{};  ///< how long the count has been, or was, wrong
  std::string problem{};    ///< of a problem: why nothing was counted
  friend bool operator==(const Happening&, const Happening&) = default;
};

/// Decides by counts alone, without clock and sockets. The world is closed on purpose: what this daemon does not know
/// counts as not there, which a reasoner must not say and an operator wants to hear. A look that gives no count (the
/// daemon is gone, a name is unknown) changes no alert, and the time of a rule that waits begins anew behind it. Not
/// thread-safe.
class AlertWatch {
 public:
  /// Borrows the rules for its life.
  explicit AlertWatch(const std::vector<Rule>& rules) : rules_(rules), alerts_(rules.size()) {}

  /// A look at one rule at this instant gave this count. Gives what changed.
  [[nodiscard]] std::optional<Happening> counted(std::size_t rule, std::uint64_t count, base::Instant now);
  /// A look at one rule gave none. Gives the problem where it is another than that of the last look.
  [[nodiscard]] std::optional<Happening> not_counted(std::size_t rule, const std::string& problem);
  /// Something may be raised then although nothing changes; base::never: nothing waits.
  [[nodiscard]] base::Instant next_due() const;

  [[nodiscard]] const std::vector<Alert>& alerts() const { return alerts_; }

 private:
  const std::vector<Rule>& rules_;
  std::vector<Alert> alerts_;  ///< in the order of the rules
};

}  // namespace geminga::query::alerts

#endif
