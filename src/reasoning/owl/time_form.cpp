// Fields are cut out by position and checked one by one.
#include "reasoning/owl/time_form.hpp"

#include <algorithm>
#include <array>

namespace geminga::owl {
namespace {

bool is_digit(char character) { return character >= '0' && character <= '9'; }

/// The number that two digits write.
int two_digits(std::string_view text) { return (text[0] - '0') * 10 + (text[1] - '0'); }

/// Whether the text has the pattern's signs, and a digit wherever the pattern has 0.
bool is_like(std::string_view text, std::string_view pattern) {
  return text.size() == pattern.size() && std::ranges::equal(text, pattern, [](char given, char wanted) {
           return wanted == '0' ? is_digit(given) : given == wanted;
         });
}

/// [-] (([1-9] digit digit digit+) / ("0" digit digit digit))
bool is_year(std::string_view year) {
  if (year.starts_with('-')) year.remove_prefix(1);
  return year.size() >= 4 && std::ranges::all_of(year, is_digit) && (year.size() == 4 || year[0] != '0');
}

/// In the proleptic Gregorian calendar. The last four digits suffice, because 10000 is a multiple of 400.
bool is_leap(std::string_view year) {
  const std::string_view last = year.substr(year.size() - 4);
  const int number = two_digits(last) * 100 + two_digits(last.substr(2));
  return number % 4 == 0 && (number % 100 != 0 || number % 400 == 0);
}

bool is_day(std::string_view year, int month, int day) {
  static constexpr std::array<int, 12> days = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  if (month < 1 || month > 12 || day < 1) return false;
  return day <= days[static_cast<std::size_t>(month - 1)] + (month == 2 && is_leap(year) ? 1 : 0);
}

/// "Z" / ("+" / "-") hh:mm, up to 14:00. An empty text is no zone.
bool is_zone(std::string_view zone) {
  if (zone.empty() || zone == "Z") return true;
  if (!is_like(zone, "+00:00") && !is_like(zone, "-00:00")) return false;
  const int hours = two_digits(zone.substr(1));
  const int minutes = two_digits(zone.substr(4));
  return minutes < 60 && (hours < 14 || (hours == 14 && minutes == 0));
}

}  // namespace

std::optional<std::string> canonical_time(std::string_view text, bool& is_exact) {
  constexpr std::string_view pattern = "-00-00T00:00:00";
  const std::size_t year_end = text.find('-', 1);
  if (year_end == std::string_view::npos || text.size() < year_end + pattern.size()) return std::nullopt;
  const std::string_view year = text.substr(0, year_end);
  const std::string_view moment = text.substr(year_end, pattern.size());
  if (!is_year(year) || !is_like(moment, pattern)) return std::nullopt;
  if (!is_day(year, two_digits(moment.substr(1)), two_digits(moment.substr(4)))) return std::nullopt;

  std::string_view zone = text.substr(year_end + pattern.size());
  std::string_view fraction;
  if (zone.starts_with('.')) {
    const std::size_t end = std::min(zone.find_first_not_of("0123456789", 1), zone.size());
    if (end == 1) return std::nullopt;
    fraction = zone.substr(0, end);
    zone.remove_prefix(end);
    while (fraction.ends_with('0')) fraction.remove_suffix(1);
    if (fraction == ".") fraction = {};
  }
  const bool is_midnight = moment.ends_with("24:00:00") && fraction.empty();
  const bool is_in_day =
      two_digits(moment.substr(7)) < 24 && two_digits(moment.substr(10)) < 60 && two_digits(moment.substr(13)) < 60;
  if ((!is_in_day && !is_midnight) || !is_zone(zone)) return std::nullopt;
  is_exact = !is_midnight;
  if (zone == "+00:00" || zone == "-00:00") zone = "Z";
  return (std::string(year) += moment).append(fraction).append(zone);
}

}  // namespace geminga::owl
