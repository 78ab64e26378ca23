// The closure by inheritance: what is above a class is concluded once, and handed down to all that is below it.
//
// The closure of saturation.hpp applies every rule again in every context: what follows from "Pizza < has some Topping"
// is derived for each kind of pizza. Here what one node has found is copied into its children as a whole, and there
// only rules with two premises that come from different sides are still to be applied. An existential R some A is a
// node as well, to which the existentials above it belong; whatever is below it is its child, so that a link is kept
// once, and not once for all that has it. It is for ontologies without nominals, functional properties and universals,
// whose rules reach into contexts from the side; these are Saturation's.
//
// Legend: M N nodes, N < X "X is an item of N", T owl:Thing, F owl:Nothing, R S roles, R <* S the role hierarchy;
// `R some N` is the node of an existential that leads to N; an item R some N says that this node is above.
#ifndef GEMINGA_REASONING_EL_INHERITANCE_HPP
#define GEMINGA_REASONING_EL_INHERITANCE_HPP

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "base/interner.hpp"
#include "reasoning/el/node.hpp"
#include "reasoning/el/saturation.hpp"

namespace geminga::el {

class InheritanceWorker;

/// What the workers share.
struct Inheriting {
  Inheriting(const IndexedOntology& of, const SaturationLimits& within, std::span<const ExprId> asked);

  const IndexedOntology& index;
  SaturationLimits limits;
  std::uint32_t first_link;  ///< items from here on are nodes of existentials
  NodeStore contexts;
  std::vector<std::atomic<std::uint32_t>> node_of;  ///< by atom: no_node_yet, claimed_node, or the number and 2
  std::vector<std::uint32_t> expected;              ///< by atom: how many ask for its node, by what is told
  /// The nodes of existentials by role and filler, in parts with a lock each.
  struct Part {
    std::mutex mutex;
    base::NumberTable table;
  };
  static constexpr std::size_t part_count = 64;
  std::array<Part, part_count> existentials;
  std::span<const ExprId> seeds;  ///< atoms whose closures are asked for
  std::atomic<std::size_t> next_seed = 0;
  std::atomic<std::size_t> seeds_let_in = 0;  ///< those of this round and of those before
  std::size_t closed = 0;                     ///< nodes that were closed at the end of a round
  std::atomic<bool> is_inconsistent = false;
  std::atomic<bool> is_over_limit = false;
  std::atomic<bool> is_cut_off = false;  ///< it was the budget

  static constexpr std::uint32_t no_node_yet = 0;
  static constexpr std::uint32_t claimed_node = 1;

  [[nodiscard]] bool has_ended() const {
    return is_inconsistent.load(std::memory_order_relaxed) || is_over_limit.load(std::memory_order_relaxed);
  }
};

/// Closes what is above the atoms of `asked`, which are their own representatives and must live as long as this.
class Inheritance {
 public:
  Inheritance(const IndexedOntology& index, const SaturationLimits& limits, std::span<const ExprId> asked);
  Inheritance(const Inheritance&) = delete;
  Inheritance& operator=(const Inheritance&) = delete;
  ~Inheritance();

  /// Whether the ontology is of the kind that this is for.
  [[nodiscard]] static bool is_for(const IndexedOntology& index) {
    return !index.has_nominals() && !index.has_functional() && !index.has_universals();
  }

  /// Applies rules until none is left to fire, or the ontology is found inconsistent. False over a limit. The closure
  /// does not depend on the number of threads; the numbers of nodes do.
  bool run(unsigned threads = 1);

  [[nodiscard]] bool is_consistent() const { return !shared_.is_inconsistent; }
  /// Whether run() ended because the budget was spent.
  [[nodiscard]] bool is_cut_off() const { return shared_.is_cut_off; }
  /// The node of an atom, or no_node where nobody asked for it.
  [[nodiscard]] std::uint32_t find(ExprId atom) const {
    const std::uint32_t entry = shared_.node_of[number(atom)].load(std::memory_order_relaxed);
    return entry <= Inheriting::claimed_node ? no_node : entry - 2;
  }
  [[nodiscard]] const NodeStore& nodes() const { return shared_.contexts; }
  [[nodiscard]] std::size_t conclusion_count() const;
  [[nodiscard]] std::size_t link_count() const;

 private:
  Inheriting shared_;
  std::vector<std::unique_ptr<InheritanceWorker>> workers_;  ///< their arenas hold what nodes know, so they are kept
};

}  // namespace geminga::el

#endif
