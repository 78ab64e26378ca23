// Decides by building a model: is this ontology consistent, can this concept have an instance?
//
// Hypertableau with anywhere pairwise blocking and dependency-directed backtracking (Motik, Shearer, Horrocks 2009).
// It is complete for OWL 2 DL, and the second opinion on everything that the consequence-based engine derives.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_TABLEAU_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_TABLEAU_HPP

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/hypertableau/facts/question_limits.hpp"

namespace geminga::owl {
class Ontology;
}

namespace geminga::hypertableau {

/// The answer to a question that may be too hard.
enum class Verdict : std::uint8_t { yes, no, unknown };

struct Answer {
  Verdict verdict = Verdict::unknown;
  std::string reason;  ///< of unknown: one line for a user, e.g. "more than 100000 nodes were needed"
};

/// The labels of a model, which show what is not entailed. Blocked nodes are left out, and so are nodes of earlier
/// models that have not changed.
struct Model {
  /// Ascending concepts of each node; the first is the instance of the concept that was asked for.
  std::vector<std::vector<clauses::ConceptId>> labels;
  /// Concepts of node 0 that hold in every model: derived without a choice. Ascending.
  std::vector<clauses::ConceptId> certain;
};

class Search;
enum class Outcome : std::uint8_t;

/// Asks about one ClauseSet, which must outlive it. Not thread-safe; many may share the set.
class Tableau {
 public:
  Tableau(const owl::Ontology& source, const clauses::ClauseSet& clauses, const QuestionLimits& limits = {});
  Tableau(const Tableau&) = delete;
  Tableau& operator=(const Tableau&) = delete;
  ~Tableau();

  /// Whether the ontology has a model.
  [[nodiscard]] Answer is_consistent();
  /// Whether some model has an instance of all these concepts at once that is in none of `outside`. One concept asks
  /// whether it is satisfiable. With one outside, or with the query of a complement, it asks whether a subsumption
  /// fails; with several, whether all fail at one instance. `outside` is without owl:Thing. It needs no clauses of its
  /// own, so that all pairs are asked beside one model.
  [[nodiscard]] Answer is_satisfiable(std::vector<clauses::ConceptId> together,
                                      const std::vector<clauses::ConceptId>& outside = {});
  /// Forgets the models of former questions, and which choices failed in them, before questions of another kind: these
  /// may be too hard in the order that served the others. The model of the facts stays.
  void begin_anew();
  /// The model of the last question whose answer was yes.
  [[nodiscard]] const Model& model() const { return model_; }
  /// Gives each later question so many steps.
  void limit_steps(std::size_t steps);
  /// The steps of all questions so far.
  [[nodiscard]] std::size_t steps() const;

 private:
  /// The answer to is_consistent(), which is found once.
  struct World {
    Answer answer;
    Model model;
  };

  const World& find_world();
  Outcome find_world_whatever_is_unknown(const std::string& reason);
  void prepare_base();
  void forget_all();

  std::unique_ptr<Search> search_;
  std::optional<World> world_;
  /// Why the search takes unknown atoms of rules for true, so that a question without a model is undecided; empty: it
  /// does not.
  std::string taken_for_true_;
  Model model_;
};

}  // namespace geminga::hypertableau

#endif
