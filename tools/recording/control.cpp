#include "recording/control.hpp"

#include <algorithm>
#include <cstdlib>

#include "base/text.hpp"
#include "recording/player.hpp"

namespace geminga::recording {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Whether `word` is the whole or the first letters of `whole`.
bool begins(std::string_view whole, std::string_view word) { return !word.empty() && whole.starts_with(word); }

std::expected<Control, std::string> unread(std::string_view line) {
  return std::unexpected(
      "'" + base::printable(line) +
      "' is no word for a replay: pause, play, speed X, seek TIME, +SECONDS, -SECONDS; an empty line "
      "pauses and plays");
}

}  // namespace

std::expected<Control, std::string> read_control(std::string_view line) {
  line = trimmed(line);
  if (line.empty()) return Toggle{};
  const auto end = std::min(line.find_first_of(" \t"), line.size());
  const std::string_view word = line.substr(0, end);
  const std::string_view rest = trimmed(line.substr(end));
  if (rest.empty() && (word.front() == '+' || word.front() == '-')) {
    const auto moment = parse_moment(word.substr(1));
    const auto* span = moment ? std::get_if<At>(&*moment) : nullptr;
    if (span == nullptr) return unread(line);
    return Skip{word.front() == '+' ? *span : -*span};
  }
  if (rest.empty() && word != "p" && begins("pause", word)) return Pause{};
  if (rest.empty() && word != "p" && begins("play", word)) return Play{};
  if (word != "s" && begins("speed", word)) {
    const std::string text(rest);
    char* behind = nullptr;
    const double speed = std::strtod(text.c_str(), &behind);
    if (text.empty() || *behind != '\0' || !(speed >= least_speed && speed <= most_speed)) {
      return std::unexpected("'" + base::printable(rest) + "' is no speed: write a number from 0.01 to 10000");
    }
    return SetSpeed{speed};
  }
  if (word != "s" && begins("seek", word)) {
    if (auto moment = parse_moment(rest)) return Seek{*moment};
    return std::unexpected(
        "'" + base::printable(rest) +
        "' is no moment: write seconds from the beginning, HH:MM or HH:MM:SS in UTC, or a whole time");
  }
  return unread(line);
}

}  // namespace geminga::recording
