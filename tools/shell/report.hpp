// Errors on standard error, and their exit statuses.
#ifndef GEMINGA_SHELL_REPORT_HPP
#define GEMINGA_SHELL_REPORT_HPP

#include <string_view>

#include "geminga/client.hpp"
#include "shell/exit_status.hpp"

namespace geminga::shell {

/// Prints `program: text` as one line on standard error.
void complain(std::string_view program, std::string_view text);

/// Prints an error of the client and returns its exit status. A name that the daemon does not know is wrong usage; an
/// unknown request is nothing found; a daemon that is starting, stopping or overloaded counts as one that cannot be
/// reached.
[[nodiscard]] ExitStatus report(std::string_view program, const ClientError& error);

/// The exit status of a program that has printed everything: `status`. Where standard output could not be written, says
/// so and returns wrong_use.
[[nodiscard]] ExitStatus written(std::string_view program, ExitStatus status);

}  // namespace geminga::shell

#endif
