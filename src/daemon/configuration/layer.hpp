// The settings that one source (the flags, the environment, the configuration file) states, with their places.
#ifndef GEMINGA_DAEMON_CONFIGURATION_LAYER_HPP
#define GEMINGA_DAEMON_CONFIGURATION_LAYER_HPP

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::daemon {

enum class ValueType {
  text,
  texts,   ///< any number of texts; a stronger source replaces all of them
  number,  ///< a whole number
  seconds,
  truth,  ///< true or false; the flag alone means true
};

/// One thing that can be configured: the flag `--KEY`, the variable GEMINGA_KEY, and KEY in the file.
struct Key {
  std::string_view name;
  ValueType type;
  std::string_view placeholder;
  std::string_view help;
};

inline constexpr std::array<Key, 23> keys{{
    {"ontology", ValueType::texts, "FILE-OR-FOLDER",
     "Ontology to load; a folder means every ontology file in it. May be given many times"},
    {"strict", ValueType::truth, "true|false",
     "Start without any ontology where one file of a folder cannot be read (default: false: start with the others)"},
    {"adopt-from", ValueType::texts, "PARTICIPANT",
     "Put an ontology in force, beside those named here, that this participant offers and geminga-ontology adopt has "
     "fetched, whenever its version rises; may be given many times (default: nobody)"},
    {"group", ValueType::text, "NAME", "Only participants of the same group see each other (default: default)"},
    {"interface", ValueType::texts, "NAME",
     "Use only this network interface; may be given many times. The loopback is used only when named: --interface lo"},
    {"peer", ValueType::texts, "HOST[:PORT]",
     "Send copies to this host, where multicast does not pass; without a team key the other host has to name this one, "
     "too. '*': accept every host with the team's key. May be given many times"},
    {"relay", ValueType::truth, "true|false",
     "Pass on what is heard on one link to the others: every interface in use, and every host that peer names "
     "(default: "
     "false). Without a team key only between hosts that name each other"},
    {"announce-address", ValueType::texts, "[INTERFACE=]ADDRESS",
     "Announce this address in place of the interface's own, as behind NAT; may be given many times"},
    {"name", ValueType::text, "NAME", "What the team calls this participant (default: the host's name)"},
    {"describe", ValueType::text, "EXPRESSION-OR-FILE",
     "Tell the team what this participant is: a class expression such as 'Robot and hasPart some Gripper', or a file "
     "of "
     "facts about geminga:self, whose name ends as those of ontologies do (.ttl, .owl, .omn ...)"},
    {"gcnp", ValueType::texts, "ADDRESS:PORT",
     "Listen for local clients there; may be given many times; none: no TCP (default: 127.0.0.1:4717 and "
     "[::1]:4717)"},
    {"gcnp-socket", ValueType::text, "PATH",
     "Listen for local clients at this Unix socket, too: for the daemon's user and group only"},
    {"port", ValueType::number, "UDP-PORT", "UDP port of announcements (default: 4717)"},
    {"multicast", ValueType::texts, "ADDRESS",
     "Multicast group of announcements; may be given many times (default: 239.192.47.17 and ff02::4717)"},
    {"interval", ValueType::seconds, "SECONDS",
     "Time between announcements of an unchanged state, 0.05 to 60 (default: 2). Shorter: a lost participant is "
     "noticed sooner. Longer: less traffic"},
    {"key-file", ValueType::texts, "FILE",
     "Seal announcements with the key in this file, and hear only what is sealed; may be given many times: the first "
     "one seals, all of them open"},
    {"sealing", ValueType::text, "encrypted|authenticated|prepared|mixed|plain",
     "Mode of sealing, where there is a key: encrypted, authenticated, or, to introduce keys in a team, prepared and "
     "then mixed (default: encrypted). plain: a reload may give up the keys"},
    {"diagnose", ValueType::truth, "true|false",
     "Tell others of the team, when they ask by geminga-query doctor --with, what this host hears (default: false)"},
    {"state-folder", ValueType::text, "FOLDER",
     "Keep the daemon's identity there across restarts, so that the team recognizes it at once (default: "
     "$STATE_DIRECTORY, as systemd sets it; else no identity is kept)"},
    {"cage", ValueType::text, "wanted|required|none",
     "Give up all rights that serving does not need: where the kernel can; required: or do not start; none: never "
     "(default: wanted)"},
    {"log-level", ValueType::text, "debug|info|warning|error", "debug, info, warning or error (default: info)"},
    {"log-format", ValueType::text, "text|json", "text or json (default: text)"},
    {"config", ValueType::texts, "FILE-OR-FOLDER",
     "Configuration file in TOML; a folder means its files *.toml in the order of their names. May be given many "
     "times: "
     "a later file beats an earlier one, the environment beats files, and a flag beats all"},
}};

/// The key of this name, or null.
[[nodiscard]] const Key* find_key(std::string_view name);

/// One value and its place: `--port`, `GEMINGA_PORT`, or `team.toml:3`.
struct Stated {
  std::string text;
  std::string origin;
};

/// The values that a source states, by key. A key without values states an empty list.
struct Layer {
  std::map<std::string, std::vector<Stated>, std::less<>> values;
  std::map<std::string, Stated> prefixes;  ///< IRIs by prefix; only the file has them, in its table [prefixes]
};

/// Reads the variables GEMINGA_..., whose lists are separated by commas. `environment` is as main() gets it.
[[nodiscard]] Layer read_environment(const char* const* environment);
/// A line for each variable whose name is similar to that of a setting, and is no other variable of this project:
/// "GEMINGA_INTERVL: unknown: did you mean GEMINGA_INTERVAL?".
[[nodiscard]] std::vector<std::string> mistyped_variables(const char* const* environment);
/// Reads the state folder that systemd gives a service: the first folder of $STATE_DIRECTORY (systemd.exec(5),
/// StateDirectory=). The weakest layer.
[[nodiscard]] Layer read_service(const char* const* environment);

}  // namespace geminga::daemon

#endif
