// How one publication stands in the arbitration of one subscription; what `geminga-query why` tells.
#ifndef GEMINGA_DISCOVERY_MATCHING_STANDING_HPP
#define GEMINGA_DISCOVERY_MATCHING_STANDING_HPP

#include <cstddef>
#include <cstdint>

#include "discovery/registry/entry.hpp"

namespace geminga::matching {

/// Where a publication ranks among all that match a subscription.
struct Place {
  std::size_t rank = 0;        ///< from 1
  std::size_t candidates = 0;  ///< how many match
  /// The last within the limit, where the publication is not; null where that is not known. Borrowed until the next
  /// change of the matcher.
  const registry::PublicationEntry* last = nullptr;
};

/// Of a pair that matches.
struct Standing {
  /// Why a publication that ranks behind the limit is chosen all the same, or one within it is not.
  enum class Decided : std::uint8_t {
    by_rank,       ///< the best up to the limit are chosen
    by_incumbent,  ///< one that was there first keeps its place against one that is no better but for its key
    by_consumer,   ///< its consumer's host has announced its choice
    elsewhere,     ///< its consumer is on another host, which is not asked; this is what it chooses if nobody was first
  };

  std::size_t rank = 0;        ///< from 1, among all that match
  std::size_t candidates = 0;  ///< how many match
  bool is_chosen = false;
  Decided decided = Decided::by_rank;
  /// Who has the place that it does not get; null where it is chosen. Borrowed until the next change of the matcher.
  const registry::PublicationEntry* rival = nullptr;
};

}  // namespace geminga::matching

#endif
