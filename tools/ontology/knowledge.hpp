// What the commands work on: the files as they were read, their classification, and names that can be looked up.
#ifndef GEMINGA_ONTOLOGY_KNOWLEDGE_HPP
#define GEMINGA_ONTOLOGY_KNOWLEDGE_HPP

#include <cstddef>
#include <expected>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "el/classify.hpp"
#include "el/ontology.hpp"
#include "rdf/load.hpp"

namespace geminga::ontology {

/// Loaded and classified files.
struct Knowledge {
  rdf::Loaded loaded;
  el::Classification classification;
  double load_ms = 0;
  double classify_ms = 0;
};

/// Why there is none, as the words of an error, and whether the files could be read at all.
struct NoKnowledge {
  std::string text;
  bool is_unreadable = false;
};

[[nodiscard]] std::expected<Knowledge, NoKnowledge> learn(const std::vector<std::string>& files, unsigned threads = 1);
/// The same, and what is wrong has been said on standard error when there is nothing.
[[nodiscard]] std::optional<Knowledge> learn_or_say(const std::vector<std::string>& files, unsigned threads = 1);

/// The compiled form and an ontology over it, for names and explanations; nothing after saying what is wrong.
[[nodiscard]] std::optional<el::Ontology> open_or_say(const Knowledge& knowledge);
/// The class of a name; nothing after saying what is wrong.
[[nodiscard]] std::optional<el::ClassNumber> find_or_say(const el::Ontology& ontology, const std::string& name);

/// Named classes without owl:Thing and owl:Nothing.
[[nodiscard]] std::size_t class_count(const Knowledge& knowledge);
/// Whether a class can have no instance; each is where the ontology is inconsistent.
[[nodiscard]] bool is_unsatisfiable(const el::Classification& classification, el::ClassNumber number);

/// The folder of the ontologies that ship with this program.
[[nodiscard]] std::filesystem::path shipped_ontologies();

}  // namespace geminga::ontology

#endif
