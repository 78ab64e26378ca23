// The effective configuration of gemingad: flags over environment over file over defaults, checked as a whole.
#ifndef GEMINGA_DAEMON_CONFIGURATION_CONFIGURATION_HPP
#define GEMINGA_DAEMON_CONFIGURATION_CONFIGURATION_HPP

#include <expected>
#include <map>
#include <string>
#include <vector>

#include "base/log.hpp"
#include "base/time.hpp"
#include "daemon/adoption/adoption.hpp"
#include "daemon/configuration/layer.hpp"
#include "discovery/sealing/seal.hpp"
#include "env/asio/asio_env.hpp"
#include "reasoning/syntax/folders.hpp"

namespace geminga::daemon {

/// The most values of one key.
inline constexpr std::size_t max_values = 256;
/// The most prefixes, and the most octets of a prefix's name and of its IRI.
inline constexpr std::size_t max_prefixes = 256;
inline constexpr std::size_t max_prefix_name_bytes = 64;
inline constexpr std::size_t max_prefix_iri_bytes = 255;
/// The most octets of --describe: those of a concept in GCNP.
inline constexpr std::size_t max_description_bytes = 1024;
/// The most addresses of --gcnp, and of --multicast.
inline constexpr std::size_t max_addresses = 16;

enum class LogFormat { text, json };

/// Whether the daemon closes a cage around itself: where the kernel can, or not at all without it, or never.
enum class CageWish { wanted, required, none };

struct GcnpAddress {
  env::Endpoint endpoint;
  bool may_be_missing = false;  ///< a default address: a host without IPv6 goes on with IPv4
  friend bool operator==(const GcnpAddress&, const GcnpAddress&) = default;
};

struct Configuration {
  std::vector<std::string> ontologies;
  bool is_strict = false;  ///< one file of a folder that cannot be read refuses all ontologies at a start, too
  Adopted adopted;         ///< from whom, and below the state folder; without a folder where it is from nobody
  std::map<std::string, std::string> prefixes;  ///< of names, beside those of the ontologies
  std::string group = "default";
  std::string name;
  /// A class expression of what the participant is, or a file with facts about it (describes_by_file()); empty: none.
  std::string description;
  std::vector<GcnpAddress> gcnp;  ///< empty: not over TCP
  std::string gcnp_socket;        ///< path of a Unix socket; empty: none
  env::AirSettings air;
  bool admits_any_peer = false;  ///< peers with the key are heard though none is named
  std::string state_folder;      ///< empty: no identity is kept
  std::vector<std::string> key_files;
  /// The mode, which is plain where there are no key files and only there. main() reads the files and adds the keys.
  sealing::Policy sealing;
  bool says_plain = false;  ///< `sealing = "plain"` is stated, and not only the default
  bool relay = false;       ///< all that is heard on one link is passed on to the others
  bool diagnoses = false;   ///< others of the team are told what we hear
  base::Duration interval = std::chrono::seconds(2);
  base::LogLevel log_level = base::LogLevel::info;
  LogFormat log_format = LogFormat::text;
  CageWish cage = CageWish::wanted;
  /// Whether the description is the name of a file, which its ending decides.
  [[nodiscard]] bool describes_by_file() const { return syntax::is_ontology_name(description); }
  friend bool operator==(const Configuration&, const Configuration&) = default;
};

/// Puts the layers together, the strongest first. The errors are lines that begin with the place of what is wrong.
/// `host_name` is the default of --name.
[[nodiscard]] std::expected<Configuration, std::vector<std::string>> resolve(const std::vector<const Layer*>& layers,
                                                                             const std::string& host_name);

/// The configuration as a TOML document that configures the same.
[[nodiscard]] std::string to_toml(const Configuration& configuration);

[[nodiscard]] std::string_view to_string(base::LogLevel level);

}  // namespace geminga::daemon

#endif
