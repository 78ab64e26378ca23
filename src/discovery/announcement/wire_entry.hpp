// One service as its message of announcement.proto.
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_WIRE_ENTRY_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_WIRE_ENTRY_HPP

#include <optional>
#include <string>

#include "discovery/announcement/announcement.hpp"
#include "discovery/announcement/announcement.pb.h"
#include "discovery/announcement/term_table.hpp"
#include "discovery/announcement/version.hpp"

namespace geminga::announcement {

/// 'G', 'M', 'N', before the major version in a little-endian fixed32.
inline constexpr std::uint32_t format_magic = 0x4E4D47;

/// The text of an address of 4 or 16 octets; nothing: it has others, or no host can be reached at it.
[[nodiscard]] std::optional<std::string> address_of(const std::string& octets);
/// The octets of a numeric address; empty for any other text.
[[nodiscard]] std::string address_octets(const std::string& text);

/// Writes a service. Requires that find_fault() finds none. Adds the identity's IRIs to `terms`.
[[nodiscard]] wire::Publication to_wire(const NumberedPublication& numbered, TermTable& terms);
[[nodiscard]] wire::Subscription to_wire(const NumberedSubscription& numbered, TermTable& terms);

}  // namespace geminga::announcement

#endif
