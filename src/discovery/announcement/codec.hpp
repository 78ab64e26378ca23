// Announcements as datagrams and back. src/discovery/announcement/ANNOUNCEMENT.md is the specification,
// announcement.proto the schema.
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_CODEC_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_CODEC_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "discovery/announcement/announcement.hpp"

namespace geminga::announcement {

/// The reason why a datagram was refused. Words are only ever appended; to_string() gives the word for counters and the
/// log.
enum class DecodeError : std::uint8_t {
  too_large,       ///< over max_datagram_bytes
  not_protobuf,    ///< cannot be parsed: truncated, random, or bad UTF-8
  not_geminga,     ///< the magic number is missing
  other_version,   ///< another major version of the format
  bad_kind,        ///< an unknown kind
  bad_identifier,  ///< participant, peer or service number 0, or one given twice
  bad_name,        ///< a name too long, with control characters, `/` or `,`
  bad_interval,    ///< outside [min_interval, max_interval], or doubled more than max_doublings times
  bad_part,        ///< part not below the number of parts, or more than max_parts
  bad_address,     ///< not 4 or 16 octets, at which no host can be reached, or too many
  bad_table,       ///< an index into the tables of namespaces and terms that is out of range
  bad_identity,    ///< no identity, one that is too long, or an IRI with characters that no IRI has
  bad_mode,        ///< an unknown channel mode
  bad_degree,      ///< an unknown degree of match
  bad_port,        ///< over 65535, or 0 for a publication
  bad_protocol,    ///< too long or not a word
  bad_attribute,   ///< a limit or the grammar of attributes is violated
  bad_filter,      ///< a limit of provider filters or of the where expression is violated
  bad_witness,     ///< testimony of a wrong size, too many names, the identifier 0, or a wrong introduction
  bad_change,      ///< a change that begins from its own revision or a later one
  bad_diagnosis,   ///< an inquiry or a diagnosis of nobody, or lines over their limits or with control characters
  bad_relayed,     ///< a word or testimony of a relay over its limits, or without a way
};
inline constexpr std::size_t decode_error_count = 22;

/// "too-large", "not-protobuf", ... Static storage.
[[nodiscard]] std::string_view to_string(DecodeError error);

/// Reads one datagram. Everything in the result is valid and within the named limits: a caller need not check again.
/// Unknown fields are ignored (a newer minor version). Linear in the size of the datagram; allocates at most a small
/// multiple of it (each octet of the term table may be repeated once an entry). Takes bytes from anywhere.
[[nodiscard]] std::expected<Announcement, DecodeError> decode(std::span<const std::byte> datagram);
/// Reads into an announcement whose memory is reused: if it and the last one are presences, nothing is allocated.
/// Nothing: it was read. After an error the announcement is of no use.
[[nodiscard]] std::optional<DecodeError> decode(std::span<const std::byte> datagram, Announcement& announcement);

using Datagram = std::vector<std::byte>;

/// The lines from the first one on that fit into one diagnosis.
[[nodiscard]] std::size_t fitting_lines(const Announcement& diagnosis);

/// Writes an announcement as one datagram, or a state that does not fit as several. They are numbered from
/// `announcement.sequence` on; the caller's next sequence number is greater by their count. Each has at most
/// max_datagram_bytes and is complete in itself; a part of a state has max_said_bytes if its services allow it.
/// Testimony of a relay that does not fit into one presence takes further ones. Equal announcements give equal bytes.
///
/// Peers without a service are left out. A change that does not fit into one datagram gives none: only the state tells
/// it. An inquiry is padded to max_datagram_bytes; of a diagnosis the lines that do not fit are left out. A service
/// that does not pass check() (announceable.hpp) and services beyond max_services_per_participant are left out: the
/// caller has refused them before. Names and addresses over their limits are cut. Requires a participant other than 0,
/// and an interval within its limits.
[[nodiscard]] std::vector<Datagram> encode(const Announcement& announcement);

}  // namespace geminga::announcement

#endif
