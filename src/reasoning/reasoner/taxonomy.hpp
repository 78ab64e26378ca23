// A taxonomy that learns of subsumptions which another engine has found.
#ifndef GEMINGA_REASONING_REASONER_TAXONOMY_HPP
#define GEMINGA_REASONING_REASONER_TAXONOMY_HPP

#include <cstdint>
#include <utility>
#include <vector>

#include "reasoning/el/classify.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::reasoner {

/// Subsumptions between classes, by their numbers in one classification: sub, super. Below owl:Nothing is what can have
/// no instance.
using Subsumptions = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Adds what is not in the taxonomy yet and reduces it again. Numbers of classes stay. Linear in classes and
/// subsumptions but for sorting.
void extend(taxonomy::Classification& classification, const Subsumptions& more);

/// Says that nothing can be: one node of all classes, and of all properties.
void contradict(taxonomy::Classification& classification, const owl::Ontology& source);

/// The strict superclasses of each representative, as representatives without owl:Thing's, ascending.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> find_ancestors(const taxonomy::Classification& classification);

}  // namespace geminga::reasoner

#endif
