// Extends a taxonomy by subsumptions that another engine has found.
#ifndef GEMINGA_REASONING_REASONER_TAXONOMY_HPP
#define GEMINGA_REASONING_REASONER_TAXONOMY_HPP

#include <cstdint>
#include <utility>
#include <vector>

#include "reasoning/owl/source.hpp"
#include "reasoning/taxonomy/classification.hpp"

namespace geminga::reasoner {

/// Subsumptions between classes, by their numbers in one classification: sub, super. Unsatisfiable classes are below
/// owl:Nothing.
using Subsumptions = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Adds the subsumptions that are new, and reduces the taxonomy again. Classes keep their numbers. Linear in classes
/// and subsumptions, except for sorting.
void extend(taxonomy::Classification& classification, const Subsumptions& more);

/// Makes the taxonomy that of an inconsistent ontology: one node of all classes, and one of all properties.
void contradict(taxonomy::Classification& classification, const owl::Ontology& source);

/// The strict superclasses of each representative, as representatives without owl:Thing's, ascending.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> find_ancestors(const taxonomy::Classification& classification);

}  // namespace geminga::reasoner

#endif
