#include "discovery/participant/queries/ways.hpp"

#include <string>
#include <vector>

#include "base/text.hpp"

namespace geminga::participant {
namespace {

gcnp::Way way_of(const membership::Reach& reach, const membership::Neighbours& neighbours) {
  if (reach.hops == 0) return {};
  const auto neighbour = neighbours.find(reach.id);
  std::vector<std::string> names;
  for (const ParticipantId id : neighbour->through) {
    const auto relay = neighbours.find(id);
    names.push_back(relay ? relay->name : to_string(id));
  }
  return {.hops = reach.hops, .path = base::joined(names, "/")};
}

}  // namespace

gcnp::Way way_of(ParticipantId participant, const membership::Neighbours& neighbours) {
  const auto reach = neighbours.reach(participant);
  return reach ? way_of(*reach, neighbours) : gcnp::Way();
}

void append_way(Line& line, ParticipantId participant, const membership::Neighbours& neighbours) {
  const auto reach = neighbours.reach(participant);
  if (!reach) return;
  gcnp::Way way = way_of(*reach, neighbours);
  way.is_reachable = reach->reachability == membership::Reachability::reachable;
  gcnp::append_way(line, way);
}

std::string observed_address(ParticipantId participant, const membership::Neighbours& neighbours) {
  const auto reach = neighbours.reach(participant);
  return reach ? membership::observed_address(*reach) : std::string();
}

}  // namespace geminga::participant
