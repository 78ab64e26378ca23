// Which node blocks which. The rule is in blocking.hpp.
#include "reasoning/dl/hypertableau/blocking.hpp"

#include <algorithm>

namespace geminga::hypertableau {

namespace {

/// Nodes that are looked at in the time that a fact takes.
constexpr std::size_t nodes_a_step = 16;

}  // namespace

void Blocking::mark(NodeId node, bool is_blocked) {
  if (graph_.node(node).is_blocked && !is_blocked) unblocked_.push_back(node);
  graph_.set_blocked(node, is_blocked);
}

NodeId Blocking::blocker_of(NodeId node) const {
  if (node >= blocked_by_.size() || !graph_.node(node).is_blocked) return none;
  const NodeId blocker = blocked_by_[node].blocker;
  const bool is_there = blocker < node && graph_.is_active(blocker) && !graph_.node(blocker).is_blocked;
  return is_there ? blocker : none;
}

std::size_t Blocking::update() {
  // Nodes before the first changed one keep their marks.
  const NodeId changed = graph_.take_changed();
  if (changed == none) return 0;
  blockers_.cut(changed);
  blocked_by_.resize(graph_.node_count());
  // Looks at nodes count as steps. Otherwise questions with many nodes would cost nothing and never end.
  const std::size_t looked = graph_.node_count() - std::min<std::size_t>(changed, graph_.node_count());
  effort_.count_steps(looked / nodes_a_step);
  for (NodeId node = changed; node < graph_.node_count(); ++node) {
    const Node& one = graph_.node(node);
    const bool is_tree = one.kind == NodeKind::tree;
    if (one.state != NodeState::active || (is_tree && (graph_.node(one.parent).is_blocked || is_still_blocked(node)))) {
      mark(node, true);
      continue;
    }
    if (!is_tree && !may_block_as_root(one)) {
      mark(node, false);
      continue;
    }
    const std::uint64_t key = key_of(one);
    const NodeId blocker =
        is_tree ? blockers_.find(key, [&](NodeId candidate) { return blocks(candidate, node); }) : none;
    mark(node, blocker != none);
    blocked_by_[node] = compared(node, blocker);
    if (blocker == none) blockers_.push(node, key);
  }
  return looked;
}

// Whether the nodes that were compared when it was blocked are unchanged. When an individual changes, most nodes below
// it do not.
bool Blocking::is_still_blocked(NodeId node) const {
  const NodeId blocker = blocked_by_[node].blocker;
  return blocker < node && graph_.is_active(blocker) && !graph_.node(blocker).is_blocked &&
         blocked_by_[node] == compared(node, blocker);
}

Blocking::BlockedBy Blocking::compared(NodeId node, NodeId blocker) const {
  if (blocker == none) return {};
  const Node& first = graph_.node(node);
  const Node& second = graph_.node(blocker);
  if (!program_.has_inverses()) return {blocker, {first.version, second.version, 0, 0}};
  return {blocker,
          {first.version, second.version, graph_.node(first.parent).version, graph_.node(second.parent).version}};
}

// Without nominals and inverses, the nodes below a root depend on its label only.
bool Blocking::may_block_as_root(const Node& node) const {
  return node.kind == NodeKind::root && !program_.has_inverses() && !program_.has_nominals();
}

std::uint64_t Blocking::key_of(const Node& node) const {
  if (!program_.has_inverses()) return node.label_hash;
  constexpr std::uint64_t factor = 0x9e3779b97f4a7c15U;
  return (node.label_hash * factor + node.edge_hash) * factor + graph_.node(node.parent).label_hash;
}

bool Blocking::blocks(NodeId blocker, NodeId node) const {
  if (!graph_.has_label_of(node, blocker)) return false;
  if (!program_.has_inverses()) return true;
  const NodeId parent = graph_.node(node).parent;
  const NodeId other = graph_.node(blocker).parent;
  return graph_.has_label_of(parent, other) && has_same_edges(node, blocker);
}

// Whether the same roles lead between the nodes and their parents.
bool Blocking::has_same_edges(NodeId node, NodeId other) const {
  const Node& first = graph_.node(node);
  const Node& second = graph_.node(other);
  if (first.edge_count != second.edge_count || first.edge_hash != second.edge_hash) return false;
  for (FactId id = second.in; id != none; id = graph_.fact(id).next_b) {
    const Fact& fact = graph_.fact(id);
    if (fact.kind != FactKind::role || fact.a != second.parent) continue;
    if (graph_.find(FactKind::role, fact.predicate, first.parent, node) == none) return false;
  }
  for (FactId id = second.out; id != none; id = graph_.fact(id).next_a) {
    const Fact& fact = graph_.fact(id);
    if (fact.kind != FactKind::role || fact.b != second.parent) continue;
    if (graph_.find(FactKind::role, fact.predicate, node, first.parent) == none) return false;
  }
  return true;
}

}  // namespace geminga::hypertableau
