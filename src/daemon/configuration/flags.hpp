// The command line of gemingad.
#ifndef GEMINGA_DAEMON_CONFIGURATION_FLAGS_HPP
#define GEMINGA_DAEMON_CONFIGURATION_FLAGS_HPP

#include <expected>
#include <optional>
#include <string>

#include "daemon/configuration/layer.hpp"

namespace geminga::daemon {

struct Flags {
  Layer layer;
  bool is_check_only = false;                  ///< --check-config
  std::optional<std::string> key_to_generate;  ///< --generate-key: the file to write before the end
  std::string answer;                          ///< not empty: print it and end with 0 (--help, --version, --describe)
};

/// Reads the flags. The error is one line that says what is wrong and what to do.
[[nodiscard]] std::expected<Flags, std::string> read_flags(int argc, const char* const* argv);

}  // namespace geminga::daemon

#endif
