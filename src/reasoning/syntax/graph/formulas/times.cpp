#include "reasoning/syntax/graph/formulas/times.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "base/text.hpp"
#include "reasoning/owl/datatypes.hpp"

namespace geminga::graph {
namespace {

constexpr std::int64_t most_zone_seconds = std::int64_t{14} * 3600;

/// Takes digits from the front: at least so many, and exactly so many unless it is a year.
std::optional<std::int64_t> take_digits(std::string_view& text, std::size_t count, bool is_year = false) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
  if (end < count || (end > count && !is_year) || end > 9) return std::nullopt;
  const auto number = base::parse_number<std::int64_t>(text.substr(0, end));
  text.remove_prefix(end);
  return number;
}

bool take(std::string_view& text, char wanted) {
  if (!text.starts_with(wanted)) return false;
  text.remove_prefix(1);
  return true;
}

bool take_date(std::string_view& text, Instant& instant) {
  const bool is_negative = take(text, '-');
  const auto year = take_digits(text, 4, true);
  if (!year || !take(text, '-')) return false;
  const auto month = take_digits(text, 2);
  if (!month || !take(text, '-')) return false;
  const auto day = take_digits(text, 2);
  if (!day) return false;
  instant.year = is_negative ? -*year : *year;
  instant.month = static_cast<int>(*month);
  instant.day = static_cast<int>(*day);
  if (*year > 30'000) return false;  // the calendar of the standard library ends at 32767
  const std::chrono::year_month_day date{std::chrono::year(static_cast<int>(instant.year)),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  return date.ok();
}

bool take_time(std::string_view& text, Instant& instant) {
  const auto hours = take_digits(text, 2);
  if (!hours || !take(text, ':')) return false;
  const auto minutes = take_digits(text, 2);
  if (!minutes || !take(text, ':')) return false;
  const std::string_view rest = text;
  const auto seconds = take_digits(text, 2);
  if (!seconds || *seconds > 59 || *minutes > 59 || *hours > 23) return false;
  if (take(text, '.')) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
    if (end == 0) return false;
    text.remove_prefix(end);
  }
  instant.hours = static_cast<int>(*hours);
  instant.minutes = static_cast<int>(*minutes);
  instant.seconds = rest.substr(0, rest.size() - text.size());
  return true;
}

bool take_zone(std::string_view& text, Instant& instant) {
  instant.written_zone = text;
  if (text.empty()) return true;
  instant.zone = 0;
  if (take(text, 'Z')) return text.empty();
  const bool is_west = text.starts_with('-');
  if (!take(text, '-') && !take(text, '+')) return false;
  const auto hours = take_digits(text, 2);
  if (!hours || !take(text, ':')) return false;
  const auto minutes = take_digits(text, 2);
  if (!minutes || *minutes > 59 || *hours * 60 + *minutes > 14 * 60 || !text.empty()) return false;
  instant.zone = static_cast<int>((*hours * 60 + *minutes) * (is_west ? -1 : 1));
  return true;
}

}  // namespace

std::int64_t Instant::local_seconds() const {
  const std::chrono::sys_days days{std::chrono::year_month_day{std::chrono::year(static_cast<int>(year)),
                                                               std::chrono::month(static_cast<unsigned>(month)),
                                                               std::chrono::day(static_cast<unsigned>(day))}};
  const std::int64_t whole = base::parse_number<std::int64_t>(std::string_view(seconds).substr(0, 2)).value_or(0);
  return std::int64_t{days.time_since_epoch().count()} * 86'400 + std::int64_t{hours} * 3600 +
         std::int64_t{minutes} * 60 + whole;
}

std::int64_t Instant::nanoseconds() const {
  if (seconds.size() < 4) return 0;
  std::string digits = seconds.substr(3, 9);
  digits.resize(9, '0');
  return base::parse_number<std::int64_t>(digits).value_or(0);
}

std::optional<Instant> instant_of(const Node& node) {
  constexpr std::string_view xsd = owl::xsd_namespace;
  const std::string_view type = node.datatype;
  if (node.kind != Node::Kind::literal || !type.starts_with(xsd)) return std::nullopt;
  Instant instant;
  instant.is_date = type.substr(xsd.size()) == "date";
  const bool has_time = type.substr(xsd.size()) == "dateTime" || type.substr(xsd.size()) == "dateTimeStamp";
  if (!instant.is_date && !has_time) return std::nullopt;
  std::string_view text = node.text;
  if (!take_date(text, instant)) return std::nullopt;
  if (has_time && (!take(text, 'T') || !take_time(text, instant))) return std::nullopt;
  if (!take_zone(text, instant)) return std::nullopt;
  return instant;
}

std::partial_ordering compare(const Instant& a, const Instant& b) {
  if (a.is_date != b.is_date) return std::partial_ordering::unordered;
  const std::int64_t first = a.local_seconds() - std::int64_t{a.zone.value_or(0)} * 60;
  const std::int64_t second = b.local_seconds() - std::int64_t{b.zone.value_or(0)} * 60;
  if (a.zone.has_value() != b.zone.has_value() && std::abs(first - second) <= most_zone_seconds)
    return std::partial_ordering::unordered;
  if (first != second) return first <=> second;
  return a.nanoseconds() <=> b.nanoseconds();
}

}  // namespace geminga::graph
