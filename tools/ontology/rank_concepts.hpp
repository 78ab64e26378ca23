// From the types that profiles name to the concepts of a hierarchy: which names mean the same class.
#ifndef GEMINGA_ONTOLOGY_RANK_CONCEPTS_HPP
#define GEMINGA_ONTOLOGY_RANK_CONCEPTS_HPP

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rank_ontologies.hpp"
#include "reasoning/signature/hierarchy.hpp"

namespace geminga::ontology {

/// The names of a collection's classes.
///
/// One ontology is often published under several URLs, copied under another name, and named with `%20`, with spaces, or
/// in other letters. So a name that no ontology declares means the class with the same last two parts (`books#Book`),
/// where only one is declared; and classes of one name are one where their documents have most classes in common.
class ConceptNames {
 public:
  explicit ConceptNames(CollectionClasses classes);

  /// The concept of a parameter's type, by its IRI as it is, by its last two parts, and by these in lower case. An
  /// empty type is owl:Thing. What is in no ontology becomes a concept that has nothing in common with any other.
  [[nodiscard]] signature::Concept find(std::string_view type);
  /// The IRI, for people; of an unknown one as it was first given.
  [[nodiscard]] const std::string& iri(signature::Concept of) const;
  /// Whether find() made it up.
  [[nodiscard]] bool is_unknown(signature::Concept of) const;

  /// Requires that every type has been looked for.
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
