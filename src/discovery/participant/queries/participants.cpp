// `query participants`: everybody who is known, ourselves among them.
#include <algorithm>

#include "base/text.hpp"
#include "discovery/participant/knowledge/naming.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/queries.hpp"
#include "discovery/participant/queries/ways.hpp"

namespace geminga::participant {
namespace {

std::string addresses_of(const membership::Neighbour& neighbour) {
  std::vector<std::string> addresses;
  for (const membership::Path& path : neighbour.paths) {
    for (const std::string& address : path.addresses) {
      if (std::ranges::find(addresses, address) == addresses.end()) addresses.push_back(address);
    }
  }
  return base::joined(addresses, ",");
}

Line ourselves(const env::Env& env, const Self& self, base::Duration interval, std::uint64_t digest,
               const Sessions& sessions) {
  std::vector<std::string> addresses;
  for (const env::Interface& interface : env.interfaces()) {
    if (interface.ipv6_side_of) continue;
    addresses.insert(addresses.end(), interface.addresses.begin(), interface.addresses.end());
  }
  Line line;
  append(line, "id", to_string(self.id));
  append(line, "name", self.name());
  append_stated(line, "addresses", base::joined(addresses, ","));
  append(line, "heard", "0.000");
  append(line, "interval", seconds(interval));
  append(line, "loss", "0.000");
  append(line, "ontology", digest_word(digest));
  append(line, "publications", sessions.publication_count());
  append(line, "subscriptions", sessions.subscription_count());
  append_flag(line, "self", true);
  return line;
}

Line line_of(base::Instant now, const membership::Neighbour& neighbour, const membership::NeighbourTable& neighbours) {
  Line line;
  append(line, "id", to_string(neighbour.id));
  append(line, "name", neighbour.name);
  append_stated(line, "addresses", addresses_of(neighbour));
  append(line, "heard", seconds(now - neighbour.heard));
  append(line, "interval", seconds(neighbour.interval));
  append(line, "loss", decimal(neighbour.loss));
  append(line, "ontology", digest_word(neighbour.ontology_digest));
  append(line, "publications", neighbour.publications);
  append(line, "subscriptions", neighbour.subscriptions);
  append_flag(line, "self", false);
  if (neighbour.is_deaf) append_flag(line, "hears_us", false);
  append_stated(line, "observed", observed_address(neighbour.id, neighbours));
  append_way(line, neighbour.id, neighbours);
  return line;
}

}  // namespace

Answer answer_participants(const env::Env& env, const Self& self, base::Duration interval, std::uint64_t digest,
                           const Sessions& sessions, const membership::NeighbourTable& neighbours) {
  Answer answer{.kind = "participants", .lines = {ourselves(env, self, interval, digest, sessions)}, .end = {}};
  neighbours.for_each(
      [&](const membership::Neighbour& one) { answer.lines.push_back(line_of(env.now(), one, neighbours)); });
  // All identifiers have the same number of digits, so that they are in the order of their texts.
  std::ranges::sort(answer.lines, {}, [](const Line& line) { return *line.front().value; });
  return answer;
}

}  // namespace geminga::participant
