// The stack of facts, its hash table and the lists of each node.
#include "reasoning/dl/hypertableau/graph/graph.hpp"

namespace geminga::hypertableau {
namespace {

constexpr std::uint64_t mixed(std::uint64_t word) {
  word ^= word >> 33;
  word *= 0xff51afd7ed558ccdU;
  word ^= word >> 33;
  word *= 0xc4ceb9fe1a85ec53U;
  return word ^ (word >> 33);
}

bool is_edge(FactKind kind) { return kind == FactKind::role || kind == FactKind::data_role; }

}  // namespace

std::uint64_t Graph::hash_of(const Fact& fact) {
  const std::uint64_t ends = (std::uint64_t{fact.a} << 32) | fact.b;
  return mixed(ends * 0x9e3779b97f4a7c15U + (std::uint64_t{fact.predicate} << 8) +
               static_cast<std::uint64_t>(fact.kind));
}

void Graph::note_value(NodeId node) {
  if (!is_value(nodes_[node].kind) || nodes_[node].is_changed) return;
  nodes_[node].is_changed = true;
  changed_values_.push_back(node);
}

void Graph::note_surroundings(const Fact& fact) {
  nodes_[fact.a].surroundings = nodes_[fact.b].surroundings = ++versions_;
  note_value(fact.a);
  note_value(fact.b);
}

std::vector<NodeId> Graph::take_changed_values() {
  for (const NodeId node : changed_values_) {
    if (node < nodes_.size()) nodes_[node].is_changed = false;
  }
  return std::exchange(changed_values_, {});
}

void Graph::count_label(const Fact& fact, bool is_added) {
  if (!is_label(fact.kind)) return;
  const std::uint64_t hash = mixed((std::uint64_t{fact.predicate} << 8) + static_cast<std::uint64_t>(fact.kind) + 1);
  nodes_[fact.a].label_hash += is_added ? hash : std::uint64_t{0} - hash;
  nodes_[fact.a].label_count += is_added ? 1U : ~0U;
  nodes_[fact.a].version = ++versions_;
  if (nodes_[fact.a].parent != none) nodes_[nodes_[fact.a].parent].surroundings = versions_;
  note_change(fact.a);
}

bool Graph::has_label_of(NodeId node, NodeId other) const {
  if (nodes_[node].label_hash != nodes_[other].label_hash || nodes_[node].label_count != nodes_[other].label_count) {
    return false;
  }
  for (const FactId list : {nodes_[other].labels, nodes_[other].others}) {
    for (FactId id = list; id != none; id = next_other(id, other)) {
      if (is_label(facts_[id].kind) && find(facts_[id].kind, facts_[id].predicate, node) == none) return false;
    }
  }
  return true;
}

NodeId Graph::add_node(NodeKind kind, NodeId parent) {
  const auto id = static_cast<NodeId>(nodes_.size());
  Node& node = nodes_.emplace_back();
  filters_.emplace_back();
  node.kind = kind;
  node.parent = parent;
  node.version = ++versions_;
  if (is_value(kind)) values_.push_back(id);
  if (parent != none) {
    node.depth = nodes_[parent].depth + 1;
    node.next_child = nodes_[parent].first_child;
    nodes_[parent].first_child = id;
  }
  note_change(id);
  return id;
}

FactId Graph::find(FactKind kind, std::uint32_t predicate, NodeId a, NodeId b) const {
  if (slots_.empty() || !may_have(kind, predicate, a)) return none;
  const std::size_t mask = slots_.size() - 1;
  const std::uint64_t hash = hash_of({kind, predicate, a, b});
  const auto tag = static_cast<std::uint32_t>(hash >> 32);
  for (std::size_t slot = hash & mask; slots_[slot].fact != none; slot = (slot + 1) & mask) {
    if (slots_[slot].tag != tag) continue;
    const Fact& fact = facts_[slots_[slot].fact];
    if (fact.a == a && fact.predicate == predicate && fact.b == b && fact.kind == kind) return slots_[slot].fact;
  }
  return none;
}

void Graph::set_siblings(NodeId first, DependencySet dependency) {
  const auto end = static_cast<NodeId>(nodes_.size());
  if (first + 1 >= end) return;
  for (NodeId node = first; node < end; ++node) nodes_[node].siblings = static_cast<std::uint32_t>(siblings_.size());
  siblings_.push_back({first, end, dependency});
  const NodeId parent = nodes_[first].parent;
  if (parent != none) nodes_[parent].surroundings = ++versions_;
}

std::optional<DependencySet> Graph::difference(NodeId a, NodeId b) const {
  if (are_siblings(a, b)) return siblings_of(a).dependency;
  const FactId fact = find(FactKind::unequal, 0, std::min(a, b), std::max(a, b));
  if (fact == none) return std::nullopt;
  return facts_[fact].dependency;
}

void Graph::grow() {
  slots_.assign(slots_.empty() ? 1024 : slots_.size() * 2, Slot{});
  for (FactId id = 0; id < facts_.size(); ++id) fill_slot(id);  // in the order in which they came
}

void Graph::fill_slot(FactId id) {
  const std::size_t mask = slots_.size() - 1;
  const std::uint64_t hash = hash_of(facts_[id]);
  std::size_t slot = hash & mask;
  while (slots_[slot].fact != none) slot = (slot + 1) & mask;
  slots_[slot] = {id, static_cast<std::uint32_t>(hash >> 32)};
}

FactId Graph::add(const Fact& fact) {
  if ((facts_.size() + 1) * 2 > slots_.size()) grow();
  const auto id = static_cast<FactId>(facts_.size());
  facts_.push_back(fact);
  fill_slot(id);
  link(id);
  return id;
}

void Graph::add_to_filter(const Fact& fact) {
  if (fact.kind == FactKind::concept_of) {
    filters_[fact.a].add_concept(fact.predicate);
  } else if (is_label(fact.kind)) {
    filters_[fact.a].add_other(static_cast<std::uint32_t>(fact.kind), fact.predicate);
  }
}

void Graph::note_stale(NodeId id) {
  constexpr std::uint32_t few_stale = 16;
  Node& node = nodes_[id];
  if (++node.stale_count <= few_stale + node.label_count) return;
  node.stale_count = 0;
  filters_[id].forget_concepts();
  for (FactId label = node.labels; label != none; label = facts_[label].next_a) add_to_filter(facts_[label]);
}

void Graph::link(FactId id) {
  Fact& fact = facts_[id];
  add_to_filter(fact);
  Node& a = nodes_[fact.a];
  count_label(fact, true);
  if (fact.kind == FactKind::concept_of) {
    fact.next_a = a.labels;
    a.labels = id;
  } else if (is_edge(fact.kind)) {
    fact.next_a = a.out;
    a.out = id;
    fact.next_b = nodes_[fact.b].in;
    nodes_[fact.b].in = id;
    count_edge(fact, true);
    note_surroundings(fact);
  } else {
    fact.next_a = a.others;
    a.others = id;
    if (fact.kind == FactKind::unequal) {
      fact.next_b = nodes_[fact.b].others;
      nodes_[fact.b].others = id;
      note_surroundings(fact);
    }
  }
}

void Graph::unlink(FactId id) {
  const Fact& fact = facts_[id];
  Node& a = nodes_[fact.a];
  count_label(fact, false);
  if (fact.kind == FactKind::concept_of) {
    a.labels = fact.next_a;
    note_stale(fact.a);
  } else if (is_edge(fact.kind)) {
    a.out = fact.next_a;
    nodes_[fact.b].in = fact.next_b;
    count_edge(fact, false);
    note_surroundings(fact);
  } else {
    a.others = fact.next_a;
    if (fact.kind == FactKind::unequal) {
      nodes_[fact.b].others = fact.next_b;
      note_surroundings(fact);
    }
  }
}

void Graph::count_edge(const Fact& fact, bool is_added) {
  if (fact.kind != FactKind::role || fact.a == fact.b) return;
  const bool is_down = nodes_[fact.b].parent == fact.a;
  const bool is_up = nodes_[fact.a].parent == fact.b;
  if (!is_down && !is_up) return;
  Node& child = nodes_[is_down ? fact.b : fact.a];
  const std::uint64_t hash = mixed((std::uint64_t{fact.predicate} << 1) + (is_down ? 1 : 0) + 0x2545f491U);
  child.edge_hash += is_added ? hash : std::uint64_t{0} - hash;
  child.edge_count += is_added ? 1U : ~0U;
  if (looks_back_[2 * std::size_t{fact.predicate} + (is_down ? 1 : 0)])
    child.backward_edge_count += is_added ? 1U : ~0U;
  child.version = ++versions_;
  note_change(is_down ? fact.b : fact.a);
}

void Graph::set_state(NodeId node, NodeState state) {
  nodes_[node].state = state;
  nodes_[node].version = ++versions_;
  note_change(node);
  trail_.push_back(node);
}

void Graph::prune(NodeId node) {
  std::vector<NodeId> open = {node};
  while (!open.empty()) {
    const NodeId above = open.back();
    open.pop_back();
    for (NodeId child = nodes_[above].first_child; child != none; child = nodes_[child].next_child) {
      const bool is_tree = nodes_[child].kind == NodeKind::tree || nodes_[child].kind == NodeKind::value;
      if (!is_tree || !is_active(child)) continue;
      set_state(child, NodeState::pruned);
      open.push_back(child);
    }
  }
}

void Graph::merge(NodeId from, NodeId to, DependencySet by) {
  set_state(from, NodeState::merged);
  nodes_[from].merged_into = to;
  nodes_[from].merged_by = by;
  prune(from);
}

NodeId Graph::current(NodeId id, DependencySet& dependency) const {
  while (nodes_[id].state == NodeState::merged) {
    dependency = sets_.unite(dependency, nodes_[id].merged_by);
    id = nodes_[id].merged_into;
  }
  return id;
}

void Graph::cut(const Mark& mark) {
  while (facts_.size() > mark.facts) {
    const auto id = static_cast<FactId>(facts_.size() - 1);
    unlink(id);
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash_of(facts_[id]) & mask;
    while (slots_[slot].fact != id) slot = (slot + 1) & mask;
    slots_[slot] = {};
    facts_.pop_back();
  }
  while (trail_.size() > mark.trail) {
    Node& node = nodes_[trail_.back()];
    note_change(trail_.back());
    node.state = NodeState::active;
    node.version = ++versions_;
    node.merged_into = none;
    trail_.pop_back();
  }
  while (!siblings_.empty() && siblings_.back().end > mark.nodes) {
    for (NodeId node = siblings_.back().first; node < std::min<std::size_t>(siblings_.back().end, mark.nodes); ++node) {
      nodes_[node].siblings = none;
    }
    siblings_.pop_back();
  }
  while (nodes_.size() > mark.nodes) {
    const Node& node = nodes_.back();
    if (node.parent != none) nodes_[node.parent].first_child = node.next_child;
    if (is_value(node.kind)) values_.pop_back();
    nodes_.pop_back();
    filters_.pop_back();
    changed_ = std::min(changed_, static_cast<NodeId>(nodes_.size()));
  }
}

}  // namespace geminga::hypertableau
