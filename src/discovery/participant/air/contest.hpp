// A contest: others announce under our identifier. Says since when, and when that is worth a line in the log.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_CONTEST_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_CONTEST_HPP

#include <cstdint>
#include <optional>
#include <string>

#include "base/time.hpp"

namespace geminga::participant {

/// A contest is over when nothing of it was heard for this time.
inline constexpr base::Duration contest_quiet = std::chrono::seconds(30);
/// While a contest goes on, the log gets a line at this interval.
inline constexpr base::Duration contest_reminder = std::chrono::seconds(60);

/// One contest at a time: all that others say in our name until nothing is heard of it for contest_quiet.
class Contest {
 public:
  /// A datagram of it was heard from `from`. Gives whether to write that into the log now.
  [[nodiscard]] bool hear(const std::string& from, base::Instant now);
  /// Whether the contest has ended; true once for each.
  [[nodiscard]] bool has_ended(base::Instant now);

  /// The beginning of the present contest; nothing: there is none.
  [[nodiscard]] std::optional<base::Instant> since() const { return since_; }
  /// The number of datagrams in it, and the address of the last.
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
