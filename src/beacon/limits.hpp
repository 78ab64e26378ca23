// Every number that an announcement must keep; src/beacon/ANNOUNCEMENT.md names the same ones.
#ifndef GEMINGA_BEACON_LIMITS_HPP
#define GEMINGA_BEACON_LIMITS_HPP

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "base/time.hpp"

namespace geminga::beacon {

/// The largest datagram. Fits into one frame of every link that IPv6 runs on (RFC 8200 section 5: 1280 octets), with
/// its headers and 32 octets left for an envelope.
inline constexpr std::size_t max_datagram_bytes = 1200;
/// What one publication or subscription may take of a datagram, its share of the tables included. The rest is kept for
/// the largest possible header, so whether a service fits depends on nothing but the service.
inline constexpr std::size_t max_entry_bytes = 720;

/// Names of groups, participants and peers, in octets of UTF-8.
inline constexpr std::size_t max_name_bytes = 64;
/// A text identity, in octets.
inline constexpr std::size_t max_text_identity_bytes = 255;
/// A concept or representation IRI, in octets.
inline constexpr std::size_t max_iri_bytes = 255;
/// A class expression that is asked for instead of a concept, in octets of its canonical form.
inline constexpr std::size_t max_expression_bytes = 400;
/// The word for a transport protocol, in octets.
inline constexpr std::size_t max_protocol_bytes = 32;
/// Protocols that one subscription accepts.
inline constexpr std::size_t max_accepted_protocols = 8;
/// Attributes of one service, and the octets of a key and of a value.
inline constexpr std::size_t max_attributes = 32;
inline constexpr std::size_t max_attribute_key_bytes = 64;
inline constexpr std::size_t max_attribute_value_bytes = 255;
/// A `where` expression, in octets.
inline constexpr std::size_t max_where_bytes = 400;
/// Provider filters of one subscription.
inline constexpr std::size_t max_provider_filters = 16;
/// Addresses of one interface; further ones are not announced.
inline constexpr std::size_t max_addresses = 8;

/// Publications and subscriptions of one participant together. The daemon refuses one more by 429.
inline constexpr std::size_t max_services_per_participant = 1024;
/// Parts of one state: enough for the most services, each alone in its part.
inline constexpr std::size_t max_parts = max_services_per_participant;
/// Participants that are remembered. One more is not: a known participant never gives way to a new one.
inline constexpr std::size_t max_participants = 256;
/// Publications and subscriptions of all remote participants together; further ones are not taken.
inline constexpr std::size_t max_remote_services = 8192;
/// Ways on which one participant is heard (our interface and its interface); further ones are not used.
inline constexpr std::size_t max_paths = 4;

/// The announced interval. A shorter one would be a flood, a longer one would keep the dead for minutes.
inline constexpr base::Duration min_interval = std::chrono::milliseconds(50);
inline constexpr base::Duration max_interval = std::chrono::seconds(60);

}  // namespace geminga::beacon

#endif
