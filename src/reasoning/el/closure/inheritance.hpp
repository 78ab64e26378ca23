// The closure by inheritance: what is above a class is concluded once and handed down to all classes below it.
//
// The closure of saturation.hpp applies every rule again in each context: what follows from "Pizza < has some Topping"
// is derived for each kind of pizza. Here a node copies the items of the nodes above it as a whole. Only rules with two
// premises from different sides are still to be applied in it. An existential R some A is a node, too. Everything below
// it is a child of it, so that a link is kept once and not for each context that has it. Nominals, functional
// properties and universals reach into contexts from the side; ontologies with them are left to Saturation.
//
// Legend: M N nodes, N < X "X is an item of N", T owl:Thing, F owl:Nothing, R S roles, R <* S the role hierarchy;
// `R some N` is the node of an existential that leads to N; an item R some N says that this node is above.
#ifndef GEMINGA_REASONING_EL_CLOSURE_INHERITANCE_HPP
#define GEMINGA_REASONING_EL_CLOSURE_INHERITANCE_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "reasoning/el/closure/nodes.hpp"
#include "reasoning/el/index/open_parts.hpp"

namespace geminga::el {

class InheritanceWorker;

/// Closes what is above the atoms of `asked`, which are their own representatives and must live as long as this.
class Inheritance {
 public:
  Inheritance(const IndexedOntology& index, const SaturationLimits& limits, std::span<const ExprId> asked);
  Inheritance(const Inheritance&) = delete;
  Inheritance& operator=(const Inheritance&) = delete;
  ~Inheritance();

  /// True if a closure by inheritance finds all that the rules derive of the ontology.
  [[nodiscard]] static bool is_for(const IndexedOntology& index) {
    return !index.has_nominals() && !index.has_functional() && !index.has_universals();
  }

  /// Applies rules until none can fire or the ontology is found inconsistent. False over a limit. The closure does not
  /// depend on the number of threads; the numbers of nodes do.
  bool run(unsigned threads = 1);

  /// True if all that the closure lacks of ranges over chains changes nothing (ranges.hpp). False says only that rules
  /// are needed. Requires a run that ended consistent and within its limits; the nodes are of no use afterwards.
  [[nodiscard]] bool has_ranges(std::span<const OpenRange> ranges);

  [[nodiscard]] bool is_consistent() const { return !shared_.is_inconsistent; }
  /// True if run() ended because the budget was spent.
  [[nodiscard]] bool is_cut_off() const { return shared_.is_cut_off; }
  /// The node of an atom, or no_node if it was never required.
  [[nodiscard]] std::uint32_t find(ExprId atom) const { return shared_.find(atom); }
  [[nodiscard]] const NodeStore& nodes() const { return shared_.contexts; }
  [[nodiscard]] std::size_t conclusion_count() const;
  [[nodiscard]] std::size_t link_count() const;

 private:
  SharedNodes shared_;
  std::vector<std::unique_ptr<InheritanceWorker>> workers_;  ///< their arenas hold the contents of nodes
};

}  // namespace geminga::el

#endif
