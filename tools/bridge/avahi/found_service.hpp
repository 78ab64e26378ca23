// A service that Avahi has found, and the publication that it becomes.
#ifndef GEMINGA_BRIDGE_AVAHI_FOUND_SERVICE_HPP
#define GEMINGA_BRIDGE_AVAHI_FOUND_SERVICE_HPP

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bridge/team/foreign_services.hpp"

namespace geminga::bridge {

/// A service of DNS-SD as its host says it is; every text may be anything.
struct FoundService {
  std::string name;
  std::string type;    ///< e.g. `_ipp._tcp`
  std::string domain;  ///< e.g. `local`
  std::string host;
  std::string address;  ///< numeric
  std::uint16_t port = 0;
  std::vector<std::string> txt;  ///< the strings of the TXT record
};

/// The type of our own services, by transport. Nothing of it is taken from others: it is Geminga that finds them.
inline constexpr std::string_view own_udp_type = "_geminga._udp";
inline constexpr std::string_view own_tcp_type = "_geminga._tcp";

/// Whether a text is the type of a service: `_NAME._tcp` or `_NAME._udp` with letters, digits and hyphens (RFC 6335,
/// section 5.1; longer names than its 15 letters are in use and taken, up to a label).
[[nodiscard]] bool is_service_type(std::string_view text);
[[nodiscard]] inline bool is_own_type(std::string_view type) { return type == own_udp_type || type == own_tcp_type; }

/// Whether other hosts can use a numeric address. An IPv6 address of a link means something only with an interface of
/// this host.
[[nodiscard]] bool is_shareable(std::string_view address);
/// The reason by which a service without such an address is counted.
inline constexpr std::string_view no_shareable_address = "services without an address that others can use";

/// The publication of a found service: mode `oto`, protocol `dns-sd`, the type as its text and as the name of a
/// concept, and what else is known as attributes. The error is the reason by which it is counted.
[[nodiscard]] std::expected<Foreign, std::string_view> foreign_of(const FoundService& service);

}  // namespace geminga::bridge

#endif
