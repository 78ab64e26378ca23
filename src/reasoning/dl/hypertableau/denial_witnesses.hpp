// Neighbours that are there and may be in the filler of an at-least, because it is a denial (program/denials.hpp).
//
// If more than the label matters, the witness must be a child: only then has each copy of the node in the unravelled
// model a copy of the witness with all that is around it. What is around a blocked child in the model is its parent,
// and what is around its blocker.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_DENIAL_WITNESSES_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_DENIAL_WITNESSES_HPP

#include <cstdint>

#include "reasoning/dl/hypertableau/blocking.hpp"
#include "reasoning/dl/hypertableau/facts/effort.hpp"
#include "reasoning/dl/hypertableau/facts/neighbours.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"

namespace geminga::hypertableau {

/// The neighbour that satisfied an at-least when it was last looked at, and the versions of what was looked at.
struct DenialWitness {
  NodeId node = none;
  NodeId blocker = none;
  std::uint64_t version = 0;
};

/// Looks for neighbours that a denial does not exclude. It changes no fact.
class DenialWitnesses {
 public:
  DenialWitnesses(const Program& program, const Graph& graph, Effort& effort, const Neighbours& neighbours,
                  const Blocking& blocking)
      : program_(program), graph_(graph), effort_(effort), neighbours_(neighbours), blocking_(blocking) {}

  /// Whether the fact is an at-least of one neighbour whose filler is a denial.
  [[nodiscard]] bool is_about_denial(const Fact& fact) const;
  /// Whether it is, and some neighbour may be in the filler. The answer holds until the neighbour changes, or what is
  /// around it, and so `last` is kept for the next look.
  [[nodiscard]] bool satisfy(const Fact& at_least, DenialWitness& last) const;

 private:
  [[nodiscard]] bool is_valid(const DenialWitness& known, const Fact& at_least) const;
  [[nodiscard]] NodeId find(std::uint32_t at_least, NodeId node) const;
  [[nodiscard]] bool may_be_witness(std::uint32_t denial, NodeId node, NodeId of) const;
  [[nodiscard]] std::uint64_t version_of(std::uint32_t denial, NodeId node, NodeId of) const;

  const Program& program_;
  const Graph& graph_;
  Effort& effort_;
  const Neighbours& neighbours_;
  const Blocking& blocking_;
};

}  // namespace geminga::hypertableau

#endif
