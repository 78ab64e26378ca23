#include "daemon/configuration/flags.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <list>
#include <string>
#include <utility>

#include "discovery/announcement/version.hpp"
#include "discovery/gcnp/version.hpp"
#include "discovery/sealing/version.hpp"
#include "manual/describe.hpp"
#include "manual/mistake.hpp"
#include "reasoning/compiled/container.hpp"

namespace geminga::daemon {
namespace {

constexpr const char* about =
    "gemingad finds the services of a robot team: one daemon a host, in the foreground.\n"
    "Local programs publish and subscribe over GCNP on 127.0.0.1:4717 and [::1]:4717; the team is found by UDP "
    "multicast.";

constexpr const char* footer =
    R"(Environment: each flag has a variable, e.g. GEMINGA_ONTOLOGY=a.ttl,b.ttl and GEMINGA_LOG_LEVEL=debug.
Signals:     SIGHUP reads configuration and ontologies again; SIGTERM and SIGINT say goodbye to the team and end.
Exit status: 0 ended as asked, 2 wrong usage or configuration.

Examples:
  gemingad --ontology /usr/share/geminga/ontology/robot-soccer.ttl
  gemingad --config /etc/geminga/gemingad.toml --config /etc/geminga/conf.d --check-config
  gemingad --interface wlan0 --name robot2 --interval 1
  gemingad --gcnp none --gcnp-socket /run/geminga/gcnp
A team that nobody else hears:
  gemingad --generate-key team.key
  gemingad --key-file team.key
Two daemons on one host, for a try:
  gemingad --interface lo --name a --gcnp 127.0.0.1:4717 &
  gemingad --interface lo --name b --gcnp 127.0.0.1:4718 &)";

/// One line: the program's version, and what another daemon, a client and a file must agree with.
std::string versions() {
  return "gemingad " GEMINGA_VERSION " (announcements " + std::to_string(announcement::format_major) + ", seals " +
         std::to_string(sealing::envelope_version) + ", GCNP " + std::to_string(gcnp::gcnp_version) +
         ", compiled ontologies " + std::to_string(compiled::compiled_version) + ")";
}

}  // namespace

std::expected<Flags, std::string> read_flags(int argc, const char* const* argv) {
  CLI::App app(about, "gemingad");
  app.footer(footer);
  app.get_formatter()->column_width(34);
  app.set_version_flag("--version", versions(), "Print the versions of the program, its protocols and files, and end");
  Flags flags;
  app.add_flag("--check-config", flags.is_check_only,
               "Check configuration and ontologies, print the resulting configuration, and end");
  app.add_option("--generate-key", flags.key_to_generate, "Write a new key for a team into this file, and end")
      ->type_name("FILE");
  struct Given {
    const Key* key;
    std::vector<std::string> values;
    bool truth;
  };
  std::list<Given> given;  // a list, because CLI11 keeps references
  for (const Key& key : keys) {
    auto& [owner, values, truth] = given.emplace_back(&key, std::vector<std::string>{}, false);
    if (key.type == ValueType::truth) {
      app.add_flag("--" + std::string(key.name), truth, std::string(key.help));
      continue;
    }
    CLI::Option* option = app.add_option("--" + std::string(key.name), values, std::string(key.help));
    option->type_size(1)->allow_extra_args(false)->type_name(std::string(key.placeholder));
    if (key.type == ValueType::texts) {
      option->expected(1, static_cast<int>(CLI::detail::expected_max_vector_size));
    } else {
      option->expected(1);
    }
    option->multi_option_policy(key.type == ValueType::texts ? CLI::MultiOptionPolicy::TakeAll
                                                             : CLI::MultiOptionPolicy::Throw);
  }
  if (auto description = manual::described(app, argc, argv, 8)) {
    flags.answer = std::move(*description);
    return flags;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    flags.answer = app.help();
    return flags;
  } catch (const CLI::CallForVersion&) {
    flags.answer = versions() + '\n';
    return flags;
  } catch (const CLI::ParseError& error) {
    return std::unexpected(manual::mistake(app, error));
  }
  for (auto& [key, values, truth] : given) {
    const std::string name(key->name);
    if (key->type == ValueType::truth && app.count("--" + name) > 0) values = {truth ? "true" : "false"};
    for (const std::string& value : values) flags.layer.values[name].push_back({value, "--" + name});
  }
  return flags;
}

}  // namespace geminga::daemon
