// The prefixes of an ontology: those that its files declare, and others for the namespaces that have none.
#ifndef GEMINGA_REASONING_OWL_PREFIXES_PREFIXES_HPP
#define GEMINGA_REASONING_OWL_PREFIXES_PREFIXES_HPP

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::owl {

/// The most namespaces without a prefix that get one: those with the most names.
inline constexpr std::size_t max_found_prefixes = 64;
/// A namespace with fewer names gets none.
inline constexpr std::size_t min_names_of_prefix = 2;

/// The prefixes of one ontology, each a word without its colon and an IRI. They are, in this order:
/// - those of the files;
/// - `owl`, `rdf`, `rdfs` and `xsd`, unless the files give these words another meaning;
/// - where the files have one ontology IRI and no empty prefix: the empty word for the namespace of the ontology IRI,
///   which is the IRI itself or the IRI with `#` or `/` behind it (`:Margherita`);
/// - for other namespaces of classes, properties and individuals: the last word of the namespace, with a number where
///   that is taken (`pizza` of `http://www.co-ode.org/ontologies/pizza/2005/05/16/pizza.owl#`).
/// They do not depend on the order of axioms. A found word never equals a declared one, so a short name has one
/// meaning.
class Prefixes {
 public:
  using Entry = std::pair<std::string, std::string>;

  /// Linear in the names of the ontology.
  explicit Prefixes(const Ontology& source);

  /// Ascending.
  [[nodiscard]] const std::vector<Entry>& all() const { return all_; }
  /// `prefix:Name` if a prefix fits, else `<IRI>`. Ontology::find() of the compiled form reads it back.
  [[nodiscard]] std::string short_name(std::string_view iri) const;

 private:
  std::vector<Entry> all_;
  std::vector<std::pair<std::string_view, std::string_view>> views_;  ///< of all_
};

/// The word for a namespace: the last piece of its IRI that begins with a letter and holds nothing but letters, digits,
/// `-` and `_`, without the ending of a file name. "ns" where there is none.
[[nodiscard]] std::string word_of_namespace(std::string_view iri);

}  // namespace geminga::owl

#endif
