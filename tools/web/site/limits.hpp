// Limits of a request beside those of its octets on the wire (web/server/limits.hpp).
#ifndef GEMINGA_WEB_SITE_LIMITS_HPP
#define GEMINGA_WEB_SITE_LIMITS_HPP

#include <chrono>
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

/// The time for which happenings are kept unless told, and the longest that may be told.
inline constexpr std::chrono::seconds usual_history = std::chrono::hours(1);
inline constexpr std::chrono::seconds longest_history = std::chrono::hours(24);
/// Happenings that are kept, and their octets: keys, reasons, records as JSON, and what each costs beside them.
inline constexpr std::size_t max_happenings = 20'000;
inline constexpr std::size_t max_history_octets = std::size_t{16} * 1024 * 1024;
inline constexpr std::size_t happening_cost = 128;
/// The pause between two looks. Shorter: moments are told apart better, and the daemon has more work. Longer: the
/// reverse.
inline constexpr std::chrono::seconds history_pause{1};
/// The numbers are kept of each look of so many.
inline constexpr std::size_t sample_every = 10;

}  // namespace geminga::web

#endif
