// Whether two classes of a vocabulary can have instances in common.
#ifndef GEMINGA_REASONING_VOCABULARY_OVERLAP_HPP
#define GEMINGA_REASONING_VOCABULARY_OVERLAP_HPP

#include <cstdint>
#include <string>

namespace geminga::vocabulary {

/// The result of Vocabulary::overlap(). Equal on every host that has the same ontology.
struct Overlap {
  enum class Verdict : std::uint8_t {
    possible,    ///< something can be both; this takes every axiom into account
    impossible,  ///< nothing can be both
    undecided,   ///< axioms were left out, or a limit ended the search
  };
  Verdict verdict = Verdict::undecided;
  /// Of possible: the edges of the shortest way up from one to a class that is above both, and down to the other.
  std::uint32_t distance = 0;
  std::string reason{};  ///< of undecided: one line for a user
};

}  // namespace geminga::vocabulary

#endif
