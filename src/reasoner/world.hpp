// Whether clauses have a model, asked as OWL means it.
#ifndef GEMINGA_REASONER_WORLD_HPP
#define GEMINGA_REASONER_WORLD_HPP

#include "clauses/clause.hpp"
#include "tableau/tableau.hpp"

namespace geminga::reasoner {

/// There is at least one thing in every world (OWL 2 direct semantics, section 2.2): where no individual is named, one
/// without a name is asked for.
[[nodiscard]] inline tableau::Answer ask_for_world(tableau::Tableau& tableau, const clauses::ClauseSet& clauses) {
  return clauses.individuals.empty() ? tableau.is_satisfiable({clauses::thing}) : tableau.is_consistent();
}

}  // namespace geminga::reasoner

#endif
