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

int last_day(std::string_view year, int month) {
  static constexpr std::array<int, 12> days = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  return days[static_cast<std::size_t>(month - 1)] + (month == 2 && is_leap(year) ? 1 : 0);
}

bool is_day(std::string_view year, int month, int day) {
  return month >= 1 && month <= 12 && day >= 1 && day <= last_day(year, month);
}

/// The year after this one: 10000 after 9999, and 0000 after -0001.
std::string year_after(std::string_view year) {
  const bool is_before_zero = year.starts_with('-');
  if (is_before_zero) year.remove_prefix(1);
  // Its digits count up, or down to zero.
  const char last = is_before_zero ? '0' : '9';
  std::string digits(year);
  std::size_t at = digits.size();
  while (at > 0 && digits[at - 1] == last) digits[--at] = is_before_zero ? '9' : '0';
  if (at == 0) return '1' + digits;
  digits[at - 1] = static_cast<char>(digits[at - 1] + (is_before_zero ? -1 : 1));
  if (digits.size() > 4 && digits.starts_with('0')) digits.erase(0, 1);
  return is_before_zero && digits != "0000" ? '-' + digits : digits;
}

/// The begin of the day after this one, of the month and day in `moment`. May change the year.
std::string midnight_after(std::string& year, std::string_view moment) {
  int month = two_digits(moment.substr(1));
  int day = two_digits(moment.substr(4)) + 1;
  if (day > last_day(year, month)) {
    day = 1;
    ++month;
  }
  if (month > 12) {
    month = 1;
    year = year_after(year);
  }
  const auto written = [](int number) { return (number < 10 ? "0" : "") + std::to_string(number); };
  return '-' + written(month) + '-' + written(day) + "T00:00:00";
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

std::optional<std::string> canonical_time(std::string_view text) {
  constexpr std::string_view pattern = "-00-00T00:00:00";
  const std::size_t year_end = text.find('-', 1);
  if (year_end == std::string_view::npos || text.size() < year_end + pattern.size()) return std::nullopt;
  std::string year(text.substr(0, year_end));
  std::string moment(text.substr(year_end, pattern.size()));
  if (!is_year(year) || !is_like(moment, pattern)) return std::nullopt;
  if (year == "-0000") year = "0000";
  const std::string_view fields = moment;
  if (!is_day(year, two_digits(fields.substr(1)), two_digits(fields.substr(4)))) return std::nullopt;

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
      two_digits(fields.substr(7)) < 24 && two_digits(fields.substr(10)) < 60 && two_digits(fields.substr(13)) < 60;
  if ((!is_in_day && !is_midnight) || !is_zone(zone)) return std::nullopt;
  if (is_midnight) moment = midnight_after(year, moment);
  if (zone == "+00:00" || zone == "-00:00") zone = "Z";
  return (year + moment).append(fraction).append(zone);
}

}  // namespace geminga::owl
