// The files of the team's keys: read only where they are secret, and written once.
#ifndef GEMINGA_DAEMON_CONFIGURATION_KEY_FILES_HPP
#define GEMINGA_DAEMON_CONFIGURATION_KEY_FILES_HPP

#include <expected>
#include <string>
#include <vector>

#include "discovery/sealing/key.hpp"

namespace geminga::daemon {

/// Reads key files in their order. The errors are lines that begin with the file and hold nothing of a key. A file that
/// its group or others may read or change is an error, because its key is no secret; so is one that belongs to another
/// user than this one or root, or lies in a folder where others may replace it. A file in $CREDENTIALS_DIRECTORY may
/// belong to anybody, and its group may read it (systemd.exec(5), Credentials).
[[nodiscard]] std::expected<sealing::Keyring, std::vector<std::string>> read_keys(
    const std::vector<std::string>& paths);

/// Draws a key and writes it into a new file that only its owner may read. Returns the key's id as a word; the error is
/// a line. An existing file is never overwritten.
[[nodiscard]] std::expected<std::string, std::string> generate_key(const std::string& path);

}  // namespace geminga::daemon

#endif
