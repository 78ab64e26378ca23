#include "discovery/relaying/relay.hpp"

#include <algorithm>
#include <cmath>

#include "discovery/announcement/limits.hpp"

namespace geminga::relaying {
namespace {

constexpr double lost_unit = 16;  // the loss is said in sixteenths

}  // namespace

env::InterfaceIndex Relay::link_of(env::InterfaceIndex interface) const {
  const auto& interfaces = env_.interfaces();
  const auto found = std::ranges::find(interfaces, interface, &env::Interface::index);
  return found == interfaces.end() ? interface : relaying::link_of(*found);
}

bool Relay::is_heard_on(const membership::Reach& reach, env::InterfaceIndex link) const {
  if (reach.hops > 0) return reach.beyond == link;
  // A way that has fallen silent leads to where the participant was.
  const auto since = env_.now() - announcement::hold_intervals * reach.interval;
  return std::ranges::any_of(reach.ways, [&](const membership::NeighbourWay& way) {
    return !way.is_relayed() && way.heard() >= since && link_of(way.interface()) == link;
  });
}

bool Relay::speaks_for(const membership::Reach& reach, env::InterfaceIndex link, ParticipantId self) const {
  return reach.hops < announcement::max_hops && !is_heard_on(reach, link) &&
         !speakers_.has_better({link, reach.id}, {reach.hops + 1, self}, env_.now());
}

std::vector<env::InterfaceIndex> Relay::links_for(ParticipantId participant, env::InterfaceIndex from,
                                                  ParticipantId self, bool is_sealed) const {
  std::vector<env::InterfaceIndex> links;
  const auto reach = neighbours_.reach(participant);
  for (const env::Interface& interface : env_.interfaces()) {
    if (interface.ipv6_side_of || interface.index == from || (!is_sealed && !interface.is_named_peer)) continue;
    if (!reach || speaks_for(*reach, interface.index, self)) links.push_back(interface.index);
  }
  return links;
}

bool Relay::may_pass() {
  const base::Instant now = env_.now();
  if (!budget_.has(now)) return false;
  budget_.take(now);
  return true;
}

std::vector<announcement::Behind> Relay::behind(env::InterfaceIndex link, ParticipantId self) const {
  std::vector<announcement::Behind> behind;
  const base::Instant now = env_.now();
  neighbours_.for_each_reach([&](const membership::Reach& reach) {
    if (!speaks_for(reach, link, self)) return;
    behind.push_back({.participant = reach.id,
                      .revision = reach.revision,
                      .age = now - reach.heard,
                      .hops = static_cast<std::uint8_t>(reach.hops + 1),
                      .lost = static_cast<std::uint8_t>(std::lround(reach.loss * lost_unit))});
  });
  return behind;
}

void Relay::hear_behind(env::InterfaceIndex link, const announcement::Announcement& presence, base::Duration interval) {
  for (const announcement::Behind& one : presence.behind)
    hear_speaker(link, one.participant, {one.hops, presence.participant}, interval);
}

void Relay::hear_doubts(env::InterfaceIndex link, const std::vector<ParticipantId>& doubts) {
  for (const ParticipantId id : doubts) speakers_.doubt({link, id});
}

std::vector<ParticipantId> Relay::elsewhere(env::InterfaceIndex link, const std::vector<ParticipantId>& named) const {
  std::vector<ParticipantId> asked;
  std::ranges::copy_if(named, std::back_inserter(asked), [&](ParticipantId id) {
    const auto reach = neighbours_.reach(id);
    return reach && !is_heard_on(*reach, link);
  });
  return asked;
}

void Relay::repeat(env::InterfaceIndex link, const announcement::Announcement& relayed) {
  if (neighbours_.loss().value_or(0) < repeats_from_loss) return;
  repeats_.push_back({.at = env_.now() + repeat_delay, .link = link, .relayed = relayed});
}

std::optional<Relay::Repeat> Relay::take_repeat() {
  if (repeats_.empty() || repeats_.front().at > env_.now()) return std::nullopt;
  Repeat repeat = std::move(repeats_.front());
  repeats_.pop_front();
  repeat.relayed.relayed.age += repeat_delay;
  return repeat;
}

base::Instant Relay::due() const {
  return repeats_.empty() ? speakers_.due() : std::min(repeats_.front().at, speakers_.due());
}

}  // namespace geminga::relaying
