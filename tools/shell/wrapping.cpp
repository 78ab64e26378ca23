#include "shell/wrapping.hpp"

#include <algorithm>
#include <utility>

namespace geminga::shell {
namespace {

/// The characters behind which a text may be broken, as at a space.
constexpr std::string_view separators = ",;|";

/// The characters behind which a word may be broken that is longer than a line.
constexpr std::string_view joints = "/=@#";

/// The first `columns` characters of a printable text, and the rest.
std::pair<std::string_view, std::string_view> split(std::string_view text, std::size_t columns) {
  std::size_t at = 0;
  for (std::size_t count = 0; at < text.size() && count < columns; ++count) {
    ++at;
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0U) == 0x80U) ++at;
  }
  return {text.substr(0, at), text.substr(at)};
}

/// The octets of the text that the first line takes, where the whole does not fit.
std::size_t end_of_line(std::string_view text, std::size_t columns) {
  const auto [line, behind] = split(text, columns);
  // A space may be the first character that does not fit, since it is not printed.
  if (behind.starts_with(' ')) return line.size();
  const auto space = line.rfind(' ');
  const auto separator = line.find_last_of(separators);
  std::size_t end = space == std::string_view::npos ? 0 : space;
  if (separator != std::string_view::npos) end = std::max(end, separator + 1);
  if (end > 0) return end;
  const auto joint = line.find_last_of(joints);
  return joint != std::string_view::npos && joint + 1 >= line.size() / 2 ? joint + 1 : line.size();
}

}  // namespace

std::vector<std::string> wrapped(std::string_view text, std::size_t columns) {
  std::vector<std::string> lines;
  while (width(text) > columns) {
    const std::size_t end = end_of_line(text, columns);
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  }
  if (!text.empty() || lines.empty()) lines.emplace_back(text);
  return lines;
}

std::size_t longest_word(std::string_view text) {
  std::size_t longest = 0;
  while (!text.empty()) {
    const auto end = std::min(text.find_first_of(std::string(separators) + ' '), text.size());
    const bool is_separated = end < text.size() && text[end] != ' ';
    longest = std::max(longest, width(text.substr(0, end)) + (is_separated ? 1 : 0));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return longest;
}

void print_wrapped(std::ostream& out, const Terminal& terminal, std::string_view text, std::size_t indent) {
  const bool has_limit = terminal.columns > 2 * indent;
  for (const std::string& line :
       has_limit ? wrapped(text, terminal.columns - indent) : std::vector{std::string(text)}) {
    out << std::string(indent, ' ') << encoded(terminal, line) << '\n';
  }
}

}  // namespace geminga::shell
