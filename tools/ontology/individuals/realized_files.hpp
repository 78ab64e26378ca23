// Ontology files with what follows for their individuals.
#ifndef GEMINGA_ONTOLOGY_INDIVIDUALS_REALIZED_FILES_HPP
#define GEMINGA_ONTOLOGY_INDIVIDUALS_REALIZED_FILES_HPP

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/loading/classified_files.hpp"
#include "reasoning/realization/realization.hpp"

namespace geminga::ontology {

inline constexpr std::string_view contradiction_words =
    "the ontology contradicts itself, so that everything follows from it: see geminga-ontology check";

/// Realises classified files, which must be consistent as far as classification says. Shows on a terminal what it does.
/// Adds the literals of facts to the files' source. Facts are wanted if they may take `most_fact_octets`.
[[nodiscard]] realization::Realization realize_files(ClassifiedFiles& classified, base::Budget& budget,
                                                     Progress& progress, std::optional<std::size_t> most_fact_octets);

/// Adds the first omission of the reader, for which more may follow than was found.
void note_unread(const owl::Ontology& source, std::vector<std::string>& gaps);

/// The reasons why something may be missing, and the individuals that are not decided, in one line; nothing where
/// everything is decided.
[[nodiscard]] std::optional<std::string> describe_open(const owl::Ontology& source,
                                                       const std::vector<owl::TermId>& undecided,
                                                       const std::vector<std::string>& gaps);
/// The undecided individuals of a realisation.
[[nodiscard]] std::vector<owl::TermId> undecided_individuals(const realization::Realization& realization);

}  // namespace geminga::ontology

#endif
