// The names that stand to class expressions as a query asks, which writes these as triples.
#ifndef GEMINGA_ONTOLOGY_GRAPH_ASKED_NAMES_HPP
#define GEMINGA_ONTOLOGY_GRAPH_ASKED_NAMES_HPP

#include <cstdint>
#include <expected>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "ontology/loading/classified_files.hpp"
#include "ontology/loading/hierarchy.hpp"
#include "reasoning/syntax/graph/expressions.hpp"

namespace geminga::ontology {

/// Finds individuals and classes in consistent files. Borrows everything; the source gets classes and an axiom for each
/// expression, which make no difference to other names.
class AskedNames {
 public:
  AskedNames(ClassifiedFiles& classified, base::Budget& budget, Progress& progress)
      : classified_(classified), budget_(budget), progress_(progress) {}

  /// The IRIs of what the expression asks for: the named individuals that are in it in every model; the named classes
  /// below it, with those that can have no instance; and those above it, without owl:Thing. owl:Nothing is among them
  /// where the expression can have no instance. An error says in one line why the triples are no class expression, or
  /// names an entity that the files do not have.
  [[nodiscard]] std::expected<graph::FoundNames, std::string> find(const graph::AskedExpression& asked);
  /// The reason why names may be missing, in one line; nothing where everything was decided.
  [[nodiscard]] const std::optional<std::string>& open() const { return open_; }

 private:
  [[nodiscard]] std::expected<owl::TermId, std::string> read(const graph::AskedExpression& asked);
  /// These return an error in one line, or nothing.
  [[nodiscard]] std::optional<std::string> find_instances(owl::TermId expression, graph::FoundNames& found);
  [[nodiscard]] std::optional<std::string> find_classes(owl::TermId expression, graph::FoundNames& found);

  [[nodiscard]] std::vector<std::string> names_in(const Hierarchy& hierarchy,
                                                  const std::set<std::uint32_t>& nodes) const;

  ClassifiedFiles& classified_;
  base::Budget& budget_;
  Progress& progress_;
  std::optional<std::string> open_;
};

}  // namespace geminga::ontology

#endif
