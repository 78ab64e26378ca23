#include "env/asio/endpoint.hpp"

#include <algorithm>
#include <optional>

#include "base/address.hpp"
#include "base/text.hpp"

namespace geminga::env {
namespace {

/// An address without a zone.
std::optional<base::Address> read_address(std::string_view text) {
  auto address = base::parse_address(text);
  if (address && !address->zone.empty()) return std::nullopt;
  return address;
}

std::string shown(std::string_view text) { return '\'' + base::printable(text) + '\''; }

std::expected<std::uint16_t, std::string> read_port(std::string_view text) {
  const auto port = base::parse_number<std::uint16_t>(text);
  if (!port || *port == 0) return std::unexpected(shown(text) + " is no port: use a number from 1 to 65535");
  return *port;
}

/// A host name of letters, digits, hyphens, underscores and dots; the resolver decides about the rest.
bool is_host_name(std::string_view text) {
  return !text.empty() && text.size() <= max_host_bytes && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '.' ||
           c == '_';
  });
}

std::string joined(const std::string& host, std::uint16_t port) {
  const bool needs_brackets = host.find(':') != std::string::npos;
  return (needs_brackets ? '[' + host + ']' : host) + ':' + std::to_string(port);
}

struct Halves {
  std::string_view host;
  std::optional<std::string_view> port;
};

/// Splits at the colon before the port; brackets, where there are any, are taken off.
std::optional<Halves> split(std::string_view text) {
  if (text.starts_with('[')) {
    const auto end = text.find(']');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view host = text.substr(1, end - 1);
    const std::string_view rest = text.substr(end + 1);
    if (host.find(':') == std::string_view::npos) return std::nullopt;
    if (rest.empty()) return Halves{host, std::nullopt};
    if (!rest.starts_with(':')) return std::nullopt;
    return Halves{host, rest.substr(1)};
  }
  const auto colon = text.find(':');
  if (colon == std::string_view::npos) return Halves{text, std::nullopt};
  if (text.find(':', colon + 1) != std::string_view::npos) return Halves{text, std::nullopt};  // an IPv6 address
  return Halves{text.substr(0, colon), text.substr(colon + 1)};
}

}  // namespace

std::expected<std::string, std::string> parse_address(std::string_view text) {
  const auto address = read_address(text);
  if (!address) return std::unexpected(shown(text) + " is no IP address");
  return address->text();
}

std::expected<Endpoint, std::string> parse_endpoint(std::string_view text) {
  const auto halves = split(text);
  if (!halves || !halves->port) {
    return std::unexpected(shown(text) + " is no ADDRESS:PORT: write it like 127.0.0.1:4717 or [::1]:4717");
  }
  const auto address = read_address(halves->host);
  if (!address) return std::unexpected(shown(halves->host) + " is no IP address");
  const auto port = read_port(*halves->port);
  if (!port) return std::unexpected(port.error());
  return Endpoint{address->text(), *port};
}

std::expected<HostPort, std::string> parse_host_port(std::string_view text, std::uint16_t default_port) {
  const auto halves = split(text);
  if (!halves) return std::unexpected(shown(text) + " is no HOST[:PORT]: write robot2:4717 or [fd00::7]:4717");
  HostPort result{std::string(halves->host), default_port};
  if (const auto address = read_address(halves->host)) {
    result.host = address->text();
  } else if (!is_host_name(halves->host)) {
    return std::unexpected(shown(halves->host) + " is neither an IP address nor a host name");
  }
  if (halves->port) {
    const auto port = read_port(*halves->port);
    if (!port) return std::unexpected(port.error());
    result.port = *port;
  }
  return result;
}

bool is_loopback(const std::string& address) {
  const auto read = read_address(address);
  return read && read->scope() == base::AddressScope::loopback;
}

bool is_multicast(const std::string& address) {
  const auto read = read_address(address);
  return read && read->scope() == base::AddressScope::multicast;
}

std::string to_string(const Endpoint& endpoint) { return joined(endpoint.address, endpoint.port); }
std::string to_string(const HostPort& host) { return joined(host.host, host.port); }

}  // namespace geminga::env
