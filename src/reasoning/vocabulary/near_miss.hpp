// Near misses in words: a candidate that lacks something to be what is asked for.
#ifndef GEMINGA_REASONING_VOCABULARY_NEAR_MISS_HPP
#define GEMINGA_REASONING_VOCABULARY_NEAR_MISS_HPP

#include <cstddef>
#include <string>
#include <vector>

namespace geminga::vocabulary {

/// One way to make a candidate match (reasoning/explanation/abduction). Expressions are written with short names, so
/// that read() takes them again.
struct NearMiss {
  /// Conjuncts of the request that are not known of the candidate, and of those that contradict it. One that is nested
  /// in a restriction is written `Fragile within hasPart some (Gripper and Fragile)`.
  std::vector<std::string> lacking;
  std::vector<std::string> contradicting;
  /// Their numbers, where those that are nested count one by one.
  std::size_t lacking_count = 0;
  std::size_t contradicting_count = 0;
  std::string added;    ///< an expression: the candidate and this matches what is left; empty: nothing is lacking
  std::string request;  ///< the rest of the request
  /// Whether the candidate with what is left of the request has a model; otherwise no contradiction is known.
  bool is_possible = false;
};

/// The result of Vocabulary::near_misses(). Equal on every host that has the same ontology.
struct NearMisses {
  std::vector<NearMiss> ranked;  ///< the smallest first: by what contradicts, then by what is lacking
  std::string reservation;       ///< why there may be smaller or other ways, one line; empty: there are not
};

}  // namespace geminga::vocabulary

#endif
