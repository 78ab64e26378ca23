// Number restrictions of a node, compared with each other without any neighbour (program/number_order.hpp).
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_NUMBERS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_NUMBERS_HPP

#include <cstdint>
#include <span>

#include "reasoning/dl/hypertableau/facts/choice.hpp"
#include "reasoning/dl/hypertableau/facts/effort.hpp"
#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"

namespace geminga::hypertableau {

/// Says what the number restrictions in the graph imply about others. It changes nothing.
class Numbers {
 public:
  Numbers(const Program& program, const Graph& graph, Effort& effort)
      : program_(program), graph_(graph), effort_(effort) {}

  /// Whether another restriction of the node implies the choice. False of choices that are no number restrictions.
  [[nodiscard]] bool implies(const Choice& choice) const;
  /// Whether another restriction of the node excludes the choice. If so, unites the reasons into `dependency`.
  [[nodiscard]] bool excludes(const Choice& choice, DependencySet& dependency) const;
  /// Whether the bound holds of the node: of everything, as a fact, or by a rule without alternatives whose guard
  /// holds. If so, unites the reasons into `dependency`.
  [[nodiscard]] bool is_in_force(std::uint32_t bound, NodeId node, DependencySet& dependency) const;
  /// Whether the bound holds of the node, and at-leasts of the node exclude it. If so, unites the reasons into
  /// `dependency`.
  [[nodiscard]] bool is_exceeded(std::uint32_t bound, NodeId node, DependencySet& dependency) const;

 private:
  [[nodiscard]] bool are_too_many(const Choice& choice, DependencySet& dependency) const;
  [[nodiscard]] bool are_too_many(std::uint32_t bound, const Choice& choice, DependencySet& dependency) const;
  [[nodiscard]] bool are_covered(const Choice& choice, DependencySet& dependency) const;
  [[nodiscard]] bool are_fewer(const Cover& cover, std::uint32_t count, const Choice& choice,
                               DependencySet& dependency) const;
  [[nodiscard]] bool has_concepts(std::span<const std::uint32_t> concepts, NodeId node,
                                  DependencySet& dependency) const;

  const Program& program_;
  const Graph& graph_;
  Effort& effort_;
  mutable std::uint32_t bounds_looked_at_ = 0;
};

}  // namespace geminga::hypertableau

#endif
