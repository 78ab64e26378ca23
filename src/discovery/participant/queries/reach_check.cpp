#include "discovery/participant/queries/reach_check.hpp"

#include "discovery/participant/queries/ways.hpp"

namespace geminga::participant {
namespace {

using matching::Obstacle;
using membership::Reachability;

/// The cause, to stand behind a comma; empty where the participant can be reached meanwhile.
std::string cause_of(const membership::Neighbours& neighbours, ParticipantId participant) {
  const auto reach = neighbours.reach(participant);
  if (!reach || reach->reachability == Reachability::reachable) return "";
  if (reach->reachability == Reachability::no_route) return ", since this host has no route to it";
  return ", since its host's words come from " + membership::observed_address(*reach) +
         ", so that a translation of addresses lies between, and only the default route leads there";
}

}  // namespace

Check check_reach(const membership::Neighbours& neighbours, const Asked& asked,
                  const registry::PublicationEntry& offer) {
  const std::string text = "the address " + offer.publication.address + " is not reachable from here" +
                           cause_of(neighbours, offer.key.participant);
  if (!matching::is_withheld(asked.entry, offer)) return {"reach", Obstacle::none, text + "; reach=any accepts that"};
  return {"reach", Obstacle::unreachable, text,
          "add a route to it on this host, or have the other host announce an address that can be reached from here "
          "(gemingad --announce-address), or ask with reach=any where the consumer knows a way of its own"};
}

}  // namespace geminga::participant
