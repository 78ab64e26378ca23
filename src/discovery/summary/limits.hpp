// The limits and times of summaries (SUMMARY.md).
#ifndef GEMINGA_DISCOVERY_SUMMARY_LIMITS_HPP
#define GEMINGA_DISCOVERY_SUMMARY_LIMITS_HPP

#include <cstddef>

#include "base/time.hpp"

namespace geminga::summary {

/// The octets of a message. NATS servers take 1 MiB unless they are told otherwise, MQTT brokers of small machines
/// less.
inline constexpr std::size_t max_message_bytes = 65536;
/// As an IRI of an announcement.
inline constexpr std::size_t max_iri_bytes = 255;
/// Announced datagrams in one listing, and their size (ANNOUNCEMENT.md, "Content").
inline constexpr std::size_t max_listed = 512;
inline constexpr std::size_t max_listed_bytes = 1200;
/// 2^32 - 1 services need 32 bits.
inline constexpr unsigned max_magnitude = 32;

/// Concepts that a site wants to know of.
inline constexpr std::size_t max_interests = 1024;
/// Answers that are remembered for all interests together.
inline constexpr std::size_t max_remembered = std::size_t{1} << 18;
/// Concepts that a site says something of because it was asked, or still does.
inline constexpr std::size_t max_asked = std::size_t{1} << 16;

/// An interest is asked again so long after anybody has asked for its concept, ± 20 %.
inline constexpr base::Duration ask_again = std::chrono::minutes(20);
/// Changes of a concept are said for so long after it was last asked for: three times ask_again.
inline constexpr base::Duration asked_for = std::chrono::minutes(60);
/// An answer about a concept counts for so long: the next answers and one lost round.
inline constexpr base::Duration remembered_for = std::chrono::minutes(60);
/// Answers to one question come at random within this time, and more of it where many sites answer.
inline constexpr base::Duration answer_spread = std::chrono::milliseconds(200);
/// Two changes of one concept are said so far apart.
inline constexpr base::Duration change_spacing = std::chrono::seconds(10);

}  // namespace geminga::summary

#endif
