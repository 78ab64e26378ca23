#include "recording/moment.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "base/text.hpp"

namespace geminga::recording {
namespace {

using std::chrono::milliseconds;

/// The number that so many digits are, within these bounds.
std::optional<int> digits(std::string_view text, std::size_t count, int least, int most) {
  if (text.size() != count || text.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
  const auto number = base::parse_number<int>(text);
  if (!number || *number < least || *number > most) return std::nullopt;
  return number;
}

/// Reads `HH:MM` or `HH:MM:SS` with decimals.
std::optional<milliseconds> time_of_day(std::string_view text) {
  if (text.size() < 5 || text[2] != ':') return std::nullopt;
  const auto hour = digits(text.substr(0, 2), 2, 0, 23);
  const auto minute = digits(text.substr(3, 2), 2, 0, 59);
  if (!hour || !minute) return std::nullopt;
  const milliseconds whole = std::chrono::hours(*hour) + std::chrono::minutes(*minute);
  if (text.size() == 5) return whole;
  const auto second = text.size() < 8 || text[5] != ':' ? std::nullopt : digits(text.substr(6, 2), 2, 0, 59);
  if (!second) return std::nullopt;
  std::string_view decimals = text.substr(8);
  int thousandths = 0;
  if (!decimals.empty()) {
    if (decimals.front() != '.' || decimals.size() < 2 || decimals.size() > 10) return std::nullopt;
    decimals.remove_prefix(1);
    if (decimals.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
    const std::string padded = std::string(decimals) + "00";
    thousandths = digits(std::string_view(padded).substr(0, 3), 3, 0, 999).value_or(0);
  }
  return whole + std::chrono::seconds(*second) + milliseconds(thousandths);
}

/// The longest time from the beginning that a user may name: a year.
constexpr double longest_seconds = 366.0 * 24 * 3600;

}  // namespace

std::optional<Time> parse_time(std::string_view text) {
  if (text.size() < 20 || text[4] != '-' || text[7] != '-' || text[10] != 'T' || !text.ends_with('Z')) {
    return std::nullopt;
  }
  const auto year = digits(text.substr(0, 4), 4, 1970, 9999);
  const auto month = digits(text.substr(5, 2), 2, 1, 12);
  const auto day = digits(text.substr(8, 2), 2, 1, 31);
  const auto clock = time_of_day(text.substr(11, text.size() - 12));
  if (!year || !month || !day || !clock) return std::nullopt;
  const std::chrono::year_month_day date(std::chrono::year(*year), std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day)));
  if (!date.ok()) return std::nullopt;
  return std::chrono::sys_days(date) + *clock;
}

std::optional<Moment> parse_moment(std::string_view text) {
  if (const auto time = parse_time(text)) return *time;
  if (const auto clock = time_of_day(text)) return TimeOfDay{*clock};
  double seconds = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds, std::chars_format::fixed);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (!(seconds >= 0 && seconds <= longest_seconds)) return std::nullopt;
  return At(std::llround(seconds * 1000));
}

bool has_come(const Entry& entry, const Moment& moment, const Entry& first) {
  if (const auto* at = std::get_if<At>(&moment)) return entry.at <= *at;
  if (const auto* time = std::get_if<Time>(&moment)) return entry.time <= *time;
  Time wanted = std::chrono::floor<std::chrono::days>(first.time) + std::get<TimeOfDay>(moment).since_midnight;
  if (wanted < first.time) wanted += std::chrono::days(1);
  return entry.time <= wanted;
}

std::string span_words(At span) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(span).count();
  std::array<char, 64> text{};
  if (seconds >= 3600) {
    std::snprintf(text.data(), text.size(), "%lld h %02lld min", static_cast<long long>(seconds / 3600),
                  static_cast<long long>(seconds / 60 % 60));
  } else if (seconds >= 60) {
    std::snprintf(text.data(), text.size(), "%lld min %lld s", static_cast<long long>(seconds / 60),
                  static_cast<long long>(seconds % 60));
  } else {
    std::snprintf(text.data(), text.size(), "%.1f s", static_cast<double>(span.count()) / 1000);
  }
  return text.data();
}

}  // namespace geminga::recording
