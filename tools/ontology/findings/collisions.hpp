// Names with equal 32-bit identities. A collision costs a comparison and never makes a match.
#ifndef GEMINGA_ONTOLOGY_FINDINGS_COLLISIONS_HPP
#define GEMINGA_ONTOLOGY_FINDINGS_COLLISIONS_HPP

#include <string>
#include <vector>

#include "geminga/identity.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/owl/axiom.hpp"

namespace geminga::ontology {

struct Collision {
  Id32 id = 0;
  std::vector<std::string> names;  ///< canonical forms, sorted
};

struct Collisions {
  std::vector<Collision> found;  ///< ascending by id
  bool is_whole = true;          ///< false: pairs of a concept and a representation were too many to compare
};

/// Finds collisions among these concepts, alone and with each representation.
[[nodiscard]] Collisions find_collisions(const std::vector<std::string>& concept_iris,
                                         const std::vector<std::string>& representation_iris);
/// Finds collisions among the classes below geminga:Concept and geminga:Representation. Where the ontology has no
/// geminga:Concept, all its classes are concepts.
[[nodiscard]] Collisions find_collisions(const compiled::Ontology& ontology);

}  // namespace geminga::ontology

#endif
