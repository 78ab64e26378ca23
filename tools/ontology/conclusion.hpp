// Premise and conclusion: two sets of files in one source, and which axioms are whose.
#ifndef GEMINGA_ONTOLOGY_CONCLUSION_HPP
#define GEMINGA_ONTOLOGY_CONCLUSION_HPP

#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "knowledge.hpp"

namespace geminga::ontology {

/// Both, read together, so that what one declares the other knows. A file that is in both belongs to both.
struct Argument {
  rdf::Loaded loaded;
  std::vector<std::uint32_t> premise;     ///< axioms
  std::vector<std::uint32_t> conclusion;  ///< axioms
  std::vector<std::size_t> ill_typed;     ///< axioms of the premise that hold an ill-typed literal
  /// What was read and means nothing to a reasoner, in one line; nothing: all was understood. Of the premise without
  /// what is ill-typed.
  std::optional<std::string> unread_premise;
  std::optional<std::string> unread_conclusion;
};

[[nodiscard]] std::expected<Argument, NoKnowledge> load_argument(const std::string& premise,
                                                                 const std::string& conclusion, Progress& progress);

/// The first thing that the reader left out of these files, imports apart: those are decided without. `files[f]` says
/// whether file f is meant; empty: all are. What is left out for an ill-typed literal counts only where it is asked
/// for.
[[nodiscard]] std::optional<std::string> find_unread(const owl::Ontology& source, const std::vector<bool>& files,
                                                     bool with_ill_typed);

/// On standard error, for every import that no given file answers, that it was decided without.
void say_unresolved(const rdf::Loaded& loaded);

}  // namespace geminga::ontology

#endif
