// The taxonomy written out: every entailed subsumption between named classes, or an indented tree.
#ifndef GEMINGA_ONTOLOGY_CLOSURE_HPP
#define GEMINGA_ONTOLOGY_CLOSURE_HPP

#include <functional>
#include <string_view>

#include "el/classify.hpp"
#include "el/ontology.hpp"

namespace geminga::ontology {

/// Takes text piece by piece; false stops the writing.
using Sink = std::function<bool(std::string_view)>;

/// One `SUB<TAB>SUPER` line of full IRIs for every entailed subsumption between different named classes, equivalents in
/// both directions, without owl:Thing as super; the one line `CLASS<TAB>owl:Nothing` for an unsatisfiable class. Sorted
/// by octets.
[[nodiscard]] bool write_closure(const el::OntologySource& source, const el::Classification& classification,
                                 const Sink& sink);

/// One line a node of equivalent classes, indented by two blanks a level, below every parent that it has; what stands
/// below a class that was written before is not written again and shown by `...`.
[[nodiscard]] bool write_tree(const el::Ontology& ontology, const el::Classification& classification, const Sink& sink);

/// The classes of each representative, ascending; empty for others.
[[nodiscard]] std::vector<std::vector<el::ClassNumber>> equivalents(const el::Classification& classification);

}  // namespace geminga::ontology

#endif
