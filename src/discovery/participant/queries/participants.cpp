// `query participants`: everybody who is known, ourselves among them.
#include <algorithm>

#include "base/text.hpp"
#include "discovery/participant/naming.hpp"
#include "discovery/participant/queries/lines.hpp"

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

Line ourselves(const Core& core) {
  std::size_t publications = 0;
  std::size_t subscriptions = 0;
  for (const auto& [stream, session] : core.sessions) {
    publications += session->publications.size();
    subscriptions += session->subscriptions.size();
  }
  std::vector<std::string> addresses;
  for (const env::Interface& interface : core.env.interfaces()) {
    if (interface.twin_of) continue;
    addresses.insert(addresses.end(), interface.addresses.begin(), interface.addresses.end());
  }
  Line line;
  append(line, "id", to_string(core.id));
  append(line, "name", core.name());
  append_stated(line, "addresses", base::joined(addresses, ","));
  append(line, "heard", "0.000");
  append(line, "interval", seconds(core.settings.interval));
  append(line, "loss", "0.000");
  append(line, "ontology", digest_word(core.digest()));
  append(line, "publications", publications);
  append(line, "subscriptions", subscriptions);
  append_flag(line, "self", true);
  return line;
}

Line line_of(const Core& core, const membership::Neighbour& neighbour) {
  Line line;
  append(line, "id", to_string(neighbour.id));
  append(line, "name", neighbour.name);
  append_stated(line, "addresses", addresses_of(neighbour));
  append(line, "heard", seconds(core.env.now() - neighbour.heard));
  append(line, "interval", seconds(neighbour.interval));
  append(line, "loss", decimal(neighbour.loss));
  append(line, "ontology", digest_word(neighbour.ontology_digest));
  append(line, "publications", neighbour.publications);
  append(line, "subscriptions", neighbour.subscriptions);
  append_flag(line, "self", false);
  if (neighbour.is_deaf) append_flag(line, "hears_us", false);
  return line;
}

}  // namespace

Answered answer(Core& core, const gcnp::QueryParticipants&) {
  Answer answer{.kind = "participants", .lines = {ourselves(core)}, .end = {}};
  core.neighbours.for_each([&](const membership::Neighbour& one) { answer.lines.push_back(line_of(core, one)); });
  // All identifiers have the same number of digits, so that they are in the order of their texts.
  std::ranges::sort(answer.lines, {}, [](const Line& line) { return *line.front().value; });
  return answer;
}

}  // namespace geminga::participant
