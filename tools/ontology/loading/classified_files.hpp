// Ontology files as the commands work on them: loaded, and classified.
#ifndef GEMINGA_ONTOLOGY_LOADING_CLASSIFIED_FILES_HPP
#define GEMINGA_ONTOLOGY_LOADING_CLASSIFIED_FILES_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/command/exit_status.hpp"
#include "ontology/loading/progress.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/syntax/rdf/load.hpp"
#include "reasoning/taxonomy/classification.hpp"

namespace geminga::ontology {

struct ClassifiedFiles {
  rdf::Loaded loaded;
  reasoner::Classified classification;
  double load_ms = 0;
  double classify_ms = 0;
};

/// An error in words, and whether the files could be read at all.
struct LoadFailure {
  std::string text;
  bool is_unreadable = false;
};

/// Which annotations are kept. Those of triples are not needed where the triples themselves are read again.
enum class KeptAnnotations : std::uint8_t { none, of_owl_syntaxes, all };

struct LoadOptions {
  unsigned threads = 1;
  bool as_json = false;    ///< errors are also printed as JSON, and no progress is shown
  bool says_files = true;  ///< says how many files the folders hold
  KeptAnnotations annotations = KeptAnnotations::none;
  /// Leaves out files of folders that are refused, and says so on standard error in lines that begin with
  /// compiled::left_out_words.
  bool leaves_out_refused = false;
  bool is_lenient = false;         ///< reads bounds and literals of another numeric datatype as numbers
  base::Budget* budget = nullptr;  ///< of the search; borrowed, null: no limit
};

/// Reads files and folders without classifying them. Shows on a terminal that it reads large ones, and says on standard
/// error how many files the folders hold.
[[nodiscard]] std::expected<rdf::Loaded, LoadFailure> load(const std::vector<std::string>& files, Progress& progress,
                                                           const LoadOptions& options = {});

/// Reads files and folders and classifies them together.
[[nodiscard]] std::expected<ClassifiedFiles, LoadFailure> classify_files(const std::vector<std::string>& files,
                                                                         const LoadOptions& options = {});
/// Classifies what was loaded in so many milliseconds.
[[nodiscard]] std::expected<ClassifiedFiles, LoadFailure> classify_files(rdf::Loaded loaded, double load_ms,
                                                                         Progress& progress,
                                                                         const LoadOptions& options = {});
/// Reads and classifies; nothing after saying what is wrong.
[[nodiscard]] std::optional<ClassifiedFiles> classify_or_say(const std::vector<std::string>& files,
                                                             const LoadOptions& options = {});

/// Named classes without owl:Thing and owl:Nothing.
[[nodiscard]] std::size_t class_count(const ClassifiedFiles& classified);
/// Whether a class can have no instance. No class can where the ontology is inconsistent.
[[nodiscard]] bool is_unsatisfiable(const taxonomy::Classification& classification, taxonomy::ClassNumber number);
/// Whether superclasses of this class may be missing.
[[nodiscard]] bool is_undecided(const reasoner::Classified& classification, taxonomy::ClassNumber number);

/// The question of consistency in messages, and in the gaps of a compiled ontology.
inline constexpr std::string_view contradiction_question = "whether there is a contradiction";
/// The undecided classes and the reason, in one line; nothing where all is decided or the ontology contradicts itself.
[[nodiscard]] std::optional<std::string> describe_undecided(const ClassifiedFiles& classified);
/// The same, and which limits are the reasons.
[[nodiscard]] std::optional<std::string> why_undecided(const ClassifiedFiles& classified);
/// The gaps as the compiled form keeps them: with the line of describe_undecided().
[[nodiscard]] std::vector<std::string> gaps_of(const ClassifiedFiles& classified);
/// Gives `exit`; where a limit was reached, says so on standard error and gives the exit status for it.
[[nodiscard]] Exit exit_of(const ClassifiedFiles& classified, Exit exit);

/// Shortens IRIs by the prefixes of the files and those found for other namespaces (owl::Prefixes), without a taxonomy.
[[nodiscard]] std::function<std::string(std::string_view)> short_names(const owl::Ontology& source);

/// The folder of the ontologies that ship with this program.
[[nodiscard]] std::filesystem::path shipped_ontologies();

}  // namespace geminga::ontology

#endif
