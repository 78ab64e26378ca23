#include "shell/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>
#include <utf8.h>

#include <array>
#include <cstdlib>
#include <iterator>

namespace geminga::shell {
namespace {

bool is_set(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

}  // namespace

bool is_harmful(char32_t c) {
  const bool is_control = c < 0x20 || (c >= 0x7f && c < 0xa0);
  const bool turns_direction =
      c == 0x061c || c == 0x200e || c == 0x200f || (c >= 0x202a && c <= 0x202e) || (c >= 0x2066 && c <= 0x2069);
  const bool breaks_line = c == 0x2028 || c == 0x2029;
  return is_control || turns_direction || breaks_line;
}

std::string printable(std::string_view text) {
  std::string valid;
  utf8::replace_invalid(text.begin(), text.end(), std::back_inserter(valid));
  std::string harmless;
  for (auto at = valid.begin(); at != valid.end();) {
    const char32_t c = utf8::next(at, valid.end());
    utf8::append(is_harmful(c) ? U'\ufffd' : c, std::back_inserter(harmless));
  }
  return harmless;
}

std::size_t width(std::string_view text) { return static_cast<std::size_t>(utf8::distance(text.begin(), text.end())); }

std::string shortened(std::string_view text, std::size_t columns) {
  if (width(text) <= columns) return std::string(text);
  auto end = text.begin();
  utf8::advance(end, columns - 1, text.end());
  return std::string(text.begin(), end) + "…";
}

Terminal Terminal::of_standard_output() {
  Terminal terminal;
  terminal.is_terminal = isatty(STDOUT_FILENO) == 1;
  if (!terminal.is_terminal) return terminal;
  const char* kind = std::getenv("TERM");
  terminal.has_colour = !is_set("NO_COLOR") && kind != nullptr && std::string_view(kind) != "dumb";
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0) terminal.columns = size.ws_col;
  return terminal;
}

std::string coloured(const Terminal& terminal, Colour colour, std::string_view text) {
  static constexpr std::array<std::string_view, 5> codes{"\x1b[1m", "\x1b[2m", "\x1b[32m", "\x1b[33m", "\x1b[31m"};
  if (!terminal.has_colour) return std::string(text);
  return std::string(codes[static_cast<std::size_t>(colour)]) + std::string(text) + "\x1b[0m";
}

}  // namespace geminga::shell
