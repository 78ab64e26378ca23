#include "shell/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>
#include <utf8.h>

#include <array>
#include <cstdlib>

#include "base/harmless.hpp"
#include "base/text.hpp"

namespace geminga::shell {
namespace {

/// The value of an environment variable; nothing where it is not set.
std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : value;
}

/// The widest terminal. A greater value of COLUMNS is a mistake, and would cost memory for spaces.
constexpr std::size_t most_columns = 10'000;

/// The number in COLUMNS, or 0 where it is none or too great.
std::size_t columns_of_the_environment() {
  const std::size_t columns = base::parse_number<std::size_t>(variable("COLUMNS")).value_or(0);
  return columns <= most_columns ? columns : 0;
}

/// Whether the name of the user's locale says UTF-8. Without a name UTF-8 is assumed, as terminals do.
bool locale_has_utf8() {
  for (const char* category : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const std::string name = base::in_lower_case(variable(category));
    if (!name.empty()) return name.contains("utf-8") || name.contains("utf8");
  }
  return true;
}

}  // namespace

std::string printable(std::string_view text) { return base::harmless(text); }

std::size_t width(std::string_view text) { return static_cast<std::size_t>(utf8::distance(text.begin(), text.end())); }

Terminal Terminal::of_standard_output() {
  Terminal terminal;
  terminal.is_terminal = isatty(STDOUT_FILENO) == 1;
  if (!terminal.is_terminal) return terminal;
  const char* kind = std::getenv("TERM");
  terminal.has_colour = variable("NO_COLOR").empty() && kind != nullptr && std::string_view(kind) != "dumb";
  terminal.has_utf8 = locale_has_utf8();
  winsize size{};
  terminal.columns = columns_of_the_environment();
  if (terminal.columns == 0 && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0) terminal.columns = size.ws_col;
  if (terminal.columns == 0) terminal.columns = usual_columns;
  return terminal;
}

std::string encoded(const Terminal& terminal, std::string_view text) {
  if (terminal.has_utf8) return std::string(text);
  std::string ascii;
  for (auto at = text.begin(); at != text.end();) {
    const char32_t c = utf8::next(at, text.end());
    ascii += c < 0x80 ? static_cast<char>(c) : c == U'…' ? '~' : '?';
  }
  return ascii;
}

std::string coloured(const Terminal& terminal, Colour colour, std::string_view text) {
  static constexpr std::array<std::string_view, 5> codes{"\x1b[1m", "\x1b[2m", "\x1b[32m", "\x1b[33m", "\x1b[31m"};
  if (!terminal.has_colour) return std::string(text);
  return std::string(codes[static_cast<std::size_t>(colour)]) + std::string(text) + "\x1b[0m";
}

}  // namespace geminga::shell
