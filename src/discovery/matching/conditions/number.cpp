#include "discovery/matching/conditions/number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>

#include "base/text.hpp"

namespace geminga::matching {
namespace {

std::size_t count_digits(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::find_if_not(text, [](char octet) { return octet >= '0' && octet <= '9'; }) - text.begin());
}

std::size_t sign_length(std::string_view text) { return text.starts_with('-') || text.starts_with('+') ? 1 : 0; }

/// The length of a part of a number: `before` octets with digits behind them; 0 where no digits follow.
std::size_t part_length(std::string_view text, std::size_t before) {
  const std::size_t digits = count_digits(text.substr(before));
  return digits == 0 ? 0 : before + digits;
}

std::string_view without_plus(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  return text;
}

}  // namespace

std::size_t number_length(std::string_view text) {
  std::size_t length = part_length(text, sign_length(text));
  if (length == 0) return 0;
  if (text.substr(length).starts_with('.')) {
    const std::size_t fraction = part_length(text.substr(length), 1);
    if (fraction == 0) return length;
    length += fraction;
  }
  const std::string_view rest = text.substr(length);
  if (rest.starts_with('e') || rest.starts_with('E')) length += part_length(rest, 1 + sign_length(rest.substr(1)));
  return length;
}

std::optional<double> number(std::string_view text) {
  if (text.empty() || number_length(text) != text.size()) return std::nullopt;
  const std::string_view digits = without_plus(text);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

double rounded(double value) {
  constexpr int digits_behind_the_first = 13;
  std::array<char, 32> octets{};
  const auto written = std::to_chars(octets.data(), octets.data() + octets.size(), value, std::chars_format::scientific,
                                     digits_behind_the_first);
  std::from_chars(octets.data(), written.ptr, value);
  return value;
}

std::partial_ordering compare_numbers(std::string_view a, std::string_view b) {
  const auto whole_a = base::parse_number<std::int64_t>(without_plus(a));
  const auto whole_b = base::parse_number<std::int64_t>(without_plus(b));
  if (whole_a && whole_b) return *whole_a <=> *whole_b;
  return number(a).value_or(0) <=> number(b).value_or(0);
}

}  // namespace geminga::matching
