// The search for a model: derive what must hold, choose where there is a choice, go back to the choice that is to
// blame.
//
// Everything that a branch adds lies above its mark on stacks, so that going back cuts and never copies. A fact that
// comes twice keeps its first dependency set. Facts are looked at in the order in which they came; a clause is matched
// when the last of its body atoms is, so each match is found once.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_SEARCH_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_SEARCH_HPP

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "reasoning/dl/hypertableau/blockers.hpp"
#include "reasoning/dl/hypertableau/graph.hpp"
#include "reasoning/dl/hypertableau/program.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"
#include "reasoning/dl/hypertableau/value_check.hpp"

namespace geminga::hypertableau {

/// One thing that may be made true.
enum class ChoiceKind : std::uint8_t {
  concept_of,
  role,
  data_role,
  equal,
  at_least,
  at_most,
  data_range,
  data_at_least,
  introduce,  ///< NI rule: a is the individual number `predicate` of those that bound `bound` allows b
};
struct Choice {
  ChoiceKind kind = ChoiceKind::concept_of;
  std::uint32_t predicate = 0;
  NodeId a = 0;
  NodeId b = 0;
  std::uint32_t bound = 0;
};

class Tableau::Search {
 public:
  Search(const owl::Ontology& source, const clauses::ClauseSet& set, const Limits& limits);

  Answer is_consistent();
  Answer is_satisfiable(std::vector<clauses::ConceptId> together);
  [[nodiscard]] const Model& model() const { return model_; }

 private:
  struct Merge {
    NodeId a = 0;
    NodeId b = 0;
    DependencySet dependency = no_dependency;
  };
  /// A bound that a node may exceed.
  struct Suspect {
    NodeId node = 0;
    std::uint32_t bound = 0;
  };
  /// Alternatives of which one must hold.
  struct Disjunction {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    DependencySet dependency = no_dependency;
    bool is_done = false;  ///< one holds, or what it is about is gone: as long as this branch is
  };
  /// What is left of one now.
  struct Open {
    bool is_done = false;  ///< one holds, or what it is about is gone
    std::vector<Choice> alternatives;
    DependencySet dependency = no_dependency;  ///< of the disjunction and of what excludes the others
    std::uint64_t failures = 0;                ///< of its alternatives, as far as they are known
    [[nodiscard]] bool is_before(const Open& other) const;
  };
  struct Existential {
    FactId fact = 0;
    bool is_done = false;
    /// The neighbour that was found to satisfy it as things stood, and the version of that node.
    NodeId witness = none;
    std::uint64_t version = 0;
  };
  /// Who blocked a node, and the versions of what was compared.
  struct BlockedBy {
    NodeId blocker = none;
    std::array<std::uint64_t, 4> versions{};
    friend bool operator==(const BlockedBy&, const BlockedBy&) = default;
  };
  struct Introduced {
    NodeId node = 0;
    std::uint32_t bound = 0;
    std::uint32_t number = 0;
    NodeId root = 0;
  };
  /// Sizes of all stacks.
  struct State {
    Mark mark;
    FactId processed = 0;
    std::size_t disjunctions = 0;
    std::size_t next_disjunction = 0;
    std::size_t demands = 0;
    std::size_t next_demand = 0;
    std::size_t choices = 0;
    std::size_t existentials = 0;
    std::uint32_t next_functional = 0;
    std::size_t done = 0;
    std::size_t done_disjunctions = 0;
    std::size_t introduced = 0;
  };
  struct Branch {
    State state;
    std::vector<Choice> alternatives;
    std::size_t next = 0;
    DependencySet dependency = no_dependency;  ///< of the disjunction
    DependencySet failed = no_dependency;      ///< of the alternatives that failed, without this branch
    Suspect suspect{none, none};               ///< to be looked at again whatever is chosen
  };
  /// How often a kind of choice was tried in this search, and how often it was to blame for a clash.
  struct Record {
    std::uint64_t tries = 0;
    std::uint64_t failures = 0;
  };
  struct Neighbour {
    NodeId node = 0;
    DependencySet dependency = no_dependency;
  };
  enum class Outcome : std::uint8_t { model, no_model, unknown };

  // search.cpp: the order of things
  Outcome run();
  bool saturate();
  void branch(std::vector<Choice> alternatives, DependencySet dependency, Suspect suspect);
  bool go_back();
  void begin_again();
  [[nodiscard]] State state() const;
  void restore(const State& state);
  void reset();
  bool is_over_limit();
  /// Counts what was looked at in vain: so many looks take the time that a fact takes.
  void count_look() {
    constexpr std::size_t looks_a_step = 16;
    if (++looked_ % looks_a_step == 0) ++steps_;
  }
  void clash(DependencySet dependency);

  // choose.cpp: which disjunction is next, and which of its ways is first
  bool choose();
  void note_done(std::size_t disjunction);
  bool choose_for_bound();
  void open(const Disjunction& disjunction, Open& result);
  [[nodiscard]] std::uint64_t failures_of(std::span<const Choice> alternatives);
  /// Whether what holds excludes the choice; unites the reasons into `dependency`.
  bool is_excluded(const Choice& choice, DependencySet& dependency);
  bool is_excluded(std::uint32_t id, NodeId node, DependencySet& dependency);
  bool is_excluded_by_bound(std::uint32_t id, NodeId node, DependencySet& dependency);
  bool is_excluded_by_neighbour(const Choice& choice, DependencySet& dependency);
  bool derive(const Choice& choice);
  void order_by_promise(std::vector<Choice>& alternatives);
  /// Of choices of one kind about one predicate.
  Record& record_of(const Choice& choice) {
    return records_[(std::uint64_t{choice.predicate} << 8) | static_cast<std::uint64_t>(choice.kind)];
  }

  // questions.cpp
  void load_individuals();
  void load_facts();
  void ask();
  Answer answer(Outcome outcome);
  Outcome find_consistency();
  bool prepare_base();
  void keep_model();
  void write_model();
  void write_label(NodeId node);
  void check_keys();
  bool agree(const clauses::Key& key, NodeId first, NodeId second, DependencySet& dependency);
  DependencySet unite(DependencySet first, DependencySet second) { return sets_.unite(first, second); }

  // derive.cpp: facts and clauses
  void process(FactId id);
  void keep_apart(const Fact& fact);
  void process_concept(const Fact& fact, FactId id);
  void fire(const Plan& plan, FactId id);
  void match(const Plan& plan, std::span<const Step> steps, FactId limit, DependencySet dependency);
  void match_each(const Plan& plan, std::span<const Step> steps, FactId limit, DependencySet dependency);
  void conclude(const Plan& plan, DependencySet dependency);
  void add_disjunction(std::vector<Choice>& alternatives, DependencySet dependency);
  [[nodiscard]] Choice choice_of(const clauses::Atom& atom, NodeId a, NodeId b) const;
  [[nodiscard]] bool holds(const Choice& choice);
  [[nodiscard]] bool is_impossible(const Choice& choice);
  void apply(Choice choice, DependencySet dependency);
  void add_fact(FactKind kind, std::uint32_t predicate, NodeId a, NodeId b, DependencySet dependency);
  void add_unequal(NodeId a, NodeId b, DependencySet dependency);
  NodeId add_node(NodeKind kind, NodeId parent, DependencySet dependency);

  // bounds.cpp: at-most
  void suspect_role(std::uint32_t property, NodeId from, NodeId to, bool is_data);
  void suspect_loop(std::uint32_t property, NodeId node);
  void suspect_filler(std::uint32_t id, NodeId node);
  void suspect(NodeId node, std::uint32_t bound) { suspects_.push_back({node, bound}); }
  void check(const Suspect& suspect);
  bool exceeds(const Bound& bound, std::span<const Neighbour> neighbours, DependencySet& dependency);
  void check_conditional(const Suspect& suspect, DependencySet dependency);
  [[nodiscard]] bool is_bound(const Suspect& suspect, DependencySet& dependency) const;
  std::vector<Neighbour> counted(const Suspect& suspect);
  bool counts(const Bound& bound, NodeId node, DependencySet& dependency);
  bool introduce(const Suspect& suspect, std::span<const Neighbour> neighbours, DependencySet dependency);
  void enforce(const Suspect& suspect, DependencySet dependency);
  NodeId introduced(NodeId node, std::uint32_t bound, std::uint32_t number);

  // merge.cpp
  void merge(const Merge& merge);
  [[nodiscard]] bool is_kept(NodeId node, NodeId other) const;
  void copy_facts(NodeId from, NodeId to, DependencySet dependency);

  // expand.cpp: at-least
  bool expand();
  bool expand_functional();
  bool expand(std::uint32_t at);
  void expand_object(const Fact& fact);
  void expand_data(const Fact& fact);
  [[nodiscard]] bool is_satisfied(const Fact& fact);
  /// Whether a neighbour is in nothing that the filler denies. It is to be asked again when that neighbour has changed.
  bool has_witness(Existential& existential);
  [[nodiscard]] bool is_functional(clauses::Role role, NodeId node) const;
  std::optional<Neighbour> only_neighbour(clauses::Role role, NodeId node);
  bool give_to_neighbour(const Fact& fact);
  void note_existential(const Fact& fact, FactId id);

  // blocking.cpp
  std::size_t find_blocked();
  [[nodiscard]] bool may_block_as_root(const Node& node) const;
  [[nodiscard]] std::uint64_t blocking_key(const Node& node) const;
  [[nodiscard]] bool is_still_blocked(NodeId node) const;
  [[nodiscard]] BlockedBy compared(NodeId node, NodeId blocker) const;
  [[nodiscard]] bool blocks(NodeId blocker, NodeId node) const;
  [[nodiscard]] bool has_same_edges(NodeId node, NodeId other) const;

  // Values.
  void check_values();
  NodeId constant(owl::TermId literal);
  [[nodiscard]] std::optional<bool> is_constant_in(NodeId node, std::uint32_t range);

  const owl::Ontology& source_;
  const clauses::ClauseSet& set_;
  Limits limits_;
  base::BudgetUse budget_;
  Program program_;
  ValueCheck values_;
  DependencySets sets_;
  Graph graph_;
  Blockers blockers_;
  std::vector<BlockedBy> blocked_by_;  ///< by node, as of the last look

  FactId processed_ = 0;
  bool has_clash_ = false;
  DependencySet clash_ = no_dependency;
  bool values_changed_ = false;
  std::vector<Merge> merges_;
  std::vector<Suspect> suspects_;
  std::vector<Choice> choices_;
  std::vector<Disjunction> disjunctions_;
  std::size_t next_disjunction_ = 0;
  std::vector<std::uint32_t> done_disjunctions_;
  bool has_failed_ = false;        ///< some choice of this question did
  std::size_t wrong_guesses_ = 0;  ///< since the search began, or began again
  std::size_t patience_ = 0;       ///< so many more of them than guesses that stand, and it begins again
  Open open_;                      ///< room of choose()
  Open best_open_;
  /// Bounds that can be enforced by a choice only.
  std::vector<Suspect> demands_;
  std::size_t next_demand_ = 0;
  std::unordered_map<std::uint64_t, Record> records_;  ///< see record_of()
  std::vector<Existential> existentials_;
  std::uint32_t next_functional_ = 0;
  std::vector<std::uint32_t> done_;
  std::vector<Introduced> introduced_;
  std::vector<Branch> branches_;
  std::vector<NodeId> variables_;  ///< of the clause that is matched
  std::vector<NodeId> individuals_;
  /// Of literals; an entry counts where the node is still there.
  std::unordered_map<owl::TermId, NodeId> constants_;
  std::vector<bool> is_named_;  ///< by node, for keys
  std::size_t steps_ = 0;
  std::size_t looked_ = 0;  ///< what is less than a step
  std::size_t told_ = 0;    ///< steps that the budget knows of
  std::string reason_;
  std::string unknown_value_;

  std::vector<clauses::ConceptId> question_;
  bool has_question_ = false;
  std::size_t question_mark_ = 0;
  NodeId question_node_ = none;
  std::optional<Outcome> consistency_;
  std::string consistency_reason_;
  Model consistent_model_;
  /// Onto which questions are put: where there are nominals a model of the facts, otherwise the models of the questions
  /// that were answered with yes.
  std::optional<State> base_;
  std::size_t base_branches_ = 0;
  Model model_;
};

}  // namespace geminga::hypertableau

#endif
