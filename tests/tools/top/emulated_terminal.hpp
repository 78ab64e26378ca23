// A terminal of a few lines that understands what geminga-query top writes, and nothing else.
#ifndef GEMINGA_TESTS_TOOLS_TOP_EMULATED_TERMINAL_HPP
#define GEMINGA_TESTS_TOOLS_TOP_EMULATED_TERMINAL_HPP

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::tools {

/// Takes CUP, EL, ED, SGR and the modes 25 and 1049, in whatever pieces they come.
class EmulatedTerminal {
 public:
  explicit EmulatedTerminal(std::size_t rows) : rows_(rows) {}

  void take(std::string_view octets);
  /// The rows, without spaces at their ends, each with a line end.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool is_other_screen() const { return is_other_screen_; }
  [[nodiscard]] bool has_cursor() const { return has_cursor_; }
  /// Sequences that it does not know; empty: none came.
  [[nodiscard]] const std::string& unknown() const { return unknown_; }
  void resize(std::size_t rows) { rows_.assign(rows, ""); }

 private:
  void obey(std::string_view sequence);

  std::vector<std::string> rows_;
  std::size_t row_ = 0;
  std::string begun_;
  std::string unknown_;
  bool is_other_screen_ = false;
  bool has_cursor_ = true;
};

}  // namespace geminga::tools

#endif
