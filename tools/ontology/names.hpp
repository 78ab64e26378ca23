// Slips of the pen that no syntax forbids: names that are used and nowhere declared, words that the reserved
// vocabularies do not have, and labels that stand for several classes.
#ifndef GEMINGA_ONTOLOGY_NAMES_HPP
#define GEMINGA_ONTOLOGY_NAMES_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::ontology {

/// A name that should perhaps be another one.
struct DoubtfulName {
  std::string name;  ///< `prefix:Name` or `<IRI>`
  std::string iri;
  std::string_view kind;  ///< "class", "property", "datatype", or "word" of a reserved vocabulary
  std::string file;       ///< where it is used first
  std::uint32_t line = 0;
  std::vector<std::string> similar;  ///< names that may have been meant
};

/// Names of a namespace of which the files declare none, or properties of annotations of which they declare some: its
/// ontology was not given. Not those about whose names the files say something without declaring any.
struct OtherNamespace {
  std::string iri;
  std::size_t names = 0;
  std::string first;  ///< one of them
};

struct LabelClash {
  std::string label;
  std::vector<std::string> classes;  ///< sorted
};

/// The first two are problems: an axiom that holds such a name does not say what its author thinks. The others are
/// remarks.
struct NameFindings {
  std::vector<DoubtfulName> unknown_words;  ///< by file and line
  std::vector<DoubtfulName> undeclared;     ///< by file and line
  std::vector<OtherNamespace> others;       ///< by IRI
  std::vector<LabelClash> clashes;          ///< by label

  [[nodiscard]] bool has_problem() const { return !unknown_words.empty() || !undeclared.empty(); }
};

/// Linear in the ontology, but for the likely meanings, which are looked for of so many names at most.
inline constexpr std::size_t max_explained_names = 50;
[[nodiscard]] NameFindings find_doubtful_names(const rdf::Loaded& loaded);

}  // namespace geminga::ontology

#endif
