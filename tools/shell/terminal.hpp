// What may reach a terminal: harmless characters, and colour where it is wanted.
#ifndef GEMINGA_SHELL_TERMINAL_HPP
#define GEMINGA_SHELL_TERMINAL_HPP

#include <cstddef>
#include <string>
#include <string_view>

namespace geminga::shell {

/// Whether a terminal could obey this character: control characters (C0, DEL, C1), those that turn the direction of
/// writing, and those that end a line.
[[nodiscard]] bool is_harmful(char32_t character);

/// A text from the network as one harmless line: bad UTF-8 and harmful characters become U+FFFD.
[[nodiscard]] std::string printable(std::string_view text);

/// The columns that a printable text takes, one a character.
[[nodiscard]] std::size_t width(std::string_view text);

/// The width of a terminal that does not say how wide it is.
inline constexpr std::size_t usual_columns = 80;

/// How standard output is shown.
struct Terminal {
  bool is_terminal = false;
  bool has_colour = false;
  std::size_t columns = 0;  ///< 0: as wide as it takes
  bool has_utf8 = true;

  /// Standard output as it is. Colour only on a terminal, never with NO_COLOR (no-color.org) or TERM=dumb. A terminal
  /// is as wide as COLUMNS says, else as it says itself, else usual_columns; what is no terminal is as wide as it
  /// takes, so that scripts get every text whole, and always in UTF-8.
  [[nodiscard]] static Terminal of_standard_output();
};

/// A printable text for a terminal of another encoding than UTF-8: `~` for `…`, `?` for every other character beyond
/// ASCII.
[[nodiscard]] std::string encoded(const Terminal& terminal, std::string_view text);

enum class Colour { bold, dim, green, yellow, red };

/// The text in a colour, or as it is where there is none.
[[nodiscard]] std::string coloured(const Terminal& terminal, Colour colour, std::string_view text);

}  // namespace geminga::shell

#endif
