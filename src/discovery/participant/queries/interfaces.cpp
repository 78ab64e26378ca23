// `query interfaces` and `query peers`: the interfaces of a participant, and the peers on its host.
#include <algorithm>
#include <optional>

#include "base/text.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/queries.hpp"

namespace geminga::participant {
namespace {

InterfaceCounters counters_of(const Air& air, env::InterfaceIndex index) {
  const auto& all = air.counters().interfaces;
  const auto found = all.find(index);
  return found == all.end() ? InterfaceCounters{} : found->second;
}

}  // namespace

Answer answer_interfaces(const env::Env& env, Air& air) {
  Answer answer{.kind = "interfaces", .lines = {}, .end = {}};
  const auto& interfaces = env.interfaces();
  for (const env::Interface& interface : interfaces) {
    if (interface.ipv6_side_of) continue;
    InterfaceCounters counters = counters_of(air, interface.index);
    const auto ipv6_side = std::ranges::find(interfaces, std::optional(interface.index), &env::Interface::ipv6_side_of);
    if (ipv6_side != interfaces.end()) {
      const InterfaceCounters there = counters_of(air, ipv6_side->index);
      counters.sent += there.sent;
      counters.received += there.received;
    }
    Line line;
    append(line, "name", interface.name);
    append_flag(line, "loopback", interface.is_loopback);
    append_stated(line, "addresses", base::joined(interface.addresses, ","));
    append(line, "sent", counters.sent);
    append(line, "received", counters.received);
    if (const auto heard = env.last_heard(interface.index)) append(line, "quiet", seconds(env.now() - *heard));
    if (ipv6_side != interfaces.end()) append(line, "ipv6", air.speaks_on(*ipv6_side) ? "spoken" : "silent");
    answer.lines.push_back(std::move(line));
  }
  for (const std::string& name : env.ignored_interfaces()) {
    Line line;
    append(line, "name", name);
    append_flag(line, "ignored", true);
    answer.lines.push_back(std::move(line));
  }
  return answer;
}

Answer answer_peers(const Sessions& sessions) {
  Answer answer{.kind = "peers", .lines = {}, .end = {}};
  for (const Session* session : sessions.peers()) {
    Line line;
    append(line, "peer", static_cast<std::uint32_t>(session->peer()));
    append(line, "name", session->name);
    append_stated(line, "user", session->user);
    append(line, "publications", session->services.publications.size());
    append(line, "subscriptions", session->services.subscriptions.size());
    append(line, "statements", session->statements);
    answer.lines.push_back(std::move(line));
  }
  return answer;
}

}  // namespace geminga::participant
