// How a program says what went wrong, and with which exit status.
#ifndef GEMINGA_SHELL_REPORT_HPP
#define GEMINGA_SHELL_REPORT_HPP

#include <string_view>

#include "geminga/client.hpp"
#include "shell/exit_status.hpp"

namespace geminga::shell {

/// Prints `program: text` as one line on standard error.
void complain(std::string_view program, std::string_view text);

/// Says what went wrong. A name that the daemon does not know is wrong usage; what is not there is nothing found; a
/// daemon that is starting, stopping or overloaded counts as one that cannot be reached.
[[nodiscard]] ExitStatus report(std::string_view program, const ClientError& error);

/// The exit status of a program that has printed all it had to: `status`, or wrong_use where standard output could not
/// be written, after having said so.
[[nodiscard]] ExitStatus written(std::string_view program, ExitStatus status);

}  // namespace geminga::shell

#endif
