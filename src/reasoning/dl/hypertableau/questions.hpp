// What may be asked about one clause set, and what is kept from question to question.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_QUESTIONS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_QUESTIONS_HPP

#include <optional>
#include <string>
#include <vector>

#include "reasoning/dl/hypertableau/search.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"

namespace geminga::hypertableau {

/// Answers questions by one search, and remembers whether the ontology has a model. The promises are those of Tableau.
class Questions {
 public:
  Questions(const owl::Ontology& source, const clauses::ClauseSet& set, const Limits& limits)
      : search_(source, set, limits) {}

  Answer is_consistent();
  Answer is_satisfiable(std::vector<clauses::ConceptId> together);
  [[nodiscard]] const Model& model() const { return model_; }

 private:
  /// Whether the ontology has a model, and if it is not known, why.
  struct World {
    Outcome outcome = Outcome::unknown;
    std::string reason;
    Model model;
  };

  const World& find_world();
  void prepare_base();

  Search search_;
  std::optional<World> world_;
  Model model_;
};

}  // namespace geminga::hypertableau

#endif
