// The entities of one ontology by their names: classes, properties, individuals and datatypes.
#ifndef GEMINGA_REASONING_COMPILED_ENTITY_NAMES_HPP
#define GEMINGA_REASONING_COMPILED_ENTITY_NAMES_HPP

#include <expected>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "reasoning/compiled/ontology.hpp"
#include "reasoning/owl/names.hpp"

namespace geminga::compiled {

/// Resolves the names of one ontology, which must outlive it. Built once for an ontology; linear in its names.
class EntityNames final : public owl::Names {
 public:
  explicit EntityNames(const Ontology& ontology);

  /// In addition to what Names promises, a class is found by its label and, if nothing else fits, any entity by its
  /// local name, which is what follows the last `#` or `/` of its IRI. Each must be unambiguous.
  [[nodiscard]] std::expected<std::string, std::string> find(owl::TermKind kind, std::string_view name) const override;
  /// Whether the ontology, or OWL itself, has an entity of this kind and full IRI.
  [[nodiscard]] bool has(owl::TermKind kind, std::string_view iri) const;

 private:
  using Entity = std::pair<owl::TermKind, std::string_view>;
  [[nodiscard]] std::vector<std::string> candidates(owl::TermKind kind, std::string_view name) const;
  [[nodiscard]] std::vector<std::string> with_local_name(owl::TermKind kind, std::string_view name) const;
  /// Short names of entities of this kind whose local name is a few letters away, nearest first.
  [[nodiscard]] std::vector<std::string> similar_to(owl::TermKind kind, std::string_view name) const;

  const Ontology& ontology_;
  std::vector<Entity> entities_;                                                            ///< kind, IRI; sorted
  std::vector<std::tuple<owl::TermKind, std::string_view, std::string_view>> local_names_;  ///< kind, local name, IRI
};

/// The classes with this local name, in any namespace. Linear in the classes.
[[nodiscard]] std::vector<std::uint32_t> classes_with_local_name(const Ontology& ontology, std::string_view name);

/// The part of an IRI behind the last `#` or `/`.
[[nodiscard]] std::string_view end_of_iri(std::string_view iri);

}  // namespace geminga::compiled

#endif
