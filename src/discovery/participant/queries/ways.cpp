#include "discovery/participant/queries/ways.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "base/text.hpp"

namespace geminga::participant {
namespace {

std::string without_zone(const std::string& address) { return address.substr(0, address.find('%')); }

bool announces_source(const membership::NeighbourWay& way) {
  return std::ranges::any_of(way.addresses(), [source = without_zone(way.source())](const std::string& address) {
    return without_zone(address) == source;
  });
}

}  // namespace

gcnp::Way way_of(ParticipantId participant, const membership::NeighbourTable& neighbours) {
  const auto reach = neighbours.reach(participant);
  if (!reach || reach->hops == 0) return {};
  const auto neighbour = neighbours.find(participant);
  std::vector<std::string> names;
  for (const ParticipantId id : neighbour->through) {
    const auto relay = neighbours.find(id);
    names.push_back(relay ? relay->name : to_string(id));
  }
  return {.hops = reach->hops, .path = base::joined(names, "/")};
}

void append_way(Line& line, ParticipantId participant, const membership::NeighbourTable& neighbours) {
  gcnp::append_way(line, way_of(participant, neighbours));
}

std::string observed_address(ParticipantId participant, const membership::NeighbourTable& neighbours) {
  const auto reach = neighbours.reach(participant);
  // A way that is known by presences alone has said no addresses.
  if (!reach || std::ranges::any_of(reach->ways, [](const membership::NeighbourWay& way) {
        return way.addresses().empty() || way.source().empty() || announces_source(way);
      }))
    return {};
  return reach->ways.empty() ? std::string() : reach->ways.front().source();
}

}  // namespace geminga::participant
