// The classes to which left-out axioms may matter.
#ifndef GEMINGA_ONTOLOGY_FINDINGS_TOUCHED_CLASSES_HPP
#define GEMINGA_ONTOLOGY_FINDINGS_TOUCHED_CLASSES_HPP

#include <optional>
#include <vector>

#include "reasoning/compiled/ontology.hpp"
#include "reasoning/taxonomy/class_number.hpp"

namespace geminga::ontology {

/// The classes, ascending, whose module (reasoning/modules/module.hpp) holds an axiom that is not used in full. Of all
/// others no superclass is missing because of such an axiom, since all that follows about a class follows from its
/// module. Facts are in every module. Requires that everything that was left out is an axiom of the ontology. Nothing:
/// the ontology is too large to look at each class. The cost is that of a module for each class.
[[nodiscard]] std::optional<std::vector<taxonomy::ClassNumber>> find_touched_classes(
    const compiled::Ontology& ontology);

}  // namespace geminga::ontology

#endif
