// The face of the search.
#include "reasoning/dl/hypertableau/tableau.hpp"

#include "reasoning/dl/hypertableau/search.hpp"

namespace geminga::hypertableau {

Tableau::Tableau(const owl::Ontology& source, const clauses::ClauseSet& clauses, const Limits& limits)
    : search_(std::make_unique<Search>(source, clauses, limits)) {}

Tableau::~Tableau() = default;

Answer Tableau::is_consistent() { return search_->is_consistent(); }

Answer Tableau::is_satisfiable(std::vector<clauses::ConceptId> together) {
  return search_->is_satisfiable(std::move(together));
}

const Model& Tableau::model() const { return search_->model(); }

}  // namespace geminga::hypertableau
