// At-least restrictions.
//
//   >=-rule:  >= n R.B(x), x not blocked, without n different R-neighbours in B: n new ones.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_EXPANSION_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_EXPANSION_HPP

#include <compare>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "reasoning/dl/hypertableau/blocking.hpp"
#include "reasoning/dl/hypertableau/denial_witnesses.hpp"
#include "reasoning/dl/hypertableau/facts/assertions.hpp"
#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/new_neighbours.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"
#include "reasoning/dl/hypertableau/witnesses.hpp"

namespace geminga::hypertableau {

/// Keeps the at-least restrictions, and makes the neighbours that they ask for.
class Expansion {
 public:
  Expansion(const Program& program, const Graph& graph, Assertions& facts, Blocking& blocking, Witnesses& witnesses,
            const DenialWitnesses& denial_witnesses, NewNeighbours& new_neighbours)
      : program_(program),
        graph_(graph),
        facts_(facts),
        blocking_(blocking),
        witnesses_(witnesses),
        denial_witnesses_(denial_witnesses),
        new_neighbours_(new_neighbours) {}

  /// Adds an at-least that was asserted. If no new node is needed, satisfies it at once, so that a clash is found
  /// before more is guessed.
  void add(const Fact& fact, FactId id);

  /// Makes the neighbour of a node that may have one at most, if the node is not deep, and the edge to an individual
  /// that it asks for, before anything is chosen, because their facts decide alternatives. Whether a node or a fact was
  /// added.
  bool expand_certain();
  /// Which nodes are expanded at a time: all, or a few of the oldest or of the newest ones.
  enum class Order : std::uint8_t { everything, oldest_first, newest_first };
  /// Expands the at-leasts of nodes that are not blocked, from this node on. Whether a node or a fact was added.
  bool expand(NodeId first, Order order);
  /// The choice of how an at-least is satisfied, where the last expand() found one and did nothing else.
  [[nodiscard]] std::optional<Decision> take_offer() { return std::exchange(offer_, std::nullopt); }
  /// Makes a choice of take_offer() true.
  void apply(const Choice& choice, DependencySet dependency);

  /// Sizes of the stacks.
  struct Sizes {
    std::size_t existentials = 0;
    std::uint32_t next_certain = 0;
    std::size_t done = 0;
  };
  [[nodiscard]] Sizes sizes() const { return {existentials_.size(), next_certain_, done_.size()}; }
  void restore(const Sizes& sizes);

 private:
  struct Existential {
    FactId fact = 0;
    NodeId node = 0;
    std::uint32_t older = none;  ///< the next older one of the node
    bool is_done = false;
    DenialWitness witness = {};
    NodeId plain = none;  ///< the neighbour that was made for it without its filler
  };

  struct Open {
    NodeId node = 0;
    std::uint32_t number = 0;
    friend auto operator<=>(const Open&, const Open&) = default;
  };

  /// Updates the marks of blocked nodes, and opens the at-leasts of nodes that are blocked no more. Returns how many
  /// nodes were looked at.
  std::size_t update_open();
  /// Expands the open at-leasts of a node that have smaller numbers than `count`. Returns how many were expanded.
  std::size_t expand_node(NodeId node, std::uint32_t count, bool may_offer);
  /// Whether a node was added, or a fact.
  bool expand_one(std::uint32_t at);
  void note_done(std::uint32_t at);
  [[nodiscard]] bool is_of_several(std::uint32_t at) const;
  enum class Way : std::uint8_t { expanded, satisfied, open };
  Way expand_several(std::uint32_t at, bool may_offer);
  /// Whether the at-least asks for a denial, and no neighbour without a filler was made for one of its role and node.
  [[nodiscard]] bool needs_plain(const Fact& fact) const;
  [[nodiscard]] bool is_of_nominal(const Fact& at_least) const;
  bool has_witness(std::uint32_t at);

  const Program& program_;
  const Graph& graph_;
  Assertions& facts_;
  Blocking& blocking_;
  Witnesses& witnesses_;
  const DenialWitnesses& denial_witnesses_;
  NewNeighbours& new_neighbours_;
  std::vector<Existential> existentials_;
  std::vector<std::uint32_t> newest_;  ///< by node: its newest existential
  /// Existentials that expand() must look at: all that are not done and whose nodes are active and not blocked, and
  /// some others. Most of a large model are not among them.
  std::set<Open> open_;
  std::uint32_t next_certain_ = 0;   ///< each is looked at once by expand_certain()
  std::vector<std::uint32_t> done_;  ///< existentials, in the order in which they were
  std::optional<Decision> offer_;
};

}  // namespace geminga::hypertableau

#endif
