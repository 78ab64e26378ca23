// The endpoint of a daemon, read from `ADDRESS:PORT`, a path, or `unix:PATH`.
#ifndef GEMINGA_CLIENT_CHANNELS_ENDPOINT_HPP
#define GEMINGA_CLIENT_CHANNELS_ENDPOINT_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::client {

struct Endpoint {
  std::string address;  ///< in numbers, without brackets
  std::uint16_t port = 0;
  std::string path{};  ///< of a Unix socket; if it is not empty, the others mean nothing
  friend bool operator==(const Endpoint&, const Endpoint&) = default;
};

/// `127.0.0.1:4717`, or the path.
[[nodiscard]] std::string to_string(const Endpoint& endpoint);

/// The endpoint of `ADDRESS:PORT`, `[ADDRESS]:PORT`, `/PATH` or `unix:PATH`; nothing for another form. Address and path
/// are not checked.
[[nodiscard]] std::optional<Endpoint> endpoint(std::string_view text);

/// The endpoints of a gemingad without configuration, in the order in which a client tries them.
[[nodiscard]] std::vector<Endpoint> usual_endpoints();

}  // namespace geminga::client

#endif
