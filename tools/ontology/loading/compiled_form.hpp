// The compiled form of ontologies: of classified files, or as `compile` wrote it.
#ifndef GEMINGA_ONTOLOGY_LOADING_COMPILED_FORM_HPP
#define GEMINGA_ONTOLOGY_LOADING_COMPILED_FORM_HPP

#include <expected>
#include <optional>
#include <string>
#include <vector>

#include "ontology/loading/classified_files.hpp"
#include "reasoning/compiled/ontology.hpp"

namespace geminga::ontology {

/// Compiles in memory, for names and explanations; nothing after saying what is wrong.
[[nodiscard]] std::optional<compiled::Ontology> compile_or_say(const ClassifiedFiles& classified);

/// Whether these files are a single one that `compile` wrote.
[[nodiscard]] bool is_compiled(const std::vector<std::string>& files);
/// Opens that file and verifies all of it.
[[nodiscard]] std::expected<compiled::Ontology, compiled::CompiledError> open_compiled(const std::string& file);

/// An ontology to explain, and what is not known of the files that it was made of.
struct Opened {
  compiled::Ontology ontology;
  reasoner::Answer consistency;                 ///< of consistency_of()
  std::optional<std::string> refused;           ///< of describe_refused()
  std::optional<ClassifiedFiles> classified{};  ///< the files; nothing: a compiled file
};
/// Classifies what was loaded and compiles it in memory; nothing after saying what is wrong.
[[nodiscard]] std::optional<Opened> classify_and_compile_or_say(rdf::Loaded loaded, const LoadOptions& options = {});
/// Opens a single compiled file whose sources are unchanged, or compiles the files in memory; nothing after saying what
/// is wrong.
[[nodiscard]] std::optional<Opened> open_or_say(const std::vector<std::string>& files, const LoadOptions& options = {});

}  // namespace geminga::ontology

#endif
