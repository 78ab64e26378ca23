// Breaks texts into lines that fit a terminal.
#ifndef GEMINGA_SHELL_WRAPPING_HPP
#define GEMINGA_SHELL_WRAPPING_HPP

#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "shell/terminal.hpp"

namespace geminga::shell {

/// Breaks a printable text into lines of at most `columns`: at a space, or behind a comma, semicolon or bar. Only a
/// word that is longer than a line is broken inside: behind one of `/ = @ #` where one is in the second half of the
/// line. Returns at least one line. Requires columns > 0.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view text, std::size_t columns);

/// The width of the longest part of a printable text that wrapped() keeps whole where it can.
[[nodiscard]] std::size_t longest_word(std::string_view text);

/// Prints a printable text in lines that begin with so many spaces and fit the terminal; in one line where it has no
/// limit.
void print_wrapped(std::ostream& out, const Terminal& terminal, std::string_view text, std::size_t indent = 0);

}  // namespace geminga::shell

#endif
