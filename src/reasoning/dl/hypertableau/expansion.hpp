// At-least restrictions.
//
//   >=-rule:  >= n R.B(x), x not blocked, without n different R-neighbours in B: n new ones.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_EXPANSION_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_EXPANSION_HPP

#include <cstdint>
#include <vector>

#include "reasoning/dl/hypertableau/assertions.hpp"
#include "reasoning/dl/hypertableau/blocking.hpp"
#include "reasoning/dl/hypertableau/dependency.hpp"
#include "reasoning/dl/hypertableau/effort.hpp"
#include "reasoning/dl/hypertableau/graph.hpp"
#include "reasoning/dl/hypertableau/neighbours.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"

namespace geminga::hypertableau {

/// Keeps the at-least restrictions, and makes the neighbours that they ask for.
class Expansion {
 public:
  Expansion(const owl::Ontology& source, const clauses::ClauseSet& set, const Program& program, const Graph& graph,
            DependencySets& sets, Effort& effort, Assertions& facts, Neighbours& neighbours, Blocking& blocking)
      : source_(source),
        set_(set),
        program_(program),
        graph_(graph),
        sets_(sets),
        effort_(effort),
        facts_(facts),
        neighbours_(neighbours),
        blocking_(blocking) {}

  /// Adds an at-least that was asserted. What can be had without a new node is had at once: a clash that comes of it
  /// comes before more is guessed.
  void add(const Fact& fact, FactId id);

  /// Makes a neighbour of which there may be one at most: what is known of it decides alternatives, which are chosen
  /// after. Whether a node was added, or a fact.
  bool expand_functional();
  /// Expands what is not blocked, from the at-least of this number on. Whether a node was added, or a fact. What
  /// follows from a guess is looked at before more is built on it.
  bool expand(std::size_t first, bool has_guesses);

  /// Sizes of the stacks.
  struct Sizes {
    std::size_t existentials = 0;
    std::uint32_t next_functional = 0;
    std::size_t done = 0;
  };
  [[nodiscard]] Sizes sizes() const { return {existentials_.size(), next_functional_, done_.size()}; }
  void restore(const Sizes& sizes);

 private:
  struct Existential {
    FactId fact = 0;
    bool is_done = false;
    /// The neighbour that was found to satisfy it as things stood, and the version of that node.
    NodeId witness = none;
    std::uint64_t version = 0;
  };

  /// Whether a node was added, or a fact.
  bool expand_one(std::uint32_t at);
  void note_done(std::uint32_t at);
  void expand_object(const Fact& fact);
  void expand_data(const Fact& fact);
  [[nodiscard]] bool is_satisfied(const Fact& fact);
  /// Whether a neighbour is in nothing that the filler denies (denials.hpp). It is to be asked again when that
  /// neighbour has changed.
  bool has_witness(Existential& existential);
  bool give_to_neighbour(const Fact& fact);

  const owl::Ontology& source_;
  const clauses::ClauseSet& set_;
  const Program& program_;
  const Graph& graph_;
  DependencySets& sets_;
  Effort& effort_;
  Assertions& facts_;
  Neighbours& neighbours_;
  Blocking& blocking_;
  std::vector<Existential> existentials_;
  std::uint32_t next_functional_ = 0;  ///< each is looked at once by expand_functional()
  std::vector<std::uint32_t> done_;    ///< existentials, in the order in which they were
};

}  // namespace geminga::hypertableau

#endif
