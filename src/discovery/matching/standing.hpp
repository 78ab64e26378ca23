// The standing of one publication in the arbitration of one subscription, for `geminga-query why`.
#ifndef GEMINGA_DISCOVERY_MATCHING_STANDING_HPP
#define GEMINGA_DISCOVERY_MATCHING_STANDING_HPP

#include <cstddef>
#include <cstdint>

#include "discovery/registry/entry.hpp"

namespace geminga::matching {

/// The place of a publication among all that match a subscription.
struct Place {
  std::size_t rank = 0;        ///< from 1
  std::size_t candidates = 0;  ///< how many match
  /// The last publication within the limit, where this one is not within it; null where that is not known. Borrowed
  /// until the next change of the matcher.
  const registry::PublicationEntry* last = nullptr;
};

/// The standing of a pair that matches.
struct Standing {
  /// The reason why a publication is chosen or not.
  enum class Decided : std::uint8_t {
    by_rank,       ///< the best up to the limit are chosen
    by_incumbent,  ///< one that was chosen first keeps its place against one that is better only by its key
    by_consumer,   ///< its consumer's host has announced its choice
    elsewhere,     ///< another host chooses; this is what it chooses if it has no incumbent
  };

  std::size_t rank = 0;        ///< from 1, among all that match
  std::size_t candidates = 0;  ///< how many match
  bool is_chosen = false;
  Decided decided = Decided::by_rank;
  /// The publication that is chosen in its place; null where it is chosen. Borrowed until the next change of the
  /// matcher.
  const registry::PublicationEntry* rival = nullptr;
};

}  // namespace geminga::matching

#endif
