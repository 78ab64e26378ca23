// Completes a taxonomy by models: what no model refutes and no engine derived is asked, pair by pair.
//
// A model that has an instance of A shows that A can have one, and that nothing is above A but what holds of that
// instance. So most classes are settled by the models of others, and what is left are few questions (Glimm, Horrocks,
// Motik, Shearer, Stoilos: A novel approach to ontology classification, 2012).
#ifndef GEMINGA_REASONING_REASONER_COMPLETION_HPP
#define GEMINGA_REASONING_REASONER_COMPLETION_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/reasoner/taxonomy.hpp"

namespace geminga::reasoner {

/// Counted, so that the same ontology has the same taxonomy everywhere.
struct CompletionLimits {
  std::size_t classes = 50'000;     ///< of an ontology; beyond it no model is looked for
  std::size_t questions = 100'000;  ///< to the tableau, of all kinds
  std::size_t unanswered = 20;      ///< questions that were too hard
  hypertableau::Limits question{.nodes = 20'000, .steps = 500'000};
};

struct Completion {
  bool is_consistent = true;
  Subsumptions found;             ///< all of them follow
  std::vector<std::string> gaps;  ///< why something may still be missing: sorted, each once; empty: nothing is
  /// Representatives above which something may still be missing, ascending; nothing where there is no gap.
  std::vector<std::uint32_t> open;
  bool is_consistency_open = false;
  std::optional<std::uint32_t> held_up_by;  ///< the first class of which a question was left open
};

/// A taxonomy that may lack something.
struct Incomplete {
  const taxonomy::Classification& classification;
  const clauses::ClauseSet& clauses;  ///< of the source
  /// By class: nothing is missing above it, if the source is consistent.
  const std::vector<bool>& is_settled;
  /// By class: some model, if there is one, has an instance that is in this class, in those above it and in no other.
  const std::vector<bool>& is_plain;
};

/// Looks for what follows from the source beyond the taxonomy given.
[[nodiscard]] Completion complete(const owl::Ontology& source, const Incomplete& known, const Options& options,
                                  const CompletionLimits& limits = {});

}  // namespace geminga::reasoner

#endif
