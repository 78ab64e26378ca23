// Writes nodes and facts into the model under construction, and merges nodes.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_ASSERTIONS_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_FACTS_ASSERTIONS_HPP

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "reasoning/dl/hypertableau/facts/choice.hpp"
#include "reasoning/dl/hypertableau/facts/effort.hpp"
#include "reasoning/dl/hypertableau/facts/value_check.hpp"
#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"

namespace geminga::hypertableau {

/// Writes nodes and facts into the graph. A fact that cannot hold is a clash. Nodes that are equal wait to be merged.
class Assertions {
 public:
  Assertions(const owl::Ontology& source, const clauses::ClauseSet& set, const Program& program, Graph& graph,
             Effort& effort);

  // Nodes.
  NodeId add_node(NodeKind kind, NodeId parent, DependencySet dependency);
  NodeId add_value(NodeId parent) { return graph_.add_node(NodeKind::value, parent); }
  /// Adds the nodes of so many individuals. The first ones are of those that are `apart`: they differ from each other.
  void add_individuals(std::size_t count, std::span<const clauses::IndividualId> apart);
  /// The node of each individual, as it was added. After merges Graph::current() gives the node that stands for it.
  [[nodiscard]] std::span<const NodeId> individuals() const { return individuals_; }
  /// The node of the value of a literal.
  NodeId constant(owl::TermId literal);

  // Facts. A fact that is added again keeps its first dependency set.
  void add_fact(FactKind kind, std::uint32_t predicate, NodeId a, NodeId b, DependencySet dependency);
  void add_unequal(NodeId a, NodeId b, DependencySet dependency);
  /// The newest nodes, from `first` on, all differ from each other.
  void add_siblings(NodeId first, DependencySet dependency);
  /// Makes a choice true.
  void apply(Choice choice, DependencySet dependency);
  [[nodiscard]] bool holds(const Choice& choice);
  /// Whether the choice can hold nowhere.
  [[nodiscard]] bool is_impossible(const Choice& choice);

  // Clashes. The first one counts.
  void clash(DependencySet dependency);
  [[nodiscard]] bool has_clash() const { return has_clash_; }
  [[nodiscard]] DependencySet clash_dependency() const { return clash_; }
  /// Whether there is a clash, or a limit is passed.
  [[nodiscard]] bool must_stop() { return has_clash_ || effort_.is_over_limit(); }
  void forget_clash() { has_clash_ = false; }

  // Merges.
  void add_merge(NodeId a, NodeId b, DependencySet dependency) { merges_.push_back({a, b, dependency}); }
  [[nodiscard]] bool has_merges() const { return !merges_.empty(); }
  /// Merges all that wait, and those that merging adds, until there is a clash.
  void merge_all();
  /// The individual of this number of those that the bound allows the node (NI-rule, bounds.hpp).
  NodeId introduced(NodeId node, std::uint32_t bound, std::uint32_t number);

  /// Says which question is asked. The marks of others are other facts, and say nothing about this one.
  void begin_question(std::uint32_t question) { question_ = question; }
  /// Says outside of which concepts the node with the mark of the question is.
  void set_outside(std::vector<std::uint32_t> concepts);
  /// The fact of the mark if the concept is one that the node with the mark is outside of, and the first fact of such a
  /// concept if this is the mark; none where there is no such fact.
  [[nodiscard]] FactId find_opposite(const Fact& fact) const;
  /// The fact of the mark if the concept is told to be below one that the node with the mark is outside of, or is one;
  /// none where there is no such fact.
  [[nodiscard]] FactId find_mark_against(std::uint32_t id, NodeId node) const;

  // Values.
  /// Whether facts of values came since the last call.
  [[nodiscard]] bool take_values_changed() { return std::exchange(have_values_changed_, false); }
  /// The first literal that was asked about with the same value.
  [[nodiscard]] owl::TermId representative(owl::TermId literal) { return values_.representative(literal); }
  /// The literal of a range of its one value; nothing of other ranges.
  [[nodiscard]] std::optional<owl::TermId> literal_of(std::uint32_t range) const { return values_.literal_of(range); }
  /// The value of a literal; nothing where it is not known.
  [[nodiscard]] const std::optional<Value>& value(owl::TermId literal) { return values_.value(literal); }
  /// The literal of a value that a rule has made; nothing if there are too many.
  [[nodiscard]] std::optional<owl::TermId> made_value(const Value& value) { return values_.made(value); }
  [[nodiscard]] std::optional<bool> is_in(owl::TermId literal, std::uint32_t range) {
    return values_.is_in(literal, range);
  }
  /// The only value that the ranges of a node allow, and why. `is_free`: they allow infinitely many.
  [[nodiscard]] std::optional<owl::TermId> only_value(NodeId node, DependencySet& dependency, bool& is_free) {
    return values_.only_value(graph_, node, dependency, is_free);
  }
  /// Whether no fact about a value says anything of another node than its subject and the values of that one.
  [[nodiscard]] bool has_values_apart() { return graph_.values().empty() || values_.knows_all_ranges(); }
  /// Says that nothing about the values before this node changes any more, but for constants, which have new subjects.
  void settle_values(NodeId first) {
    values_.settle(graph_, first);
    settled_values_ = first == 0 ? 0 : graph_.values().size();
  }
  /// Clashes if the values cannot all exist. Returns why this is unknown, or nothing.
  std::string check_values();

  /// The number of introduced individuals; to be restored together with the graph.
  [[nodiscard]] std::size_t sizes() const { return introduced_.size(); }
  void restore(std::size_t introduced);
  /// Forgets the individuals, too.
  void clear();

 private:
  struct Merge {
    NodeId a = 0;
    NodeId b = 0;
    DependencySet dependency = no_dependency;
  };
  struct Introduced {
    NodeId node = 0;
    std::uint32_t bound = 0;
    std::uint32_t number = 0;
    NodeId root = 0;
  };

  DependencySet unite(DependencySet first, DependencySet second) { return graph_.unite(first, second); }
  [[nodiscard]] std::optional<bool> is_constant_in(NodeId node, std::uint32_t range);
  [[nodiscard]] FactId find_mark(NodeId node) const;
  void merge(const Merge& merge);
  [[nodiscard]] bool is_kept(NodeId node, NodeId other) const;
  void copy_facts(NodeId from, NodeId to, DependencySet dependency);
  void keep_from_siblings(NodeId from, NodeId to, DependencySet dependency);

  const Program& program_;
  Graph& graph_;
  Effort& effort_;
  ValueCheck values_;
  const bool has_individuals_;                ///< of the ontology; they are in the graph where individuals_ has them
  std::vector<std::uint32_t> outside_;        ///< ascending
  std::vector<std::uint32_t> below_outside_;  ///< by what is told, itself included
  std::vector<bool> is_below_outside_;        ///< by concept
  std::uint32_t question_ = 0;                ///< the second argument of its mark
  bool has_clash_ = false;
  DependencySet clash_ = no_dependency;
  bool have_values_changed_ = false;
  std::size_t settled_values_ = 0;
  std::vector<Merge> merges_;
  std::vector<Introduced> introduced_;
  std::vector<NodeId> individuals_;
  /// By literal. An entry is valid if the node still exists.
  std::unordered_map<owl::TermId, NodeId> constants_;
};

}  // namespace geminga::hypertableau

#endif
