#include "sim/team.hpp"

#include <algorithm>
#include <map>

#include "discovery/announcement/limits.hpp"
#include "discovery/membership/schedule/deadline.hpp"

namespace geminga::sim {
namespace {

constexpr base::Duration check_period = std::chrono::milliseconds(500);
/// A clash is found by the next announcement that gets through, and mended by a claim.
constexpr base::Duration longest_clash = std::chrono::seconds(5);

}  // namespace

Team::Team(World& world, Bounds bounds) : world_(world), ledger_(world, bounds) {
  world_.on_reach_changed = [this] {
    reach_changed_ = world_.now();
    ledger_.reach_changed();
  };
  world_.every(check_period, [this] {
    if (is_excused) ledger_.excuse();
    ledger_.check();
    check_identifiers();
  });
}

Module& Team::add(Host& host, const std::string& name) {
  const auto index = static_cast<std::uint32_t>(modules_.size());
  modules_.push_back(std::make_unique<Module>(world_, ledger_, host, name, index));
  watch(*modules_.back());
  return *modules_.back();
}

void Team::watch(Module& module) {
  module.client().on_line = [this, &module](std::string_view line, const gcnp::Statement& statement) {
    see(module, line, statement);
  };
}

void Team::see(Module& module, std::string_view line, const gcnp::Statement& statement) {
  const bool is_event = statement.command == "pub" || statement.command == "sub";
  events_ += is_event ? 1 : 0;
  if (!is_event && statement.command != "msg") {
    world_.complain("errors: one where none is due, " + module.client().name() + ": " + std::string(line) + ",");
  }
  if (is_event && statement.subcommand == "del" && statement.value("reason") == "expired" && !is_excused) {
    const auto word = statement.value(statement.command == "pub" ? "service" : "subscription");
    const std::string_view participant = word.value_or("").substr(0, 8);
    for (const auto& other : modules_) {
      if (!is_served_by(module, participant, *other)) continue;
      false_departures_.insert(world_.when() + ", " + module.host().name() + " about " + other->host().name());
      break;
    }
  }
  module.hear(line, statement);
}

/// Whether the very participant that is said to be gone serves this module, and has been heard all the time.
bool Team::is_served_by(Module& module, std::string_view participant, Module& other) const {
  if (!other.client().is_connected() || other.client().participant() != participant) return false;
  const bool is_awake = other.host().pause() == Host::Pause::none && module.host().pause() == Host::Pause::none;
  const base::Duration longest =
      std::chrono::duration_cast<base::Duration>(other.host().settings.interval * (membership::longest_deadline + 1));
  return is_awake && world_.is_reached(other.host(), module.host()) && world_.now() - reach_changed_ > longest;
}

bool Team::settle(base::Duration at_most) {
  const base::Instant end = world_.now() + at_most;
  while (!is_right()) {
    if (world_.now() >= end) {
      world_.complain("the views are not right: " + complaints());
      return false;
    }
    world_.run_for(std::chrono::milliseconds(20));
  }
  return true;
}

void Team::check_identifiers() {
  std::map<std::string_view, const Host*> owners;
  bool is_unique = true;
  for (const auto& module : modules_) {
    const std::string& id = module->client().participant();
    if (!module->client().is_connected() || id.empty()) continue;
    const auto [owner, is_new] = owners.emplace(id, &module->host());
    is_unique &= is_new || owner->second == &module->host();
  }
  if (is_unique || is_excused) {
    same_identifier_since_ = base::never;
    return;
  }
  same_identifier_since_ = std::min(same_identifier_since_, world_.now());
  if (world_.now() - same_identifier_since_ <= longest_clash) return;
  world_.complain("identifiers: two have the same one,");
  same_identifier_since_ = world_.now();
}

}  // namespace geminga::sim
