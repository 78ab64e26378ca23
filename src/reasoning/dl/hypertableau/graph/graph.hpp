// The model under construction: nodes and facts on stacks, so that going back cuts them.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_GRAPH_GRAPH_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_GRAPH_GRAPH_HPP

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/label_filter.hpp"

namespace geminga::hypertableau {

using NodeId = std::uint32_t;
using FactId = std::uint32_t;
inline constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

enum class FactKind : std::uint8_t {
  concept_of,     ///< predicate(a)
  role,           ///< predicate(a, b)
  at_least,       ///< an index of ClauseSet::at_leasts, of a
  at_most,        ///< an index of Program::bounds, of a
  unequal,        ///< a and b differ; a < b
  data_role,      ///< predicate(a, b), b a value
  data_range,     ///< predicate(a), a a value
  data_at_least,  ///< an index of ClauseSet::data_at_leasts, of a
};

/// Whether facts of this kind are of one node alone: its concepts, number restrictions and ranges.
[[nodiscard]] constexpr bool is_label(FactKind kind) {
  return kind != FactKind::role && kind != FactKind::data_role && kind != FactKind::unequal;
}

struct Fact {
  FactKind kind = FactKind::concept_of;
  std::uint32_t predicate = 0;
  NodeId a = 0;
  NodeId b = 0;
  DependencySet dependency = no_dependency;
  FactId next_a = none;  ///< the next older fact in the list of a
  FactId next_b = none;
};

enum class NodeKind : std::uint8_t {
  root,      ///< an individual, the instance that was asked for, or one that the NI rule made: never blocked
  tree,      ///< made for an at-least of its parent
  constant,  ///< the value of a literal
  value,     ///< a value made for an at-least of its parent
};
[[nodiscard]] constexpr bool is_value(NodeKind kind) { return kind == NodeKind::constant || kind == NodeKind::value; }
enum class NodeState : std::uint8_t { active, merged, pruned };

struct Node {
  NodeKind kind = NodeKind::tree;
  NodeState state = NodeState::active;
  bool is_blocked = false;  ///< it or an ancestor, when Blocking last looked
  bool is_changed = false;  ///< of a value: take_changed_values() will have it
  std::uint32_t depth = 0;
  NodeId parent = none;
  NodeId merged_into = none;
  DependencySet merged_by = no_dependency;
  std::uint32_t literal = none;  ///< of constants: the term
  NodeId first_child = none;
  NodeId next_child = none;
  std::uint32_t siblings = none;  ///< an index; see Graph::siblings_of()
  // The newest fact of each list.
  FactId labels = none;
  FactId out = none;
  FactId in = none;
  FactId others = none;
  std::uint32_t label_count = 0;
  std::uint32_t edge_count = 0;           ///< between it and its parent
  std::uint32_t backward_edge_count = 0;  ///< those of them along which some node looks back
  std::uint32_t stale_count = 0;          ///< concepts that were taken back since its filter was made
  /// Changes whenever the label, the edge to the parent or the state changes.
  std::uint64_t version = 0;
  /// Changes whenever an edge or an inequality of it changes, or the label of a child.
  std::uint64_t surroundings = 0;
  std::uint64_t label_hash = 0;  ///< of a set: order does not matter
  std::uint64_t edge_hash = 0;
};

/// Nodes with consecutive numbers, each of which differs from each: those that were made together for one at-least, or
/// the individuals of clauses::ClauseSet::apart. It is known of them as a group, because the pairs are as many as the
/// square of their number.
struct Siblings {
  NodeId first = 0;
  NodeId end = 0;
  DependencySet dependency = no_dependency;
};

/// A place on the stack.
struct Mark {
  std::size_t facts = 0;
  std::size_t nodes = 0;
  std::size_t trail = 0;
};

class Graph {
 public:
  /// By twice the number of a property, and one more from the parent to the child: whether some node looks back along
  /// such an edge to its parent.
  explicit Graph(std::vector<bool> looks_back) : looks_back_(std::move(looks_back)) {}

  [[nodiscard]] const std::vector<Fact>& facts() const { return facts_; }
  [[nodiscard]] const Fact& fact(FactId id) const { return facts_[id]; }
  [[nodiscard]] std::size_t node_count() const { return nodes_.size(); }
  [[nodiscard]] const Node& node(NodeId id) const { return nodes_[id]; }
  /// The nodes that are values, ascending; some are merged or pruned.
  [[nodiscard]] const std::vector<NodeId>& values() const { return values_; }
  [[nodiscard]] bool is_active(NodeId id) const { return nodes_[id].state == NodeState::active; }
  void set_blocked(NodeId id, bool is_blocked) { nodes_[id].is_blocked = is_blocked; }

  NodeId add_node(NodeKind kind, NodeId parent);
  void set_literal(NodeId id, std::uint32_t literal) { nodes_[id].literal = literal; }
  [[nodiscard]] FactId find(FactKind kind, std::uint32_t predicate, NodeId a, NodeId b = 0) const;
  /// Adds a fact that find() did not find.
  FactId add(const Fact& fact);

  /// Says that the newest nodes, from `first` on, all differ from each other.
  void set_siblings(NodeId first, DependencySet dependency);
  /// Requires that the node has siblings.
  [[nodiscard]] const Siblings& siblings_of(NodeId node) const { return siblings_[nodes_[node].siblings]; }
  [[nodiscard]] bool are_siblings(NodeId a, NodeId b) const {
    return nodes_[a].siblings != none && nodes_[a].siblings == nodes_[b].siblings && a != b;
  }
  /// Why the nodes differ, if they are known to.
  [[nodiscard]] std::optional<DependencySet> difference(NodeId a, NodeId b) const;

  /// Makes `to` stand for `from`, and prunes the tree below `from`.
  void merge(NodeId from, NodeId to, DependencySet by);
  void prune(NodeId node);
  /// The node that stands for this one after merges. Unites the reasons into `dependency`. It may be pruned.
  [[nodiscard]] NodeId current(NodeId id, DependencySet& dependency) const;
  /// The same without the reasons.
  [[nodiscard]] NodeId current(NodeId id) const {
    while (nodes_[id].state == NodeState::merged) id = nodes_[id].merged_into;
    return id;
  }

  // The sets of branches that facts depend on. Each is stored once, so one more changes nothing that a reader sees.
  [[nodiscard]] DependencySet unite(DependencySet first, DependencySet second) const {
    return sets_.unite(first, second);
  }
  [[nodiscard]] DependencySet depending_on(std::uint32_t branch) const { return sets_.single(branch); }
  [[nodiscard]] const DependencySets& dependencies() const { return sets_; }
  /// Requires that no node and no fact is left.
  void forget_dependencies() { sets_.clear(); }

  [[nodiscard]] Mark mark() const { return {facts_.size(), nodes_.size(), trail_.size()}; }
  void cut(const Mark& mark);

  /// The first node whose label, edges or state may have changed since the last call.
  [[nodiscard]] NodeId take_changed() { return std::exchange(changed_, none); }
  /// The values whose version or surroundings may have changed since the last call, in any order. Some may be gone.
  [[nodiscard]] std::vector<NodeId> take_changed_values();
  /// Whether they are in the same concepts and number restrictions.
  [[nodiscard]] bool has_label_of(NodeId node, NodeId other) const;

  /// The next fact in the list `others` of the node, which may be either end of a fact.
  [[nodiscard]] FactId next_other(FactId id, NodeId node) const {
    return facts_[id].a == node ? facts_[id].next_a : facts_[id].next_b;
  }

 private:
  /// The upper half of the hash tells most other facts apart without a look at them, which costs a cache line each.
  struct Slot {
    FactId fact = none;
    std::uint32_t tag = 0;
  };
  [[nodiscard]] static std::uint64_t hash_of(const Fact& fact);
  /// Puts a fact into the first free slot of its chain.
  void fill_slot(FactId id);
  /// False: the fact is not there. Only labels are known of.
  [[nodiscard]] bool may_have(FactKind kind, std::uint32_t predicate, NodeId node) const {
    if (kind == FactKind::concept_of) return filters_[node].may_have_concept(predicate);
    return !is_label(kind) || filters_[node].may_have_other(static_cast<std::uint32_t>(kind), predicate);
  }
  void add_to_filter(const Fact& fact);
  /// Makes the filter of the node again once so many concepts were taken back that it may claim much too much.
  void note_stale(NodeId node);
  void count_label(const Fact& fact, bool is_added);
  void count_edge(const Fact& fact, bool is_added);
  void link(FactId id);
  void unlink(FactId id);
  void grow();
  void set_state(NodeId node, NodeState state);
  void note_change(NodeId node) {
    changed_ = std::min(changed_, node);
    note_value(node);
  }
  void note_value(NodeId node);
  void note_surroundings(const Fact& fact);

  std::vector<bool> looks_back_;
  mutable DependencySets sets_;
  std::vector<Node> nodes_;
  std::vector<LabelFilter> filters_;  ///< of nodes_; apart, because a look at a filter needs nothing else of its node
  std::vector<Fact> facts_;
  /// Open addressing. Facts are removed in the reverse order, so an emptied slot breaks no chain of slots.
  std::vector<Slot> slots_;
  std::vector<Siblings> siblings_;  ///< ascending by their nodes
  std::vector<NodeId> trail_;       ///< nodes that were merged or pruned
  std::vector<NodeId> values_;
  std::vector<NodeId> changed_values_;
  NodeId changed_ = 0;
  std::uint64_t versions_ = 0;
};

}  // namespace geminga::hypertableau

#endif
