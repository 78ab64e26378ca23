// Completes a taxonomy by models: each pair that no model refutes and no engine derived is asked.
//
// A model with an instance of A shows that A is satisfiable, and that its subsumers are among the classes of that
// instance. So the models of some classes answer most questions about others, and few questions remain (Glimm,
// Horrocks, Motik, Shearer, Stoilos: A novel approach to ontology classification, 2012). What remains of a class is
// asked together as long as nothing of it follows.
#ifndef GEMINGA_REASONING_REASONER_COMPLETION_HPP
#define GEMINGA_REASONING_REASONER_COMPLETION_HPP

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/reasoner/taxonomy.hpp"

namespace geminga::reasoner {

/// Limits are counted steps, so that the same ontology has the same taxonomy everywhere.
struct CompletionLimits {
  std::size_t classes = 50'000;                                 ///< of an ontology; beyond it no model is looked for
  std::size_t questions = 100'000;                              ///< to the tableau, of all kinds
  std::size_t unanswered = 20;                                  ///< questions that were too hard
  std::size_t steps = std::numeric_limits<std::size_t>::max();  ///< of one tableau, all questions about classes
  hypertableau::QuestionLimits question{.nodes = 20'000, .steps = 500'000};
};

struct Completion {
  bool is_consistent = true;
  Subsumptions found;             ///< all of them follow
  std::vector<std::string> gaps;  ///< why something may still be missing: sorted, each once; empty: nothing is
  /// Representatives that may have further subsumers, ascending. Empty if there is no gap.
  std::vector<std::uint32_t> open;
  bool is_consistency_open = false;
  std::optional<std::uint32_t> held_up_by;  ///< the first class of which a question was left open
};

/// A taxonomy that may be incomplete.
struct Incomplete {
  const taxonomy::Classification& classification;
  const clauses::ClauseSet& clauses;  ///< of the source
  /// By class: all its subsumers are known, if the source is consistent.
  const std::vector<bool>& is_settled;
  /// By class: if the source has a model, some model has an instance that is in this class and its subsumers and in no
  /// other class.
  const std::vector<bool>& is_plain;
};

/// Finds the subsumptions that follow from the source and are not in the taxonomy.
[[nodiscard]] Completion complete(const owl::Ontology& source, const Incomplete& known, const Options& options,
                                  const CompletionLimits& limits = {});

}  // namespace geminga::reasoner

#endif
