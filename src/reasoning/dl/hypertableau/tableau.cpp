// The face of the engine.
#include "reasoning/dl/hypertableau/tableau.hpp"

#include "reasoning/dl/hypertableau/questions.hpp"

namespace geminga::hypertableau {

Tableau::Tableau(const owl::Ontology& source, const clauses::ClauseSet& clauses, const Limits& limits)
    : questions_(std::make_unique<Questions>(source, clauses, limits)) {}

Tableau::~Tableau() = default;

Answer Tableau::is_consistent() { return questions_->is_consistent(); }

Answer Tableau::is_satisfiable(std::vector<clauses::ConceptId> together) {
  return questions_->is_satisfiable(std::move(together));
}

const Model& Tableau::model() const { return questions_->model(); }

}  // namespace geminga::hypertableau
