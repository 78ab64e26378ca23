// The concepts that the types in profiles name, and which names mean the same class.
#ifndef GEMINGA_ONTOLOGY_RANKING_CONCEPT_NAMES_HPP
#define GEMINGA_ONTOLOGY_RANKING_CONCEPT_NAMES_HPP

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "ontology/ranking/collection_classes.hpp"
#include "reasoning/signature/hierarchy.hpp"

namespace geminga::ontology {

/// The names of a collection's classes.
///
/// One ontology is often published under several URLs, copied under another name, and spelled with `%20`, with spaces,
/// or in other cases of letters. So a name that no ontology declares means the class with the same last two parts
/// (`books#Book`), where only one is declared; and classes of one name are one class where their documents have most
/// classes in common.
class ConceptNames {
 public:
  explicit ConceptNames(CollectionClasses classes);

  /// Finds the concept of a parameter's type by its IRI, by its last two parts, or by these in lower case. An empty
  /// type is owl:Thing. A type in no ontology becomes a concept that has nothing in common with any other.
  [[nodiscard]] signature::Concept find(std::string_view type);
  /// The IRI of a concept; of an unknown one as find() was first given it.
  [[nodiscard]] const std::string& iri(signature::Concept of) const;
  /// Whether the concept is in no ontology.
  [[nodiscard]] bool is_unknown(signature::Concept of) const;

  /// The hierarchy of all concepts. Requires that find() was called for every type.
  [[nodiscard]] signature::Hierarchy hierarchy() const;

 private:
  void index();
  void join_documents();
  void add_datatypes();

  CollectionClasses classes_;
  std::size_t known_ = 0;
  std::uint32_t thing_ = 0;
  std::map<std::string, std::vector<std::uint32_t>, std::less<>> by_key_;  ///< last two parts
  std::map<std::string, std::vector<std::uint32_t>, std::less<>> by_lower_key_;
};

/// "books#Science Fiction" of "http://127.0.0.1/ontology/books.owl#Science%20Fiction".
[[nodiscard]] std::string last_two_parts(std::string_view iri);

}  // namespace geminga::ontology

#endif
