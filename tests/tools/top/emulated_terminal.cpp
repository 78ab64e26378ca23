#include "tools/top/emulated_terminal.hpp"

#include <algorithm>
#include <utility>

#include "base/text.hpp"

namespace geminga::tools {

void EmulatedTerminal::obey(std::string_view sequence) {
  const char last = sequence.back();
  if (sequence == "?1049h" || sequence == "?1049l") {
    is_other_screen_ = last == 'h';
  } else if (sequence == "?25h" || sequence == "?25l") {
    has_cursor_ = last == 'h';
  } else if (sequence == "2J") {
    std::ranges::fill(rows_, "");
  } else if (sequence.ends_with(";1H")) {
    row_ = base::parse_number<std::size_t>(sequence.substr(0, sequence.size() - 3)).value_or(1) - 1;
    if (row_ >= rows_.size()) unknown_ += std::string(sequence) + " leaves the screen\n";
    row_ = std::min(row_, rows_.size() - 1);
    rows_[row_].clear();  // the program always writes a whole row
  } else if (last != 'm' && sequence != "K") {
    unknown_ += std::string(sequence) + '\n';
  }
}

void EmulatedTerminal::take(std::string_view octets) {
  const std::string text = std::exchange(begun_, "") + std::string(octets);
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] != '\x1b') {
      rows_[row_] += text[at];
      continue;
    }
    const auto end = std::find_if(text.begin() + static_cast<std::ptrdiff_t>(std::min(at + 2, text.size())), text.end(),
                                  [](char c) { return c >= 0x40 && c <= 0x7e; });
    if (end == text.end()) {
      begun_ = text.substr(at);
      return;
    }
    const auto behind = static_cast<std::size_t>(end - text.begin()) + 1;
    obey(std::string_view(text).substr(at + 2, behind - at - 2));
    at = behind - 1;
  }
}

std::string EmulatedTerminal::text() const {
  std::string text;
  for (const std::string& row : rows_) text += row.substr(0, row.find_last_not_of(' ') + 1) + '\n';
  return text;
}

}  // namespace geminga::tools
