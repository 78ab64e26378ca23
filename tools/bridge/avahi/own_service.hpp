// A service of the team, as it is announced by DNS-SD.
#ifndef GEMINGA_BRIDGE_AVAHI_OWN_SERVICE_HPP
#define GEMINGA_BRIDGE_AVAHI_OWN_SERVICE_HPP

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::bridge {

struct OwnService {
  std::string label;    ///< the name, e.g. `soccer:BallInfo 1a2b3c4d/1/42`, at most max_label_bytes
  std::string type;     ///< `_geminga._tcp` for protocol tcp, else `_geminga._udp` (RFC 6763, section 7)
  std::string host;     ///< the first label of the name of a host of its own; empty: it is this host
  std::string address;  ///< of that host
  std::uint16_t port = 0;
  std::vector<std::string> txt;  ///< at most max_txt_bytes
  bool is_cut = false;           ///< attributes were left out of the TXT record
  friend bool operator==(const OwnService&, const OwnService&) = default;
};

/// The service of a line of `query services`; nothing for one of a bridge, and for one without a port. `addresses` are
/// those of this host. The TXT record has `txtvers=1`, the identity as in GCNP (`concept`, `representation`, `text`,
/// `id`), `mode`, `protocol`, `priority`, `service`, `name`, `participant_name`, and then the attributes, each as
/// `attr.KEY`.
[[nodiscard]] std::optional<OwnService> own_service(const Record& line, const std::set<std::string>& addresses);

}  // namespace geminga::bridge

#endif
