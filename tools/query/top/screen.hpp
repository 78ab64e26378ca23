// The lines on a terminal, of which only those that differ are written.
#ifndef GEMINGA_QUERY_TOP_SCREEN_HPP
#define GEMINGA_QUERY_TOP_SCREEN_HPP

#include <cstddef>
#include <string>
#include <vector>

#include "shell/terminal.hpp"

namespace geminga::query::top {

struct Size {
  std::size_t rows = 24;
  std::size_t columns = 80;
  friend bool operator==(const Size&, const Size&) = default;
};

enum class Style { plain, title, dim, warning, selected };

struct Line {
  std::string text;  ///< printable
  Style style = Style::plain;
  friend bool operator==(const Line&, const Line&) = default;
};

/// The text in at most so many columns, with an ellipsis where it was cut.
[[nodiscard]] std::string cut(const std::string& text, std::size_t columns);

/// Remembers what is shown. Uses the control sequences of ECMA-48 that every terminal knows: CUP, EL, ED, SGR.
class Screen {
 public:
  /// The octets that make the terminal show these lines, cut to its size; empty where it shows them already.
  [[nodiscard]] std::string show(const std::vector<Line>& lines, Size size, const shell::Terminal& terminal);
  /// Forgets what is shown: all is written again.
  void forget() { is_known_ = false; }

 private:
  std::vector<Line> shown_;
  Size size_{};
  bool is_known_ = false;
};

}  // namespace geminga::query::top

#endif
