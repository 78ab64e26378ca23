#include "daemon/configuration/configuration_in_force.hpp"

#include <utility>

namespace geminga::daemon {
namespace {

/// Keeps in `read` one setting of `current` that only a start can change. Gives whether they differ.
template <typename Setting>
bool keep(Setting& read, const Setting& current) {
  return std::exchange(read, current) != current;
}

}  // namespace

/// Reads a configuration that this one may become. A key that got lost (a file that was cut short, a folder that is not
/// mounted yet) must not make a sealed robot speak plainly, and believe what it hears.
std::expected<Configuration, std::vector<std::string>> ConfigurationInForce::read_to_go_on() const {
  auto read = read_();
  const bool has_lost_keys = read && !current_.key_files.empty() && read->key_files.empty();
  if (!has_lost_keys || read->says_plain) return read;
  return std::unexpected(std::vector<std::string>{
      "key-file: no key is named any more: name it, or say sealing = \"plain\" to go on without seals"});
}

std::expected<ConfigurationChange, std::vector<std::string>> ConfigurationInForce::reload() {
  auto read = read_to_go_on();
  if (!read) {
    failure_ = read.error().empty() ? "unknown" : read.error().front();
    return std::unexpected(std::move(read.error()));
  }
  failure_.clear();
  ConfigurationChange change;
  for (const bool differs :
       {keep(read->name, current_.name), keep(read->group, current_.group), keep(read->gcnp, current_.gcnp),
        keep(read->gcnp_socket, current_.gcnp_socket), keep(read->interval, current_.interval),
        keep(read->state_folder, current_.state_folder), keep(read->diagnoses, current_.diagnoses),
        keep(read->relay, current_.relay), keep(read->cage, current_.cage)}) {
    change.awaits_a_start = change.awaits_a_start || differs;
  }
  change.air = read->air != current_.air;
  change.sealing = read->sealing != current_.sealing;
  change.description = read->description != current_.description;
  current_ = std::move(*read);
  return change;
}

}  // namespace geminga::daemon
