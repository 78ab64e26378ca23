// Whether a service can be announced: every limit and grammar that a datagram must keep, with the answer that a peer
// gets.
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_ANNOUNCEABLE_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_ANNOUNCEABLE_HPP

#include <optional>
#include <string_view>

#include "geminga/error.hpp"
#include "geminga/service.hpp"

namespace geminga::announcement {

/// The reason why this publication cannot be announced, or nothing. 413: it is over a named size limit (limits.hpp), or
/// over max_entry_bytes in all. 400: a control character, bad UTF-8, port 0, a protocol or key that is no word, or an
/// IRI with characters that no IRI has. 422: an address that is no numeric IP address, or the unspecified one. An IPv6
/// link-local address may have a zone (`fe80::1%eth0`). The text names the field, its size and the limit. The result
/// depends only on the publication.
[[nodiscard]] std::optional<Error> check(const Publication& publication);
/// The same for a subscription; its port may be 0.
[[nodiscard]] std::optional<Error> check(const Subscription& subscription);

/// Whether a participant or peer may have this name: 1 to max_name_bytes octets of UTF-8 without control characters,
/// `/` and `,`.
[[nodiscard]] bool is_valid_name(std::string_view name);

/// Whether the text can be an IRI in an announcement: 1 to max_iri_bytes octets of UTF-8 without control characters,
/// space and any of `<>"{}|\^` and backquote (RFC 3987 section 2.2, as RDF 1.1 Turtle's IRIREF).
[[nodiscard]] bool is_valid_iri(std::string_view iri);

}  // namespace geminga::announcement

#endif
