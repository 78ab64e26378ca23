#include "client/cpp/endpoint.hpp"

#include "base/text.hpp"

namespace geminga::client {

std::string to_string(const Endpoint& endpoint) {
  const bool is_six = endpoint.address.contains(':');
  return (is_six ? '[' + endpoint.address + ']' : endpoint.address) + ':' + std::to_string(endpoint.port);
}

std::optional<Endpoint> endpoint(std::string_view text) {
  const auto colon = text.rfind(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto port = base::parse_number<std::uint16_t>(text.substr(colon + 1));
  std::string_view address = text.substr(0, colon);
  const bool has_brackets = address.starts_with('[') && address.ends_with(']');
  if (has_brackets) address = address.substr(1, address.size() - 2);
  if (!port || *port == 0 || address.empty() || (address.contains(':') && !has_brackets)) return std::nullopt;
  return Endpoint{std::string(address), *port};
}

std::vector<Endpoint> usual_endpoints() { return {{"127.0.0.1", 4717}, {"::1", 4717}}; }

}  // namespace geminga::client
