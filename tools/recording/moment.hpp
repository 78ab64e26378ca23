// Times of a recording as texts: RFC 3339, a time of day, or seconds from its beginning.
#ifndef GEMINGA_RECORDING_MOMENT_HPP
#define GEMINGA_RECORDING_MOMENT_HPP

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "recording/entry.hpp"

namespace geminga::recording {

/// Reads `2026-11-22T04:36:13.123Z`, with up to nine decimals or none; what is below a millisecond is cut. UTC only.
[[nodiscard]] std::optional<Time> parse_time(std::string_view text);

/// A moment of a recording that a user names.
struct TimeOfDay {
  std::chrono::milliseconds since_midnight{};  ///< UTC
};
using Moment = std::variant<At, TimeOfDay, Time>;

/// Reads seconds (`90`, `90.5`), `HH:MM` or `HH:MM:SS`, or RFC 3339.
[[nodiscard]] std::optional<Moment> parse_moment(std::string_view text);

/// Whether an entry is there by the moment, in a recording whose first entry is `first`. A time of day is the first
/// such time behind the beginning.
[[nodiscard]] bool has_come(const Entry& entry, const Moment& moment, const Entry& first);

/// `2 h 03 min`, `12 min 5 s` or `7.5 s`.
[[nodiscard]] std::string span_words(At span);

}  // namespace geminga::recording

#endif
