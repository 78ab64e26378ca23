// What the names in class expressions mean in one ontology: classes, properties, individuals and datatypes.
#ifndef GEMINGA_MANCHESTER_NAMES_HPP
#define GEMINGA_MANCHESTER_NAMES_HPP

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "el/axiom.hpp"
#include "el/ontology.hpp"

namespace geminga::manchester {

/// Resolves the names of one ontology, which must outlive it. Built once an ontology; linear in its names.
class Names {
 public:
  explicit Names(const el::Ontology& ontology);

  /// The full IRI of an entity of this kind, or one line that says why there is none. `name` is `<IRI>`, a bare IRI,
  /// `prefix:Name`, of classes a label, or, where none of these fits, a local name: what follows the last `#` or `/` of
  /// an IRI. Each must be unambiguous.
  [[nodiscard]] std::expected<std::string, std::string> find(el::TermKind kind, std::string_view name) const;
  /// Whether the ontology has an entity of this kind and full IRI, or OWL itself has.
  [[nodiscard]] bool has(el::TermKind kind, std::string_view iri) const;

  [[nodiscard]] const el::Ontology& ontology() const { return ontology_; }

 private:
  using Entity = std::pair<el::TermKind, std::string_view>;
  [[nodiscard]] std::vector<std::string> candidates(el::TermKind kind, std::string_view name) const;
  [[nodiscard]] std::vector<std::string> with_local_name(el::TermKind kind, std::string_view name) const;
  /// Short names of entities of this kind whose local name is a few letters away, nearest first.
  [[nodiscard]] std::vector<std::string> similar_to(el::TermKind kind, std::string_view name) const;

  const el::Ontology& ontology_;
  std::vector<Entity> entities_;                                                           ///< kind, IRI; sorted
  std::vector<std::tuple<el::TermKind, std::string_view, std::string_view>> local_names_;  ///< kind, local name, IRI
  std::vector<std::pair<std::string_view, std::string_view>> prefixes_;                    ///< sorted
};

/// What follows the last `#` or `/` of an IRI.
[[nodiscard]] std::string_view local_name(std::string_view iri);

}  // namespace geminga::manchester

#endif
