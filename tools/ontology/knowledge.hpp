// What the commands work on: the files as they were read, their classification, and names that can be looked up.
#ifndef GEMINGA_ONTOLOGY_KNOWLEDGE_HPP
#define GEMINGA_ONTOLOGY_KNOWLEDGE_HPP

#include <cstddef>
#include <expected>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"
#include "progress.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::ontology {

/// Loaded and classified files.
struct Knowledge {
  rdf::Loaded loaded;
  reasoner::Classified classification;
  double load_ms = 0;
  double classify_ms = 0;
};

/// Before the IRI of an individual: the class of nothing but it, which stands in the taxonomy where the types of
/// individuals are asked for (learn_types()).
inline constexpr std::string_view only_individual = "urn:geminga:only:";

/// Whether something may be missing above this class.
[[nodiscard]] bool is_undecided(const reasoner::Classified& classification, taxonomy::ClassNumber number);

/// Why there is none, as the words of an error, and whether the files could be read at all.
struct NoKnowledge {
  std::string text;
  bool is_unreadable = false;
};

/// How to learn. Where the output is JSON no progress is shown, and what is wrong is said as JSON, too.
struct Learning {
  unsigned threads = 1;
  bool as_json = false;
  bool says_files = true;  ///< how many were found in folders
  bool keeps_annotations = false;
  base::Budget* budget = nullptr;  ///< what the search may cost; borrowed
};

/// Reads files and folders without classifying them. Says on a terminal that it does where they are large, and on
/// standard error how many files it found where folders were named.
[[nodiscard]] std::expected<rdf::Loaded, NoKnowledge> load(const std::vector<std::string>& files, Progress& progress,
                                                           const Learning& how = {});

[[nodiscard]] std::expected<Knowledge, NoKnowledge> learn(const std::vector<std::string>& files,
                                                          const Learning& how = {});
/// The same of what is loaded already, in so many milliseconds.
[[nodiscard]] std::expected<Knowledge, NoKnowledge> learn(rdf::Loaded loaded, double load_ms, Progress& progress,
                                                          const Learning& how = {});
/// The same, and what is wrong has been said on standard error when there is nothing.
[[nodiscard]] std::optional<Knowledge> learn_or_say(const std::vector<std::string>& files, const Learning& how = {});

/// What was not decided and why, in one line; nothing where all was, or the ontology contradicts itself.
[[nodiscard]] std::optional<std::string> describe_undecided(const Knowledge& knowledge);
/// Where a limit was reached, says so on standard error, and gives the exit status that tells of it; else `exit`.
[[nodiscard]] Exit exit_of(const Knowledge& knowledge, Exit exit);

/// The gaps as the compiled form keeps them: with what they leave undecided.
[[nodiscard]] std::vector<std::string> gaps_of(const Knowledge& knowledge);
/// The compiled form and an ontology over it, for names and explanations; nothing after saying what is wrong.
[[nodiscard]] std::optional<compiled::Ontology> open_or_say(const Knowledge& knowledge);

/// Whether these files are one that `compile` wrote.
[[nodiscard]] bool is_compiled(const std::vector<std::string>& files);
/// That file, verified as a whole.
[[nodiscard]] std::expected<compiled::Ontology, compiled::CompiledError> open_compiled(const std::string& file);
/// The ontology of these files, or of the one compiled file that they are, unless its sources have changed since;
/// nothing after saying what is wrong.
[[nodiscard]] std::optional<compiled::Ontology> learn_ontology_or_say(const std::vector<std::string>& files,
                                                                      const Learning& how = {});

/// The class of a name, which may be all that follows the last `#` or `/` of its IRI where no other class ends so; or
/// what is wrong, with the candidates, or the names that are like it.
[[nodiscard]] std::expected<taxonomy::ClassNumber, std::string> find_class(const compiled::Ontology& ontology,
                                                                           const std::string& name);
/// The same; nothing after saying what is wrong.
[[nodiscard]] std::optional<taxonomy::ClassNumber> find_or_say(const compiled::Ontology& ontology,
                                                               const std::string& name, bool as_json = false);
/// What is wrong with a name, and which names are like it.
[[nodiscard]] std::string describe(const compiled::Ontology& ontology, const std::string& name,
                                   const compiled::NameError& error);

/// How IRIs are written by the prefixes of the files, for those who need no taxonomy.
[[nodiscard]] std::function<std::string(std::string_view)> short_names(const owl::Ontology& source);

/// Named classes without owl:Thing and owl:Nothing.
[[nodiscard]] std::size_t class_count(const Knowledge& knowledge);
/// Whether a class can have no instance; each is where the ontology is inconsistent.
[[nodiscard]] bool is_unsatisfiable(const taxonomy::Classification& classification, taxonomy::ClassNumber number);

/// The folder of the ontologies that ship with this program.
[[nodiscard]] std::filesystem::path shipped_ontologies();

}  // namespace geminga::ontology

#endif
