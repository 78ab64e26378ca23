// What a daemon remembers from one life to the next: who it is.
#ifndef GEMINGA_DAEMON_STATE_FOLDER_HPP
#define GEMINGA_DAEMON_STATE_FOLDER_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <string>

namespace geminga::daemon {

/// The name of the file in the folder, and the most that is read of it.
inline constexpr const char* identity_file = "identity";
inline constexpr std::size_t max_identity_file_bytes = 4096;

/// The lasting identity in this folder, never 0. Where there is none yet the folder is made, if the one that it lies in
/// is there, and an identity drawn and written, whole or not at all. What stands there and is no identity is left
/// alone; the error is a line that begins with the path.
[[nodiscard]] std::expected<std::uint32_t, std::string> lasting_identity(
    const std::string& folder, const std::function<std::uint64_t()>& random_bits);

}  // namespace geminga::daemon

#endif
