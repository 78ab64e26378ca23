// Whether files contradict themselves: the one answer that all commands give.
#ifndef GEMINGA_ONTOLOGY_LOADING_CONSISTENCY_HPP
#define GEMINGA_ONTOLOGY_LOADING_CONSISTENCY_HPP

#include <boost/json/object.hpp>

#include "base/budget.hpp"
#include "ontology/loading/classified_files.hpp"
#include "reasoning/reasoner/reasoner.hpp"

namespace geminga::ontology {

/// The answer for whole files, where `of_axioms` is that for the axioms that were read from them. Statements that were
/// not understood, files that were left out and ill-typed literals can make a contradiction and never undo one. Adds
/// the repairs of ill-typed literals to the source, so this is the last question about it.
[[nodiscard]] reasoner::Answer consistency_of(rdf::Loaded& loaded, reasoner::Answer of_axioms, base::Budget* budget);
/// The same for what classification says of the axioms.
[[nodiscard]] reasoner::Answer consistency_of(ClassifiedFiles& classified, base::Budget* budget);
/// The same for a compiled ontology, which does not keep whether an omission can make a contradiction: then it is
/// unknown.
[[nodiscard]] reasoner::Answer consistency_of(const compiled::Ontology& ontology);

/// Notes that another search has found a model of all axioms.
void note_model(reasoner::Classified& classification);

/// The part of a help text that says so.
inline constexpr const char* consistency_of_json =
    "In the document of --json `consistent` is true, false, or null where that cannot be decided, as `consistent` "
    "says;\nthen `reason` says why.\n";
/// Sets `consistent` to true, false or null. With null `reason` says why it is not known.
void put_consistency(const reasoner::Answer& answer, boost::json::object& document);

}  // namespace geminga::ontology

#endif
