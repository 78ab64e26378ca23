// The search for neighbours that a denial does not exclude.
#include "reasoning/dl/hypertableau/denial_witnesses.hpp"

namespace geminga::hypertableau {

using clauses::number;

bool DenialWitnesses::is_about_denial(const Fact& fact) const {
  return fact.kind == FactKind::at_least && program_.needed(fact.predicate) == 1 &&
         program_.denials().is_denial(number(program_.at_least(fact.predicate).filler));
}

bool DenialWitnesses::satisfy(const Fact& at_least, DenialWitness& last) const {
  if (!is_about_denial(at_least)) return false;
  effort_.count_look();
  if (is_valid(last, at_least)) return true;
  last.node = find(at_least.predicate, at_least.a);
  if (last.node == none) return false;
  last.blocker = blocking_.blocker_of(last.node);
  last.version = version_of(number(program_.at_least(at_least.predicate).filler), last.node, at_least.a);
  return true;
}

// After a branch was taken back, the number may be that of another node, so the edge is looked up again.
bool DenialWitnesses::is_valid(const DenialWitness& known, const Fact& at_least) const {
  const clauses::AtLeast& one = program_.at_least(at_least.predicate);
  const std::uint32_t filler = number(one.filler);
  const bool is_inverse = one.role.is_inverse;
  // Changes of an individual beside the witness have no version that is looked at.
  const bool is_noted = !program_.has_nominals() || program_.denials().forbidden(filler).empty();
  return is_noted && known.node < graph_.node_count() && may_be_witness(filler, known.node, at_least.a) &&
         blocking_.blocker_of(known.node) == known.blocker &&
         version_of(filler, known.node, at_least.a) == known.version &&
         graph_.find(FactKind::role, number(one.role.property), is_inverse ? known.node : at_least.a,
                     is_inverse ? at_least.a : known.node) != none;
}

bool DenialWitnesses::may_be_witness(std::uint32_t denial, NodeId node, NodeId of) const {
  const Node& one = graph_.node(node);
  if (one.state != NodeState::active) return false;
  if (program_.denials().forbidden(denial).empty()) return true;
  return one.kind == NodeKind::tree && one.parent == of && (!one.is_blocked || blocking_.blocker_of(node) != none);
}

std::uint64_t DenialWitnesses::version_of(std::uint32_t denial, NodeId node, NodeId of) const {
  const Node& one = graph_.node(node);
  if (program_.denials().forbidden(denial).empty()) return one.version;
  std::uint64_t version = one.version + one.surroundings + graph_.node(of).version;
  if (const NodeId blocker = blocking_.blocker_of(node); blocker != none) {
    const Node& other = graph_.node(blocker);
    version += other.version + other.surroundings;
    if (other.parent != none) version += graph_.node(other.parent).version;
  }
  return version;
}

NodeId DenialWitnesses::find(std::uint32_t at_least, NodeId node) const {
  const clauses::AtLeast& one = program_.at_least(at_least);
  const std::uint32_t filler = number(one.filler);
  const bool is_inverse = one.role.is_inverse;
  for (FactId id = is_inverse ? graph_.node(node).in : graph_.node(node).out; id != none;
       id = is_inverse ? graph_.fact(id).next_b : graph_.fact(id).next_a) {
    effort_.count_look();
    const Fact& edge = graph_.fact(id);
    const NodeId other = is_inverse ? edge.a : edge.b;
    if (edge.kind != FactKind::role || edge.predicate != number(one.role.property)) continue;
    if (!may_be_witness(filler, other, node) || neighbours_.is_denied(filler, other)) continue;
    const NodeId blocker = program_.denials().forbidden(filler).empty() ? none : blocking_.blocker_of(other);
    if (blocker == none || !neighbours_.is_denied(filler, blocker)) return other;
  }
  return none;
}

}  // namespace geminga::hypertableau
