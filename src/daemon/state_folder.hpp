// The state folder, which keeps the daemon's identity across restarts.
#ifndef GEMINGA_DAEMON_STATE_FOLDER_HPP
#define GEMINGA_DAEMON_STATE_FOLDER_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <string>

namespace geminga::daemon {

/// The name of the file in the folder, and the most octets that it may have.
inline constexpr const char* identity_file = "identity";
inline constexpr std::size_t max_identity_file_bytes = 4096;

/// Reads the lasting identity in this folder, which is never 0. Where there is none, makes the folder (its parent must
/// exist), draws an identity and writes it, whole or not at all. A file with anything else is left alone and is an
/// error: a line that begins with the path.
[[nodiscard]] std::expected<std::uint32_t, std::string> lasting_identity(
    const std::string& folder, const std::function<std::uint64_t()>& random_bits);

}  // namespace geminga::daemon

#endif
