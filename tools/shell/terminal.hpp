// Texts for a terminal: harmless characters, and colour where it is wanted.
#ifndef GEMINGA_SHELL_TERMINAL_HPP
#define GEMINGA_SHELL_TERMINAL_HPP

#include <cstddef>
#include <string>
#include <string_view>

namespace geminga::shell {

/// Makes a text from the network one harmless line (base/harmless.hpp): bad UTF-8 and harmful characters become U+FFFD.
[[nodiscard]] std::string printable(std::string_view text);

/// The columns of a printable text, one for each character.
[[nodiscard]] std::size_t width(std::string_view text);

/// The width of a terminal that does not say how wide it is.
inline constexpr std::size_t usual_columns = 80;

/// The properties of standard output.
struct Terminal {
  bool is_terminal = false;
  bool has_colour = false;
  std::size_t columns = 0;  ///< 0: no limit
  bool has_utf8 = true;

  /// Asks standard output. Colour only on a terminal, never with NO_COLOR (no-color.org) or TERM=dumb. The width of a
  /// terminal is that in COLUMNS, else its own, else usual_columns. Other outputs have no limit, so that scripts get
  /// every text whole, and are always in UTF-8.
  [[nodiscard]] static Terminal of_standard_output();
};

/// Encodes a printable text for a terminal without UTF-8: `~` for `…`, `?` for every other character beyond ASCII.
[[nodiscard]] std::string encoded(const Terminal& terminal, std::string_view text);

enum class Colour { bold, dim, green, yellow, red };

/// The text in a colour, or as it is where there is none.
[[nodiscard]] std::string coloured(const Terminal& terminal, Colour colour, std::string_view text);

}  // namespace geminga::shell

#endif
