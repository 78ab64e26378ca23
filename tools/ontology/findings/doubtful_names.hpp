// Typing errors that no syntax forbids: undeclared names, words that the reserved vocabularies do not have, and labels
// of several classes.
#ifndef GEMINGA_ONTOLOGY_FINDINGS_DOUBTFUL_NAMES_HPP
#define GEMINGA_ONTOLOGY_FINDINGS_DOUBTFUL_NAMES_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::ontology {

/// A name that may be a typing error.
struct DoubtfulName {
  std::string name;  ///< `prefix:Name` or `<IRI>`
  std::string iri;
  std::string_view kind;  ///< "class", "property", "datatype", or "word" of a reserved vocabulary
  std::string file;       ///< of the first use
  std::uint32_t line = 0;
  std::vector<std::string> similar;  ///< names that the author may have meant
};

/// A namespace whose ontology was not given: the files use its names and declare none of them (or, of annotation
/// properties, only some). A namespace whose names are the subjects of axioms does not count.
struct OtherNamespace {
  std::string iri;
  std::size_t names = 0;
  std::string first;  ///< the first name
};

struct LabelClash {
  std::string label;
  std::vector<std::string> classes;  ///< sorted
};

/// Unknown words and undeclared names are problems: an axiom that holds one does not say what its author thinks. The
/// other two are remarks.
struct NameFindings {
  std::vector<DoubtfulName> unknown_words;  ///< by file and line
  std::vector<DoubtfulName> undeclared;     ///< by file and line
  std::vector<OtherNamespace> others;       ///< by IRI
  std::vector<LabelClash> clashes;          ///< by label

  [[nodiscard]] bool has_problem() const { return !unknown_words.empty() || !undeclared.empty(); }
};

/// The most names that similar ones are looked for.
inline constexpr std::size_t max_explained_names = 50;

/// Linear in the ontology, but for the similar names.
[[nodiscard]] NameFindings find_doubtful_names(const rdf::Loaded& loaded);

}  // namespace geminga::ontology

#endif
