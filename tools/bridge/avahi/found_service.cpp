#include "bridge/avahi/found_service.hpp"

#include <algorithm>

#include "base/address.hpp"
#include "base/text.hpp"
#include "bridge/avahi/limits.hpp"
#include "identity/service_limits.hpp"

namespace geminga::bridge {
namespace {

bool is_letter_digit_hyphen(char octet) {
  return (octet >= 'a' && octet <= 'z') || (octet >= 'A' && octet <= 'Z') || (octet >= '0' && octet <= '9') ||
         octet == '-' || octet == '_';
}

/// The attributes of a TXT record: `dns.txt.KEY` for each string KEY=VALUE whose key can be one and whose value is
/// text.
void add_txt(const std::vector<std::string>& strings, Attributes& attributes) {
  std::size_t taken = 0;
  for (const std::string& one : strings) {
    const auto equals = one.find('=');
    const std::string key = "dns.txt." + one.substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : one.substr(equals + 1);
    if (equals == 0 || !base::is_key(key) || key.size() > max_attribute_key_bytes) continue;
    if (!base::is_valid_utf8(value) || base::has_control_character(value)) continue;
    if (value.size() > max_attribute_value_bytes || taken == max_txt_keys) continue;
    // The first of equal keys counts (RFC 6763, section 6.4).
    if (attributes.emplace(key, value).second) ++taken;
  }
}

}  // namespace

bool is_service_type(std::string_view text) {
  if (!text.ends_with("._tcp") && !text.ends_with("._udp")) return false;
  const std::string_view name = text.substr(0, text.size() - std::string_view("._tcp").size());
  return name.size() >= 2 && name.size() <= max_label_bytes && name.front() == '_' &&
         std::ranges::all_of(name.substr(1), is_letter_digit_hyphen);
}

bool is_shareable(std::string_view text) {
  using Scope = base::AddressScope;
  const auto address = base::parse_address(text);
  if (!address) return false;
  const Scope scope = address->scope();
  return scope == Scope::private_use || scope == Scope::global || (scope == Scope::link_local && !address->is_ipv6());
}

std::expected<Foreign, std::string_view> foreign_of(const FoundService& service) {
  if (!is_service_type(service.type)) return std::unexpected("types that are none of DNS-SD");
  if (service.port == 0) return std::unexpected("services without a port");
  if (!is_shareable(service.address)) return std::unexpected(no_shareable_address);
  if (!base::is_valid_utf8(service.name)) return std::unexpected("names that are no UTF-8");
  NamedPublication publication{.identity = TextIdentity{service.type},
                               .mode = ChannelMode::one_to_one,
                               .address = service.address,
                               .port = service.port,
                               .protocol = "dns-sd",
                               .priority = 0,
                               .attributes = {}};
  Attributes& attributes = publication.attributes;
  attributes[std::string(bridge_attribute)] = "dns-sd";
  const auto shown = [](const std::string& text) {
    return base::printable(text, max_shown_name_bytes - std::string_view("...").size());
  };
  attributes["dns.name"] = shown(service.name);
  attributes["dns.type"] = service.type;
  attributes["dns.host"] = shown(service.host);
  attributes["dns.domain"] = shown(service.domain);
  add_txt(service.txt, attributes);
  return Foreign{std::move(publication), service.type};
}

}  // namespace geminga::bridge
