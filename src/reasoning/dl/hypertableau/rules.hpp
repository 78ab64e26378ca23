// Rules of named individuals.
//
//   body(a, b, ..., v, ...) -> head(a, b, ..., v, ...) for named individuals a, b, ... and known values v, ...
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_RULES_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_RULES_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/dl/hypertableau/disjunctions.hpp"
#include "reasoning/dl/hypertableau/facts/assertions.hpp"
#include "reasoning/dl/hypertableau/facts/effort.hpp"
#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/rules/built_ins.hpp"
#include "reasoning/dl/hypertableau/rules/rule_plans.hpp"

namespace geminga::hypertableau {

/// Matches rules with the facts of named individuals, each new fact with the older ones.
class Rules {
 public:
  Rules(const owl::Ontology& source, const clauses::ClauseSet& set, const Graph& graph, Effort& effort,
        Assertions& facts, Disjunctions& disjunctions)
      : source_(source),
        set_(set),
        graph_(graph),

        effort_(effort),
        facts_(facts),
        disjunctions_(disjunctions),
        plans_(set) {}

  /// Whether facts wait to be matched.
  [[nodiscard]] bool has_next();
  /// Matches the facts that wait, up to a clash or a limit.
  void derive();
  /// Why the model, in which nothing is left to derive, may break a rule: something in it is not known. Empty: it keeps
  /// all of them.
  [[nodiscard]] std::string find_open();

  /// Takes atoms that are not known for atoms that hold, so that a model keeps each rule whatever they say. What
  /// follows then need not follow from the ontology: only a model says something. To be called before anything is
  /// matched.
  void take_unknown_for_true(bool does) { takes_unknown_for_true_ = does; }

  /// The facts that were matched.
  [[nodiscard]] FactId sizes() const { return processed_; }
  void restore(FactId processed) {
    processed_ = processed;
    is_stale_ = true;
  }

 private:
  enum class BoundKind : std::uint8_t {
    nothing,
    node,
    literal,
    some,  ///< the value of a node, which is not known
  };
  struct Bound {
    BoundKind kind = BoundKind::nothing;
    std::uint32_t number = 0;  ///< of the node or literal
    friend bool operator==(const Bound&, const Bound&) = default;
  };
  /// A match that is being made.
  struct Match {
    const clauses::Rule* rule = nullptr;
    FactId limit = none;  ///< newer facts wait for their own turn
    std::span<const RuleStep> steps;
    DependencySet dependency = no_dependency;
    bool is_sure = true;  ///< all atoms hold, as far as they were looked at
  };

  void refresh();
  void match_whole(std::uint32_t rule);
  /// The same of a rule whose body has no unknown atom, or in which that is taken for true.
  void match_if_known(std::uint32_t rule);
  void process(FactId id);
  void start(const RulePlan& plan, const Fact& fact, FactId id);
  void match(Match match);
  void look_at(const clauses::RuleAtom& atom, Match match);
  void look_at_role(const clauses::RuleAtom& atom, Match match);
  void look_at_data_role(const clauses::RuleAtom& atom, Match match);
  void look_at_path(const clauses::RuleAtom& atom, Match match);
  void look_at_built_in(const clauses::RuleAtom& atom, Match match);
  /// Goes on if it holds, or if it is unknown and is taken for true, or open matches are looked for.
  void go_on(Holds holds, Match match);
  [[nodiscard]] bool is_over() { return facts_.must_stop(); }

  /// Binds a term for the rest of the match, and goes on with the next steps. A node must be named.
  void go_on_with(const clauses::RuleTerm& term, Bound bound, Match match);
  [[nodiscard]] Bound bound(const clauses::RuleTerm& term, DependencySet& dependency);
  /// The value of a node of values.
  [[nodiscard]] std::optional<Bound> value_of(NodeId node, DependencySet& dependency);
  [[nodiscard]] Holds is_in_range(const clauses::RuleAtom& atom, DependencySet& dependency);
  Holds evaluate_built_in(const clauses::RuleAtom& atom, std::optional<clauses::RuleTerm>& unbound, Bound& result,
                          DependencySet& dependency);

  void conclude(const Match& match);
  /// Whether the heads of a match can be facts: nothing in them is unknown.
  [[nodiscard]] bool can_conclude(const Match& match);
  void note_open(const Match& match);
  /// The choice that a head is; nothing where it holds, and `is_false` where it cannot.
  std::optional<Choice> choice_of(const clauses::RuleAtom& head, DependencySet& dependency, bool& is_false);
  [[nodiscard]] bool is_satisfied(const clauses::RuleAtom& head);

  const owl::Ontology& source_;
  const clauses::ClauseSet& set_;
  const Graph& graph_;
  Effort& effort_;
  Assertions& facts_;
  Disjunctions& disjunctions_;
  RulePlans plans_;

  FactId processed_ = 0;
  FactId seen_by_paths_ = none;          ///< the number of facts when rules about paths were last matched
  bool is_stale_ = true;                 ///< going back may have changed who is named
  std::size_t merges_ = 0;               ///< the trail of the graph when it was last found out who is named
  std::vector<NodeId> nodes_;            ///< by individual: the node that stands for it
  std::vector<NodeId> named_;            ///< nodes of named individuals, ascending
  std::vector<bool> is_named_;           ///< by node
  std::vector<DependencySet> named_by_;  ///< by node: why
  std::vector<Bound> bounds_;            ///< by variable of the rule that is being matched
  bool takes_unknown_for_true_ = false;
  bool is_open_ = false;      ///< matches with unknown atoms are looked for
  bool has_unknown_ = false;  ///< some atom could not be decided
  std::string open_;
};

}  // namespace geminga::hypertableau

#endif
