// An event as variables of the environment, for a command.
#ifndef GEMINGA_SHELL_EVENT_VARIABLES_HPP
#define GEMINGA_SHELL_EVENT_VARIABLES_HPP

#include <boost/json/object.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::shell {

/// How the variables are called, for --help.
inline constexpr std::string_view exec_words =
    R"(With --exec nothing is printed: COMMAND runs by /bin/sh -c once an event, one after the other in the order of the events. What
comes from others never becomes part of COMMAND. The event is one line of JSON on its standard input, as --json prints it, and in
its environment, where the event says so much:
  GEMINGA_EVENT             add, modify or del
  GEMINGA_REASON            why it is gone
  GEMINGA_TIME              when it was told here (RFC 3339, UTC)
  GEMINGA_SERVICE, GEMINGA_PROVIDER        a word for the service, PARTICIPANT/PEER (geminga-subscribe)
  GEMINGA_SUBSCRIPTION, GEMINGA_CONSUMER   a word for what consumes it, PARTICIPANT/PEER (geminga-publish)
  GEMINGA_NAME, GEMINGA_PARTICIPANT_NAME   the names of that peer and of its host
  GEMINGA_ID, GEMINGA_TEXT, GEMINGA_CONCEPT, GEMINGA_REPRESENTATION   the identity: a number, a text, or a concept
  GEMINGA_DEGREE, GEMINGA_DISTANCE         how well it matches
  GEMINGA_CONVERT, GEMINGA_COST            how its representation is converted, where it is
  GEMINGA_MODE, GEMINGA_PROTOCOL, GEMINGA_ADDRESS, GEMINGA_PORT, GEMINGA_PRIORITY
  GEMINGA_ATTRIBUTE_rate    its attribute rate; those whose name a variable cannot have are in the JSON alone
Other variables GEMINGA_... are not passed on, but for GEMINGA_CONNECT, which is the daemon that this program talks to. A command
that fails is told on standard error and changes nothing; one that runs too long (--exec-timeout) is sent a SIGTERM, and killed
2 s later. Ctrl-C, a SIGTERM and --timeout end it in the same way, and the program; events that wait are then dropped. --count and
the daemon's end let all events that came be run first. 4096 may wait; further ones stay with the daemon.)";

/// `GEMINGA_KEY=VALUE` for each number and text of an event, as to_json() gives it, and `GEMINGA_ATTRIBUTE_NAME=VALUE`
/// for each attribute whose name has only letters, digits and `_`. A value with an octet 0 is left out.
[[nodiscard]] std::vector<std::string> event_variables(const boost::json::object& event);

/// This program's own environment without its variables GEMINGA_..., but with GEMINGA_CONNECT (`connect`, where that is
/// not empty), and these.
[[nodiscard]] std::vector<std::string> environment_with(const std::vector<std::string>& variables,
                                                        const std::string& connect);

}  // namespace geminga::shell

#endif
