// The entities that files declare or describe, with their places and what annotations say of them.
#ifndef GEMINGA_ONTOLOGY_ENTITIES_ENTITIES_HPP
#define GEMINGA_ONTOLOGY_ENTITIES_ENTITIES_HPP

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/owl/annotation.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::ontology {

/// A name of one kind.
struct Entity {
  owl::TermKind kind{};
  std::string iri;
  std::string short_name;
  std::string file;  ///< of its declaration, or of the first axiom about it; empty: unknown
  std::uint32_t line = 0;
  bool is_used = false;  ///< some axiom other than a declaration has it
  bool is_deprecated = false;
  bool has_definition = false;
  std::vector<const owl::Annotation*> labels;
};

/// Own entities are those that a declaration or an axiom about them makes so: names of ontologies that were not given
/// are not among them. Borrows the files, whose annotations must have been kept.
class Entities {
 public:
  explicit Entities(const rdf::Loaded& loaded);

  /// By IRI and kind, without individuals and words of OWL, RDF, RDFS and XSD.
  [[nodiscard]] const std::vector<Entity>& all() const { return all_; }
  /// The entity of a term; nullptr if it is none of these.
  [[nodiscard]] const Entity* find(owl::TermId term) const;
  [[nodiscard]] std::string short_name(std::string_view iri) const { return short_name_(iri); }

 private:
  void gather(const owl::Ontology& source);
  void annotate(const rdf::Loaded& loaded);

  std::function<std::string(std::string_view)> short_name_;
  std::vector<Entity> all_;
  std::map<owl::TermId, std::size_t> number_of_;
};

/// "class", "object property" and so on.
[[nodiscard]] std::string_view word_of(owl::TermKind kind);

}  // namespace geminga::ontology

#endif
