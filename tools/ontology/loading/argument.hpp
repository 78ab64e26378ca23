// Premise and conclusion: two sets of files in one source, and which axioms are whose.
#ifndef GEMINGA_ONTOLOGY_LOADING_ARGUMENT_HPP
#define GEMINGA_ONTOLOGY_LOADING_ARGUMENT_HPP

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/loading/classified_files.hpp"

namespace geminga::ontology {

/// Both are read together, so that each knows the declarations of the other. A file that is in both belongs to both.
struct Argument {
  rdf::Loaded loaded;
  std::vector<std::uint32_t> premise;     ///< axioms
  std::vector<std::uint32_t> conclusion;  ///< axioms
  std::vector<std::size_t> ill_typed;     ///< axioms of the premise that hold an ill-typed literal
  /// An axiom that was read and not understood, or a file that was left out, in one line; nothing: there is none.
  /// Ill-typed literals count for the conclusion only.
  std::optional<std::string> unread_premise;
  std::optional<std::string> unread_conclusion;
};

[[nodiscard]] std::expected<Argument, LoadFailure> load_argument(const std::string& premise,
                                                                 const std::string& conclusion, Progress& progress,
                                                                 const LoadOptions& options = {});

/// The begin of an omission that is an import which no given file answers.
inline constexpr std::string_view import_words = "owl:imports ";

/// The first omission of the reader in the files f with `files[f]` (empty: in all), in one line. Imports do not count,
/// and axioms with an ill-typed literal only where `with_ill_typed` asks for them.
[[nodiscard]] std::optional<std::string> find_unread(const owl::Ontology& source, const std::vector<bool>& files,
                                                     bool with_ill_typed);

/// Says on standard error which imports no given file answers, and that the decision was made without them.
void say_unresolved(const rdf::Loaded& loaded);

}  // namespace geminga::ontology

#endif
