#include "client/channels/endpoint.hpp"

#include "base/text.hpp"

namespace geminga::client {

std::string to_string(const Endpoint& endpoint) {
  if (!endpoint.path.empty()) return endpoint.path;
  const bool is_six = endpoint.address.contains(':');
  return (is_six ? '[' + endpoint.address + ']' : endpoint.address) + ':' + std::to_string(endpoint.port);
}

std::optional<Endpoint> endpoint(std::string_view text) {
  constexpr std::string_view scheme = "unix:";
  const bool has_scheme = text.starts_with(scheme);
  if (has_scheme || text.starts_with('/')) {
    if (has_scheme) text.remove_prefix(scheme.size());
    if (text.empty() || text.find('\0') != std::string_view::npos) return std::nullopt;
    return Endpoint{.address = "", .port = 0, .path = std::string(text)};
  }
  const auto colon = text.rfind(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto port = base::parse_number<std::uint16_t>(text.substr(colon + 1));
  std::string_view address = text.substr(0, colon);
  const bool has_brackets = address.starts_with('[') && address.ends_with(']');
  if (has_brackets) address = address.substr(1, address.size() - 2);
  if (!port || *port == 0 || address.empty() || (address.contains(':') && !has_brackets)) return std::nullopt;
  return Endpoint{.address = std::string(address), .port = *port};
}

std::vector<Endpoint> usual_endpoints() {
  return {{.address = "127.0.0.1", .port = 4717}, {.address = "::1", .port = 4717}};
}

}  // namespace geminga::client
