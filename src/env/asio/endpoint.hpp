// Addresses with ports, as flags, configuration and messages write them: `127.0.0.1:4717`, `[::1]:4717`.
#ifndef GEMINGA_ENV_ASIO_ENDPOINT_HPP
#define GEMINGA_ENV_ASIO_ENDPOINT_HPP

#include <compare>
#include <cstdint>
#include <expected>
#include <string>
#include <string_view>

namespace geminga::env {

/// A numeric IP address in its canonical form, and a port.
struct Endpoint {
  std::string address;
  std::uint16_t port = 0;
  friend auto operator<=>(const Endpoint&, const Endpoint&) = default;
};

/// A host by number or by name, and a port.
struct HostPort {
  std::string host;
  std::uint16_t port = 0;
  friend auto operator<=>(const HostPort&, const HostPort&) = default;
};

/// The longest host name (RFC 1035, 2.3.4).
inline constexpr std::size_t max_host_bytes = 253;

/// Reads `127.0.0.1:4717` or `[::1]:4717`. An IPv6 address needs brackets; port 0 is refused. The error is a half
/// sentence that says what the text is not.
[[nodiscard]] std::expected<Endpoint, std::string> parse_endpoint(std::string_view text);

/// Reads `robot2`, `robot2:4718`, `192.0.2.7`, `[fd00::7]:4718` or `fd00::7`. The port is `default_port` if none is
/// given.
[[nodiscard]] std::expected<HostPort, std::string> parse_host_port(std::string_view text, std::uint16_t default_port);

/// The canonical form of a numeric address without scope, or an error.
[[nodiscard]] std::expected<std::string, std::string> parse_address(std::string_view text);

/// Whether a numeric address (as parse_address() gives it) is in 127.0.0.0/8 or ::1.
[[nodiscard]] bool is_loopback(const std::string& address);
[[nodiscard]] bool is_multicast(const std::string& address);

/// The inverse of the readers above, with brackets around an IPv6 address.
[[nodiscard]] std::string to_string(const Endpoint& endpoint);
[[nodiscard]] std::string to_string(const HostPort& host);

}  // namespace geminga::env

#endif
