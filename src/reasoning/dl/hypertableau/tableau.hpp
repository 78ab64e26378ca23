// Decides by building a model: is this ontology consistent, can this concept have an instance?
//
// Hypertableau with anywhere pairwise blocking and dependency-directed backtracking (Motik, Shearer, Horrocks 2009).
// It is complete for OWL 2 DL, and the second opinion on everything that the consequence-based engine derives.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_TABLEAU_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_TABLEAU_HPP

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "reasoning/dl/clauses/clause.hpp"

namespace geminga::hypertableau {

/// The answer to a question that may be too hard.
enum class Verdict : std::uint8_t { yes, no, unknown };

struct Answer {
  Verdict verdict = Verdict::unknown;
  std::string reason;  ///< of unknown: one line for a user, e.g. "more than 100000 nodes were needed"
};

/// Work is counted, never timed, so that the same question has the same answer everywhere.
struct Limits {
  std::size_t nodes = 100'000;
  /// Facts derived, alternatives and matches looked at, nodes looked at for blocking, over all branches.
  std::size_t steps = 20'000'000;
  std::size_t world_steps = 0;    ///< so many more for whether the ontology has a model
  std::size_t facts = 4'000'000;  ///< that are there at once, so that memory is bounded: about 50 octets each
  /// What the steps of all questions are taken from, beside other work; nothing: only the limits above hold. Borrowed.
  base::Budget* budget = nullptr;
};

/// A model as far as it tells what is not entailed: what holds of each of its nodes that is not blocked. Nodes that it
/// shares with the models of earlier questions, or with that of the facts, and that are as they were there, are left
/// out.
struct Model {
  /// Ascending concepts of each node; the first is the instance of the concept that was asked for.
  std::vector<std::vector<clauses::ConceptId>> labels;
  /// Concepts of node 0 that hold in every model: derived without a choice. Ascending.
  std::vector<clauses::ConceptId> certain;
};

class Questions;

/// Asks about one ClauseSet, which must outlive it. Not thread-safe; many may share the set.
class Tableau {
 public:
  Tableau(const owl::Ontology& source, const clauses::ClauseSet& clauses, const Limits& limits = {});
  Tableau(const Tableau&) = delete;
  Tableau& operator=(const Tableau&) = delete;
  ~Tableau();

  /// Whether the ontology has a model.
  [[nodiscard]] Answer is_consistent();
  /// Whether some model has an instance of all of these at once (one concept: is it satisfiable; two, of which one is
  /// a query for a complement: does a subsumption fail).
  [[nodiscard]] Answer is_satisfiable(std::vector<clauses::ConceptId> together);
  /// The model that the last question with the answer yes has built.
  [[nodiscard]] const Model& model() const;

 private:
  std::unique_ptr<Questions> questions_;
};

}  // namespace geminga::hypertableau

#endif
