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

struct LastingIdentity {
  std::uint32_t number = 0;  ///< never 0
  std::string remark;        ///< a line for the log; empty: there is nothing to say
};

/// Reads the lasting identity in this folder. Where there is none, makes the folder (its parent must exist), draws an
/// identity and writes it, whole or not at all. So it does with a remark where the file is empty or has no octet but
/// zeros, which is what a power cut or a full disk leaves of a file. A file with anything else is left alone and is an
/// error: a line that begins with the path.
[[nodiscard]] std::expected<LastingIdentity, std::string> lasting_identity(
    const std::string& folder, const std::function<std::uint64_t()>& random_bits);

}  // namespace geminga::daemon

#endif
