#include "query/top/screen.hpp"

#include <utf8.h>

#include <algorithm>

namespace geminga::query::top {
namespace {

std::string styled(const shell::Terminal& terminal, Style style, const std::string& text) {
  switch (style) {
    case Style::plain:
      return text;
    case Style::title:
      return coloured(terminal, shell::Colour::bold, text);
    case Style::dim:
      return coloured(terminal, shell::Colour::dim, text);
    case Style::warning:
      return coloured(terminal, shell::Colour::red, text);
    case Style::selected:
      return terminal.has_colour ? "\x1b[7m" + text + "\x1b[0m" : text;
  }
  return text;
}

}  // namespace

std::string cut(const std::string& text, std::size_t columns) {
  if (shell::width(text) <= columns) return text;
  if (columns == 0) return "";
  auto end = text.begin();
  utf8::advance(end, columns - 1, text.end());
  return std::string(text.begin(), end) + "…";
}

std::string Screen::show(const std::vector<Line>& lines, Size size, const shell::Terminal& terminal) {
  std::string out;
  if (!is_known_ || size != size_) {
    out += "\x1b[2J";
    shown_.assign(size.rows, {});
    size_ = size;
    is_known_ = true;
  }
  for (std::size_t row = 0; row < size.rows; ++row) {
    Line line = row < lines.size() ? lines[row] : Line{};
    // The last column stays free: a terminal may erase the character there with the rest of its line.
    line.text = cut(line.text, std::max<std::size_t>(size.columns, 1) - 1);
    if (line == shown_[row]) continue;
    out += "\x1b[" + std::to_string(row + 1) + ";1H" + styled(terminal, line.style, encoded(terminal, line.text)) +
           "\x1b[K";
    shown_[row] = std::move(line);
  }
  return out;
}

}  // namespace geminga::query::top
