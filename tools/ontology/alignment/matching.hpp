// The links between two ontologies that names and structure suggest.
#ifndef GEMINGA_ONTOLOGY_ALIGNMENT_MATCHING_HPP
#define GEMINGA_ONTOLOGY_ALIGNMENT_MATCHING_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "ontology/alignment/lexicon.hpp"
#include "ontology/alignment/thesaurus.hpp"

namespace geminga::ontology {

/// How an entity of the one ontology is related to one of the other.
enum class Relation { equivalent, narrower, broader };

/// "=", "<" or ">".
[[nodiscard]] char sign_of(Relation relation);

/// A relation between an entity of the one ontology and one of the other.
struct Link {
  owl::TermKind kind{};
  Relation relation = Relation::equivalent;
  std::string one;        ///< IRI
  std::string other;      ///< IRI
  double confidence = 0;  ///< in (0, 1]
  std::string reason;     ///< in words
};

/// A link needs this much confidence. Chosen by hand; no public track of alignments was looked at.
inline constexpr double least_confidence = 0.66;

/// Each entity is in at most one link; best first, and equal ones by IRI. The same on every machine with the same
/// thesaurus. Names that share a key are compared, but for keys that very many names have.
[[nodiscard]] std::vector<Link> match(const Lexicon& one, const Lexicon& other, const Thesaurus& thesaurus);

/// Classes without an equivalent one whose names end with the name of a class of the other ontology are narrower than
/// it: a laser scanner is a scanner. Left out is what follows from `equivalences` and the classes that are told above.
[[nodiscard]] std::vector<Link> narrower_classes(const Lexicon& one, const Lexicon& other,
                                                 const std::vector<Link>& equivalences);

/// Drops links of entities that both ontologies have, such as those of an ontology that both import: the two mean the
/// same by them already, and a link would only say something new within one of them.
void drop_links_of_shared(const Lexicon& one, const Lexicon& other, std::vector<Link>& links);

}  // namespace geminga::ontology

#endif
