// How two class expressions of a vocabulary relate.
#ifndef GEMINGA_REASONING_VOCABULARY_COMPARISON_HPP
#define GEMINGA_REASONING_VOCABULARY_COMPARISON_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace geminga::vocabulary {

/// The result of Vocabulary::compare(). Equal on every host that has the same ontology.
struct Comparison {
  enum class Relation : std::uint8_t {
    equivalent,
    narrower,  ///< every instance of the first is one of the second
    broader,   ///< every instance of the second is one of the first
    apart,     ///< neither is known to subsume the other
  };
  Relation relation = Relation::apart;
  /// The edges of the shortest way up from one to the other, as if both were classes of the taxonomy; 0 for equivalent
  /// ones.
  std::uint32_t distance = 0;
  /// Of apart: the reasons why a subsumption may be missed, short words; empty where none is.
  std::vector<std::string> gaps{};
  friend bool operator==(const Comparison&, const Comparison&) = default;
};

}  // namespace geminga::vocabulary

#endif
