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
    R"(With --exec nothing is printed. Each event runs COMMAND by /bin/sh -c, one after the other, in the order of the events. Text from
other hosts never becomes part of COMMAND. The event is one line of JSON on the command's standard input, as --json prints it. The
values that it has are also environment variables:
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
  GEMINGA_ATTRIBUTE_rate                   its attribute rate; an attribute whose name no variable can have is in the JSON alone
Of other variables GEMINGA_... only GEMINGA_CONNECT is passed on: the daemon that this program talks to. Keep "$GEMINGA_NAME" in
double quotes, or the shell splits it at spaces.
A command that fails is reported on standard error, and the next event runs as usual. One that runs longer than --exec-timeout gets
a SIGTERM, and is killed 2 s later. Ctrl-C, a SIGTERM and the end of --timeout reach the running command as a SIGTERM, and waiting
events are dropped. After --count events, or when the daemon goes, the commands of all events that came still run.
4096 events may wait; the daemon keeps those that come then.)";

/// `GEMINGA_KEY=VALUE` for each number and text of an event, as to_json() gives it, and `GEMINGA_ATTRIBUTE_NAME=VALUE`
/// for each attribute whose name has only letters, digits and `_`. A value with an octet 0 is left out.
[[nodiscard]] std::vector<std::string> event_variables(const boost::json::object& event);

/// These variables, and this program's own environment without its variables GEMINGA_..., but with GEMINGA_CONNECT
/// (`connect`, unless empty).
[[nodiscard]] std::vector<std::string> environment_with(const std::vector<std::string>& variables,
                                                        const std::string& connect);

}  // namespace geminga::shell

#endif
