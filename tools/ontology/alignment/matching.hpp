// The links between two ontologies that names and structure suggest.
#ifndef GEMINGA_ONTOLOGY_ALIGNMENT_MATCHING_HPP
#define GEMINGA_ONTOLOGY_ALIGNMENT_MATCHING_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "ontology/alignment/lexicon.hpp"

namespace geminga::ontology {

/// That an entity of the one ontology is equivalent to one of the other.
struct Link {
  owl::TermKind kind{};
  std::string one;        ///< IRI
  std::string other;      ///< IRI
  double confidence = 0;  ///< in (0, 1]
  std::string reason;     ///< in words
};

/// A link needs this much confidence. Chosen by hand; no public track of alignments was looked at.
inline constexpr double least_confidence = 0.7;

/// Each entity is in at most one link; best first, and equal ones by IRI. The same on every machine. Names that share a
/// word are compared, but for words that most names have.
[[nodiscard]] std::vector<Link> match(const Lexicon& one, const Lexicon& other);

}  // namespace geminga::ontology

#endif
