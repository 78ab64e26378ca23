// The configuration that a running daemon follows: read again at SIGHUP, and changed where a running daemon can change.
#ifndef GEMINGA_DAEMON_CONFIGURATION_CONFIGURATION_IN_FORCE_HPP
#define GEMINGA_DAEMON_CONFIGURATION_CONFIGURATION_IN_FORCE_HPP

#include <expected>
#include <functional>
#include <string>
#include <vector>

#include "daemon/configuration/configuration.hpp"

namespace geminga::daemon {

/// Differences between the configuration that was in force and the one that was read.
struct ConfigurationChange {
  bool air = false;      ///< interfaces, groups, peers or port
  bool sealing = false;  ///< keys or mode
  bool description = false;
  bool awaits_a_start =
      false;  ///< one of name, group, gcnp, gcnp-socket, interval, relay, diagnose, state-folder and cage
};

class ConfigurationInForce {
 public:
  /// Reads the configuration again. The errors are lines for the user, the first of which names what is wrong.
  using Reader = std::function<std::expected<Configuration, std::vector<std::string>>()>;

  ConfigurationInForce(Configuration started, Reader read) : current_(std::move(started)), read_(std::move(read)) {}

  [[nodiscard]] const Configuration& current() const { return current_; }

  /// Reads the configuration and puts it in force, but for the settings that only a start can change: these stay as
  /// they are. A configuration with errors changes nothing; nor does one that has lost its key files, unless it says
  /// that announcements shall be plain.
  [[nodiscard]] std::expected<ConfigurationChange, std::vector<std::string>> reload();

  /// The first error of the last reload(); empty where that found none.
  [[nodiscard]] const std::string& failure() const { return failure_; }

 private:
  [[nodiscard]] std::expected<Configuration, std::vector<std::string>> read_to_go_on() const;

  Configuration current_;
  Reader read_;
  std::string failure_;
};

}  // namespace geminga::daemon

#endif
