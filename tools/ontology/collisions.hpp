// Names whose 32-bit identities are equal. They cost a comparison and never a match, but whoever names things may care.
#ifndef GEMINGA_ONTOLOGY_COLLISIONS_HPP
#define GEMINGA_ONTOLOGY_COLLISIONS_HPP

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

/// The collisions among these concepts, alone and with each representation, ascending by id. Pairs are left out when
/// there are more than `max_pairs`, and `is_whole` is false then.
struct Collisions {
  std::vector<Collision> found;
  bool is_whole = true;
};
[[nodiscard]] Collisions find_collisions(const std::vector<std::string>& concept_iris,
                                         const std::vector<std::string>& representation_iris);
/// The same for what an ontology holds below geminga:Concept and geminga:Representation, or for all its classes where
/// it knows neither.
[[nodiscard]] Collisions find_collisions(const compiled::Ontology& ontology);

}  // namespace geminga::ontology

#endif
