// The configuration file of gemingad: TOML, with the keys of the flags.
#ifndef GEMINGA_DAEMON_CONFIGURATION_CONFIGURATION_FILE_HPP
#define GEMINGA_DAEMON_CONFIGURATION_CONFIGURATION_FILE_HPP

#include <expected>
#include <string>
#include <vector>

#include "daemon/configuration/layer.hpp"

namespace geminga::daemon {

/// The longest configuration file.
inline constexpr std::size_t max_configuration_bytes = 1024 * 1024;

/// Reads the file: the flags' names as keys, and a table [prefixes] of names for IRIs. Unknown keys and values of a
/// wrong type are errors. Paths of ontologies, keys, the socket and the state folder are relative to the file's folder.
/// The errors are lines that begin with file:line where there is a line.
[[nodiscard]] std::expected<Layer, std::vector<std::string>> read_configuration_file(const std::string& path);

/// The most files of a folder that configures.
inline constexpr std::size_t max_configuration_files = 64;

/// Reads files, and of folders the files whose names end in `.toml`, in the order of their names. What a later file
/// states beats what an earlier one states; a list replaces a whole list. Each path has the place where it was named.
[[nodiscard]] std::expected<Layer, std::vector<std::string>> read_configuration_files(const std::vector<Stated>& paths);

/// Reads a text as the file of this path.
[[nodiscard]] std::expected<Layer, std::vector<std::string>> read_configuration_text(const std::string& text,
                                                                                     const std::string& path);

}  // namespace geminga::daemon

#endif
