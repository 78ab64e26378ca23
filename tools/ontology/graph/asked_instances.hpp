// The instances of the class expressions that a query writes as triples.
#ifndef GEMINGA_ONTOLOGY_GRAPH_ASKED_INSTANCES_HPP
#define GEMINGA_ONTOLOGY_GRAPH_ASKED_INSTANCES_HPP

#include <expected>
#include <optional>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "ontology/loading/classified_files.hpp"
#include "reasoning/syntax/graph/expressions.hpp"

namespace geminga::ontology {

/// Finds instances in consistent files. Borrows everything; the source gets a class for each expression.
class AskedInstances {
 public:
  AskedInstances(ClassifiedFiles& classified, base::Budget& budget, Progress& progress)
      : classified_(classified), budget_(budget), progress_(progress) {}

  /// The IRIs of the named individuals that are in the expression in every model. An error says in one line why the
  /// triples are no class expression, or names an entity that the files do not have.
  [[nodiscard]] std::expected<std::vector<std::string>, std::string> find(const graph::AskedExpression& asked);
  /// The reason why instances may be missing, in one line; nothing where everything was decided.
  [[nodiscard]] const std::optional<std::string>& open() const { return open_; }

 private:
  [[nodiscard]] std::expected<owl::TermId, std::string> read(const graph::AskedExpression& asked);

  ClassifiedFiles& classified_;
  base::Budget& budget_;
  Progress& progress_;
  std::optional<std::string> open_;
};

}  // namespace geminga::ontology

#endif
