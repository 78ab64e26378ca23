// Who else speaks under our identifier, since when, and when that is worth a line in the log.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_CONTEST_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_CONTEST_HPP

#include <cstdint>
#include <optional>
#include <string>

#include "base/time.hpp"

namespace geminga::participant {

/// A contest is over when nothing was heard of it for so long.
inline constexpr base::Duration contest_quiet = std::chrono::seconds(30);
/// While it goes on, it is told so often.
inline constexpr base::Duration contest_reminder = std::chrono::seconds(60);

/// One contest at a time: all that others say in our name until it is quiet.
class Contest {
 public:
  /// Something was heard, `from` where. Whether to say so in the log now.
  [[nodiscard]] bool hear(const std::string& from, base::Instant now);
  /// Whether the contest that went on has ended now; said once for each.
  [[nodiscard]] bool has_ended(base::Instant now);

  /// When the present one began; nothing: there is none.
  [[nodiscard]] std::optional<base::Instant> since() const { return since_; }
  /// What was heard in it, and where the last came from.
  [[nodiscard]] std::uint64_t heard() const { return heard_; }
  [[nodiscard]] const std::string& from() const { return from_; }

 private:
  std::optional<base::Instant> since_;
  base::Instant last_{};
  base::Instant told_{};
  std::uint64_t heard_ = 0;
  std::string from_;
};

}  // namespace geminga::participant

#endif
