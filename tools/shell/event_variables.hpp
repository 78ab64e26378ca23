// An event as environment variables for a command.
#ifndef GEMINGA_SHELL_EVENT_VARIABLES_HPP
#define GEMINGA_SHELL_EVENT_VARIABLES_HPP

#include <boost/json/object.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::shell {

/// The names of the variables, for --help.
inline constexpr std::string_view exec_words =
    R"(With --exec nothing is printed: COMMAND runs by /bin/sh -c once an event, one after the other in the order of the events. What
comes from others never becomes part of COMMAND. The event is one line of JSON on its standard input, as --json prints it, and in
its environment, as far as it says so much:
  GEMINGA_EVENT, GEMINGA_REASON            add, modify or del; why it is gone
  GEMINGA_TIME                             when it was told here (RFC 3339, UTC)
  GEMINGA_SERVICE, GEMINGA_PROVIDER        geminga-subscribe: the service, and the peer that offers it
  GEMINGA_SUBSCRIPTION, GEMINGA_CONSUMER   geminga-publish: the request, and the peer that made it
  GEMINGA_NAME, GEMINGA_PARTICIPANT_NAME   the names of that peer and of its host
  GEMINGA_CONCEPT, GEMINGA_REPRESENTATION  the identity, where it is a concept,
  GEMINGA_TEXT, GEMINGA_ID                 a text, or a number
  GEMINGA_DEGREE, GEMINGA_DISTANCE         how well it matches
  GEMINGA_CONVERT, GEMINGA_COST            how its representation is converted
  GEMINGA_HOPS, GEMINGA_PATH               the relays on the way to that host
  GEMINGA_REACHABLE                        false where its address cannot be reached from here
  GEMINGA_MODE, GEMINGA_PROTOCOL, GEMINGA_ADDRESS, GEMINGA_PORT, GEMINGA_PRIORITY
  GEMINGA_ATTRIBUTE_rate                   its attribute rate; a name that no variable can have is in the JSON alone
Of other variables GEMINGA_... only GEMINGA_CONNECT is passed on: the daemon that this program talks to. Keep "$GEMINGA_NAME" in
double quotes, or the shell splits it at spaces.
A command that fails is told on standard error and changes nothing. One that runs longer than --exec-timeout is sent a SIGTERM,
and killed 2 s later. Ctrl-C and a SIGTERM reach the running command, too, and --timeout sends it a SIGTERM; events that wait
are dropped. --count and the daemon's end let the commands of all events that came run first. 4096 events may wait, and what comes
then stays with the daemon.)";

/// `GEMINGA_KEY=VALUE` for each number and text of an event, as to_json() gives it, and `GEMINGA_ATTRIBUTE_NAME=VALUE`
/// for each attribute whose name has only letters, digits and `_`. A value with an octet 0 is left out.
[[nodiscard]] std::vector<std::string> event_variables(const boost::json::object& event);

/// These variables, and this program's own environment without its variables GEMINGA_..., but with GEMINGA_CONNECT
/// (`connect`, unless empty).
[[nodiscard]] std::vector<std::string> environment_with(const std::vector<std::string>& variables,
                                                        const std::string& connect);

}  // namespace geminga::shell

#endif
