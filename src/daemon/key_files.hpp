// The files that hold the team's keys: read with care, and made once.
#ifndef GEMINGA_DAEMON_KEY_FILES_HPP
#define GEMINGA_DAEMON_KEY_FILES_HPP

#include <expected>
#include <string>
#include <vector>

#include "discovery/sealing/key.hpp"

namespace geminga::daemon {

/// Reads key files in their order. The errors are lines that begin with the file; a file that its group or others may
/// read or change is one, because the key is no secret then. Nothing of a key is in them.
[[nodiscard]] std::expected<sealing::Keyring, std::vector<std::string>> read_keys(
    const std::vector<std::string>& paths);

/// Draws a key and writes it into a new file that only its owner may read. Gives the key's id as a word; the error is a
/// line. What is there already is never overwritten.
[[nodiscard]] std::expected<std::string, std::string> generate_key(const std::string& path);

}  // namespace geminga::daemon

#endif
