// The limits of an ontology that travels (TRAVEL.md).
#ifndef GEMINGA_ONTOLOGY_TRAVEL_LIMITS_HPP
#define GEMINGA_ONTOLOGY_TRAVEL_LIMITS_HPP

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace geminga::ontology {

/// Files of one ontology, octets of the name of each, and octets of all their contents together.
inline constexpr std::size_t max_travelling_files = 256;
inline constexpr std::size_t max_travelling_name = 128;
inline constexpr std::size_t max_travelling_octets = std::size_t{64} << 20U;
/// Octets of each piece but the last one.
inline constexpr std::size_t piece_octets = std::size_t{64} << 10U;
/// Octets of a manifest: more than max_travelling_files lines of files and the lines of all pieces.
inline constexpr std::size_t max_manifest_octets = std::size_t{256} << 10U;
/// Octets of a message. zlib lengthens what it cannot shorten by less than a thousandth.
inline constexpr std::size_t max_travelling_message = max_manifest_octets + 64;
/// The greatest version, so that every language can count it.
inline constexpr std::uint64_t max_travelling_version = (std::uint64_t{1} << 53U) - 1;

/// How often a consumer is sent the pieces anew where something was left out for somebody.
inline constexpr std::uint32_t max_laps = 8;
/// The octets of messages that brought nothing new, beyond which a provider floods: so many times the ontology, and
/// some more.
inline constexpr std::size_t max_useless_rounds = max_laps + 1;
inline constexpr std::size_t max_useless_octets = std::size_t{1} << 20U;

/// The time for which a consumer that does not keep up delays a piece for all; and where all who lack pieces are those
/// for whom one was left out already.
inline constexpr std::chrono::milliseconds piece_patience{5};
inline constexpr std::chrono::milliseconds repeated_piece_patience{500};
/// The time within which a provider must bring something new. TCP that loses three of ten segments is silent for half
/// a minute now and then.
inline constexpr std::chrono::seconds stall_patience{45};

}  // namespace geminga::ontology

#endif
