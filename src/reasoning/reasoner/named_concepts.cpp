// Matches them by the names of the source.
#include "reasoning/reasoner/named_concepts.hpp"

namespace geminga::reasoner {

NamedConcepts::NamedConcepts(const owl::Ontology& source, const taxonomy::Classification& classification,
                             const clauses::ClauseSet& clauses)
    : classes_(clauses.concepts.size(), none), concepts_(classification.class_count(), none) {
  std::vector<std::uint32_t> class_of_name(source.name_count(), none);
  for (std::uint32_t of = 0; of < classification.class_count(); ++of)
    class_of_name[static_cast<std::size_t>(classification.classes[of])] = of;
  for (std::uint32_t id = 0; id < clauses.concepts.size(); ++id) {
    const clauses::Concept& found = clauses.concepts[id];
    if (found.kind != clauses::ConceptKind::named) continue;
    const std::uint32_t of = class_of_name[static_cast<std::size_t>(source.term(found.term).name)];
    if (of == none) continue;
    classes_[id] = of;
    concepts_[of] = id;
  }
}

}  // namespace geminga::reasoner
