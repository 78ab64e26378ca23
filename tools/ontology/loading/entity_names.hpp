// The entities of loaded files by the names that users write: classes, properties, datatypes and individuals.
#ifndef GEMINGA_ONTOLOGY_LOADING_ENTITY_NAMES_HPP
#define GEMINGA_ONTOLOGY_LOADING_ENTITY_NAMES_HPP

#include <expected>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::ontology {

/// Finds entities of one source, which must outlive it.
class EntityNames {
 public:
  explicit EntityNames(const owl::Ontology& source);

  /// The entities with an IRI, a short name, or an end of an IRI (behind the last `#`, `/` or `:`) that one IRI alone
  /// has; one IRI may name a class and an individual. The error says what is wrong.
  [[nodiscard]] std::expected<std::vector<owl::TermId>, std::string> find(std::string_view name) const;

 private:
  std::unordered_map<std::string, std::vector<std::string_view>> iris_;  ///< by short name and end; each sorted
  std::unordered_map<std::string_view, std::vector<owl::TermId>> terms_;
};

}  // namespace geminga::ontology

#endif
