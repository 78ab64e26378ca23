#include "scenarios/tables.hpp"

#include <algorithm>
#include <string>

#include "base/text.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::scenarios {
namespace {

constexpr base::Duration period = std::chrono::seconds(10);
/// In the end so many of a large team are asked.
constexpr std::size_t most_asked = 50;

std::size_t number(const gcnp::Statement& status, std::string_view key) {
  return base::parse_number<std::size_t>(status.value(key).value_or("")).value_or(0);
}

}  // namespace

Tables::Tables(sim::World& world, sim::Team& team) : world_(world), team_(team) {
  world_.every(period, [this] { ask_next(); });
}

void Tables::ask_next() {
  if (world_.hosts().empty()) return;
  ask(*world_.hosts()[next_++ % world_.hosts().size()]);
}

void Tables::ask(sim::Host& host) {
  if (!host.is_on() || host.pause() != sim::Host::Pause::none) return;
  sim::Client*& asker = askers_[&host];
  if (asker == nullptr) {
    asker = &world_.add_client(host.name() + "-asker");
    asker->keeps_lines = false;
    asker->on_line = [this, &host](std::string_view, const gcnp::Statement& statement) {
      if (statement.subcommand == "status") hear(host, statement);
    };
  }
  if (!asker->is_connected()) asker->connect(host);
  asker->say("1 query status");
}

void Tables::hear(const sim::Host& host, const gcnp::Statement& status) {
  const auto complain = [&](const std::string& what, std::size_t is, std::size_t should) {
    world_.complain("tables: " + host.name() + " knows " + std::to_string(is) + " " + what + ", and there are " +
                    std::to_string(should) + ",");
  };
  const std::size_t participants = number(status, "participants");
  const std::size_t publications = number(status, "publications");
  if (participants > announcement::max_participants + 1) {
    complain("participants", participants, announcement::max_participants + 1);
  }
  if (!is_exact_) return;
  std::size_t hosts = 0;
  std::size_t offers = 0;
  for (const auto& one : world_.hosts()) hosts += one->is_on() ? 1 : 0;
  for (const auto& module : team_.modules()) offers += module->client().is_connected() ? module->offers().size() : 0;
  if (hosts > announcement::max_participants + 1) return;
  if (participants > hosts) complain("participants", participants, hosts);
  if (publications > offers) complain("publications", publications, offers);
}

void Tables::check_all() {
  is_exact_ = true;
  const std::size_t asked = std::min(world_.hosts().size(), most_asked);
  for (std::size_t i = 0; i < asked; ++i) ask(*world_.hosts()[i]);
  world_.run_for(std::chrono::milliseconds(1));
  is_exact_ = false;
}

}  // namespace geminga::scenarios
