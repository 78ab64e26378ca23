// The text of a key file: comments, and one line `key ID SECRET`. Reading and writing files is the daemon's.
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
  std::string text;      ///< what is wrong and what to do; never anything of the key
};

/// Reads the text of a key file, whatever it is.
[[nodiscard]] std::expected<Key, KeyFileError> read_key(std::string_view text);

/// The text that read_key() reads, with comments that say what it is. The caller wipes it.
[[nodiscard]] std::string write_key(const Key::Secret& secret);

}  // namespace geminga::sealing

#endif
