#include "scenarios/starts.hpp"

#include <span>

#include "discovery/announcement/codec.hpp"
#include "scenarios/moment.hpp"
#include "scenarios/traffic.hpp"
#include "sim/host.hpp"
#include "sim/robots.hpp"

namespace geminga::scenarios {
namespace {

constexpr base::Duration look_again = std::chrono::milliseconds(5);

std::string word(announcement::Kind kind) {
  switch (kind) {
    case announcement::Kind::state:
      return "state";
    case announcement::Kind::claim:
      return "claim";
    case announcement::Kind::goodbye:
      return "goodbye";
    case announcement::Kind::presence:
      return "presence";
    case announcement::Kind::change:
      return "change";
    case announcement::Kind::inquiry:
      return "inquiry";
    case announcement::Kind::diagnosis:
      return "diagnosis";
    case announcement::Kind::relayed:
      return "relayed";
  }
  return "?";
}

/// "robot3: presence, knows 8, lacks 1, doubts 0"
std::string in_words(const sim::Host& sender, std::string_view datagram) {
  const auto heard = announcement::decode(std::as_bytes(std::span(datagram)));
  if (!heard) return sender.name() + ": unreadable";
  std::string words = sender.name() + ": " + word(heard->kind) + " of " + std::to_string(datagram.size());
  if (heard->kind != announcement::Kind::presence) return words;
  return words + ", fold " + std::to_string(heard->witness.members) + ", lacks " + std::to_string(heard->lacks.size()) +
         ", doubts " + std::to_string(heard->doubts.size());
}

}  // namespace

Start measure_start(const Conditions& conditions, const std::function<void(const std::string& line)>& tell) {
  sim::World world(conditions.seed, conditions.air, [](const std::string&) {});
  sim::Team team(world, {.missing = 2 * longest_start, .surplus = 2 * longest_start});
  for (std::size_t i = 1; i <= conditions.participants; ++i) {
    sim::furnish(team, world.add_host("robot" + std::to_string(i)));
  }
  if (tell) {
    world.on_transmit = [&](const sim::Host& sender, std::string_view datagram) {
      tell(moment(world.now().time_since_epoch()) + "  " + in_words(sender, datagram));
    };
  }
  for (const auto& host : world.hosts()) {
    host->settings.interval = conditions.interval;
    world.after(world.random().between(base::Duration(0), conditions.start_spread),
                [one = host.get()] { one->switch_on(); });
  }
  // A module connects when its daemon is there, which takes a moment of its own.
  for (const auto& module : team.modules()) {
    world.after(world.random().between(base::Duration(0), 2 * conditions.start_spread),
                [one = module.get()] { one->run(); });
  }
  Start start{.seed = conditions.seed, .took = {}, .octets = 0};
  const auto octets = [&world] { return world.datagram_bytes() + header_octets * world.datagrams(); };
  world.run_for(2 * conditions.start_spread);
  while (!team.is_right() && world.now() < base::Instant(longest_start)) {
    if (start.octets == 0 && world.now() >= base::Instant(settled_after)) start.octets = octets();
    world.run_for(look_again);
  }
  start.took = world.now().time_since_epoch();
  if (world.now() < base::Instant(settled_after)) world.run_for(base::Instant(settled_after) - world.now());
  if (start.octets == 0) start.octets = octets();
  start.octets /= conditions.participants;
  return start;
}

}  // namespace geminga::scenarios
