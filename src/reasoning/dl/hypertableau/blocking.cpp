// Which nodes need not be expanded, as another one that is like them has been.
//
//   x is blocked by an older y that is not, if both are in the same concepts and so are their parents, with the same
//   edges between (pairwise anywhere blocking); where no clause looks back along an edge, the node alone is compared.
//   What is under a blocked node is blocked.
//
// The nodes of the models of earlier questions block, too: see Search::keep_model().
#include "reasoning/dl/hypertableau/blockers.hpp"
#include "reasoning/dl/hypertableau/search.hpp"

namespace geminga::hypertableau {

void Blockers::push(NodeId node, std::uint64_t key) {
  if (entries_.size() >= heads_.size()) grow();
  std::uint32_t& head = heads_[slot_of(key)];
  entries_.push_back({key, node, head});
  head = static_cast<std::uint32_t>(entries_.size() - 1);
}

void Blockers::cut(NodeId first) {
  while (!entries_.empty() && entries_.back().node >= first) {
    heads_[slot_of(entries_.back().key)] = entries_.back().older;
    entries_.pop_back();
  }
}

void Blockers::grow() {
  heads_.assign(heads_.empty() ? 256 : heads_.size() * 2, none);
  for (std::uint32_t at = 0; at < entries_.size(); ++at) {
    std::uint32_t& head = heads_[slot_of(entries_[at].key)];
    entries_[at].older = head;
    head = at;
  }
}

namespace {

/// So many nodes are looked at in the time that a fact takes.
constexpr std::size_t nodes_a_step = 16;

}  // namespace

/// How many nodes were looked at.
std::size_t Tableau::Search::find_blocked() {
  // What is older than any change is as it was.
  const NodeId changed = graph_.take_changed();
  if (changed == none) return 0;
  blockers_.cut(changed);
  blocked_by_.resize(graph_.node_count());
  // Or questions with many nodes would take no steps and no end.
  const std::size_t looked = graph_.node_count() - std::min<std::size_t>(changed, graph_.node_count());
  steps_ += looked / nodes_a_step;
  for (NodeId node = changed; node < graph_.node_count(); ++node) {
    const Node& one = graph_.node(node);
    const bool is_tree = one.kind == NodeKind::tree;
    if (one.state != NodeState::active || (!is_tree && !may_block_as_root(one))) continue;
    if (is_tree && graph_.node(one.parent).is_blocked) {
      graph_.set_blocked(node, true);
      continue;
    }
    if (is_tree && is_still_blocked(node)) {
      graph_.set_blocked(node, true);
      continue;
    }
    const std::uint64_t key = blocking_key(one);
    const NodeId blocker =
        is_tree ? blockers_.find(key, [&](NodeId candidate) { return blocks(candidate, node); }) : none;
    graph_.set_blocked(node, blocker != none);
    blocked_by_[node] = compared(node, blocker);
    if (blocker == none) blockers_.push(node, key);
  }
  return looked;
}

/// Whether nothing that was compared when it was blocked has changed. Where individuals change, most of what is under
/// them has not.
bool Tableau::Search::is_still_blocked(NodeId node) const {
  const NodeId blocker = blocked_by_[node].blocker;
  return blocker < node && graph_.is_active(blocker) && !graph_.node(blocker).is_blocked &&
         blocked_by_[node] == compared(node, blocker);
}

Tableau::Search::BlockedBy Tableau::Search::compared(NodeId node, NodeId blocker) const {
  if (blocker == none) return {};
  const Node& first = graph_.node(node);
  const Node& second = graph_.node(blocker);
  if (!program_.has_inverses()) return {blocker, {first.version, second.version, 0, 0}};
  return {blocker,
          {first.version, second.version, graph_.node(first.parent).version, graph_.node(second.parent).version}};
}

/// Without nominals and inverses a root is like any other node in what is below it.
bool Tableau::Search::may_block_as_root(const Node& node) const {
  return node.kind == NodeKind::root && !program_.has_inverses() && !program_.has_nominals();
}

std::uint64_t Tableau::Search::blocking_key(const Node& node) const {
  if (!program_.has_inverses()) return node.label_hash;
  constexpr std::uint64_t factor = 0x9e3779b97f4a7c15U;
  return (node.label_hash * factor + node.edge_hash) * factor + graph_.node(node.parent).label_hash;
}

bool Tableau::Search::blocks(NodeId blocker, NodeId node) const {
  if (!graph_.has_label_of(node, blocker)) return false;
  if (!program_.has_inverses()) return true;
  const NodeId parent = graph_.node(node).parent;
  const NodeId other = graph_.node(blocker).parent;
  return graph_.has_label_of(parent, other) && has_same_edges(node, blocker);
}

/// Whether the same roles lead between the nodes and their parents.
bool Tableau::Search::has_same_edges(NodeId node, NodeId other) const {
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
