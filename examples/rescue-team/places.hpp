// How the soccer team reads places of the rescue team: the conversions that the alignment names.
#ifndef GEMINGA_EXAMPLES_RESCUE_TEAM_PLACES_HPP
#define GEMINGA_EXAMPLES_RESCUE_TEAM_PLACES_HPP

#include <cmath>
#include <cstddef>
#include <iomanip>
#include <numbers>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// The middle of the field as the rescue team's map has it: metres to the east and to the north of its pole.
inline constexpr double field_east = 1;
inline constexpr double field_north = 1;

/// Two numbers in a line of text, as both teams write a place.
struct Pair {
  double first = 0;
  double second = 0;
};

inline std::string text_of(std::span<const std::byte> payload) {
  return {reinterpret_cast<const char*>(payload.data()), payload.size()};
}

/// Throws if the numbers are missing: the library then drops the message and counts it.
inline Pair read(std::span<const std::byte> payload) {
  std::istringstream line(text_of(payload));
  Pair pair;
  if (!(line >> pair.first >> pair.second)) throw std::invalid_argument("two numbers are needed");
  return pair;
}

inline std::vector<std::byte> write(const Pair& pair) {
  std::ostringstream line;
  line << std::fixed << std::setprecision(2) << pair.first << ' ' << pair.second;
  const std::string text = line.str();
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

inline std::vector<std::byte> map_of_bearing(std::span<const std::byte> payload) {
  const auto [range, bearing] = read(payload);
  const double angle = bearing * std::numbers::pi / 180;
  return write({range * std::sin(angle), range * std::cos(angle)});
}

inline std::vector<std::byte> field_of_map(std::span<const std::byte> payload) {
  const auto [east, north] = read(payload);
  return write({east - field_east, north - field_north});
}

#endif
