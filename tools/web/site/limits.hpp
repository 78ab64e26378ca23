// Limits of a request beside those of its octets on the wire (web/server/limits.hpp).
#ifndef GEMINGA_WEB_SITE_LIMITS_HPP
#define GEMINGA_WEB_SITE_LIMITS_HPP

#include <cstddef>

namespace geminga::web {

/// Octets of the target of a request: path, `?` and query. A class expression of 1024 octets fits, each written as %XX.
inline constexpr std::size_t max_target_octets = 4096;
/// Parameters of one target.
inline constexpr std::size_t max_target_parameters = 64;
/// Octets of a token.
inline constexpr std::size_t min_token_octets = 16;
inline constexpr std::size_t max_token_octets = 256;
/// Requests without a provider that have a sample of their own in the metrics; all are in the sum.
inline constexpr std::size_t max_unmatched_samples = 256;
/// Neighbours that have samples of their own in the metrics.
inline constexpr std::size_t max_neighbour_samples = 1024;

}  // namespace geminga::web

#endif
