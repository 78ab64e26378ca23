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
  looks_back_.resize(graph_.node_count());
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
    looks_back_[node] = is_tree && looks_back(node);
    const std::uint64_t key = key_of(node);
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
  if (!looks_back_[node]) return {blocker, {first.version, second.version, 0, 0}};
  return {blocker,
          {first.version, second.version, graph_.node(first.parent).version, graph_.node(second.parent).version}};
}

// Without nominals and inverses, the nodes below a root depend on its label only.
bool Blocking::may_block_as_root(const Node& node) const {
  return node.kind == NodeKind::root && !program_.backward_looks().has_inverses() && !program_.has_nominals();
}

// Along an edge between it and its parent.
bool Blocking::looks_back(NodeId node) const {
  const Node& one = graph_.node(node);
  std::uint32_t left = one.backward_edge_count;
  const auto looks = [&](const Fact& edge, bool is_inverse) {
    const Direction direction = direction_of(edge.predicate, is_inverse);
    if (edge.kind != FactKind::role || !program_.backward_looks().directions()[direction]) return false;
    --left;
    return looks_along(node, direction);
  };
  for (FactId id = one.in; id != none && left > 0; id = graph_.fact(id).next_b) {
    if (graph_.fact(id).a == one.parent && looks(graph_.fact(id), true)) return true;
  }
  for (FactId id = one.out; id != none && left > 0; id = graph_.fact(id).next_a) {
    if (graph_.fact(id).b == one.parent && looks(graph_.fact(id), false)) return true;
  }
  return false;
}

bool Blocking::looks_along(NodeId node, Direction direction) const {
  const BackwardLooks& looks = program_.backward_looks();
  if (looks.is_of_all(direction)) return true;
  const auto is_in = [&](std::uint32_t id) { return graph_.find(FactKind::concept_of, id, node) != none; };
  if (std::ranges::any_of(looks.guards(direction), is_in)) return true;
  if (!looks.are_of_at_leasts()) return false;
  for (FactId id = graph_.node(node).others; id != none; id = graph_.next_other(id, node)) {
    const Fact& fact = graph_.fact(id);
    if (fact.kind == FactKind::at_least && program_.directions().of_at_least(fact.predicate).front() == direction)
      return true;
  }
  return false;
}

std::uint64_t Blocking::key_of(NodeId node) const {
  const Node& one = graph_.node(node);
  if (!looks_back_[node]) return one.label_hash;
  constexpr std::uint64_t factor = 0x9e3779b97f4a7c15U;
  return (one.label_hash * factor + one.edge_hash) * factor + graph_.node(one.parent).label_hash;
}

bool Blocking::blocks(NodeId blocker, NodeId node) const {
  if (!graph_.has_label_of(node, blocker) || looks_back_[node] != looks_back_[blocker]) return false;
  if (!looks_back_[node]) return true;
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
