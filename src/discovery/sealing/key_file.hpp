// The text of a key file: comments, and one line `key ID SECRET`. The daemon reads and writes the files.
#ifndef GEMINGA_DISCOVERY_SEALING_KEY_FILE_HPP
#define GEMINGA_DISCOVERY_SEALING_KEY_FILE_HPP

#include <cstddef>
#include <expected>
#include <string>
#include <string_view>

#include "discovery/sealing/key.hpp"

namespace geminga::sealing {

struct KeyFileError {
  std::size_t line = 0;  ///< from 1
  std::string text;      ///< the fault and the remedy; never a part of the key
};

/// Reads the text of a key file, whatever it is.
[[nodiscard]] std::expected<Key, KeyFileError> read_key(std::string_view text);

/// The text that read_key() reads, with comments that explain it. The caller wipes it.
[[nodiscard]] std::string write_key(const Key::Secret& secret);

}  // namespace geminga::sealing

#endif
