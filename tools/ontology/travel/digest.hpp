// BLAKE2b-256 (RFC 7693) by libsodium, which only digest.cpp names here.
#ifndef GEMINGA_ONTOLOGY_TRAVEL_DIGEST_HPP
#define GEMINGA_ONTOLOGY_TRAVEL_DIGEST_HPP

#include <string>
#include <string_view>

namespace geminga::ontology {

/// BLAKE2b-256 of the octets, as 64 lower-case hexadecimal digits.
[[nodiscard]] std::string blake2b(std::string_view octets);
/// Whether a text can be such a digest.
[[nodiscard]] bool is_blake2b(std::string_view text);

}  // namespace geminga::ontology

#endif
