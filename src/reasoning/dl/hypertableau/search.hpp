// The search for a model: it derives what must hold, branches where there is a choice, and goes back to the choice that
// a clash depends on.
//
// Everything that a branch adds lies above its mark on stacks, so that going back cuts and never copies.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_SEARCH_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_SEARCH_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/dl/hypertableau/blocking.hpp"
#include "reasoning/dl/hypertableau/bounds.hpp"
#include "reasoning/dl/hypertableau/choice_records.hpp"
#include "reasoning/dl/hypertableau/clause_matches.hpp"
#include "reasoning/dl/hypertableau/denial_witnesses.hpp"
#include "reasoning/dl/hypertableau/derivation.hpp"
#include "reasoning/dl/hypertableau/disjunctions.hpp"
#include "reasoning/dl/hypertableau/expansion.hpp"
#include "reasoning/dl/hypertableau/facts/assertions.hpp"
#include "reasoning/dl/hypertableau/facts/choice.hpp"
#include "reasoning/dl/hypertableau/facts/choice_check.hpp"
#include "reasoning/dl/hypertableau/facts/effort.hpp"
#include "reasoning/dl/hypertableau/facts/neighbours.hpp"
#include "reasoning/dl/hypertableau/facts/numbers.hpp"
#include "reasoning/dl/hypertableau/graph/dependency.hpp"
#include "reasoning/dl/hypertableau/graph/graph.hpp"
#include "reasoning/dl/hypertableau/individuals.hpp"
#include "reasoning/dl/hypertableau/keys.hpp"
#include "reasoning/dl/hypertableau/new_neighbours.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"
#include "reasoning/dl/hypertableau/rules.hpp"
#include "reasoning/dl/hypertableau/sharing.hpp"
#include "reasoning/dl/hypertableau/suppositions.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"
#include "reasoning/dl/hypertableau/witnesses.hpp"

namespace geminga::hypertableau {

enum class Outcome : std::uint8_t { model, no_model, unknown };

/// Runs the rules in their order over one graph, branches where nothing is certain, and goes back.
///
/// Each rule is a class. It owns its state and knows only the classes that are declared before it here.
class Search {
 public:
  /// With `is_about_facts` the base is the model of the facts in every ontology, and find_supposing() may be asked.
  Search(const owl::Ontology& source, const clauses::ClauseSet& set, const QuestionLimits& limits,
         bool is_about_facts = false);
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  /// Forgets everything but the records of choices, the base too.
  void reset();
  /// Forgets which choices failed.
  void forget_records() { records_.clear(); }
  /// Requires reset(). Looks for a model of the facts of the set.
  Outcome find_world();
  /// Looks for a model in which one thing is in all of `together` and in none of `outside`, together with the base.
  Outcome find_instance(std::vector<clauses::ConceptId> together, const std::vector<clauses::ConceptId>& outside);
  /// The same after find_world() found a model: takes back all choices and what was supposed, and makes others.
  Outcome find_world_again();
  /// Looks for a model of the facts in which these hold, too. Requires find_world() since reset(). Facts that depend on
  /// what is supposed are not certain. The search may leave the base, and then has none.
  Outcome find_supposing(Supposition supposed);
  /// Reads the model in the graph for the individuals.
  [[nodiscard]] Individuals individuals() const { return {set_, graph_, facts_.individuals()}; }
  /// The literal of a value node, or the only one that its ranges allow; with `is_certain` in every model.
  [[nodiscard]] std::optional<owl::TermId> known_value(NodeId node, bool is_certain);
  /// The value of a literal, of the source or made; nothing where it is not known.
  [[nodiscard]] const std::optional<Value>& value_of(owl::TermId literal) { return facts_.value(literal); }
  /// The labels of the model that the last question found. To be called before end_question().
  [[nodiscard]] Model model();
  /// Gives each later question so many steps.
  void limit_steps(std::size_t steps) { effort_.limit_steps(steps); }
  /// The steps of all questions.
  [[nodiscard]] std::size_t steps() const { return effort_.all_steps(); }
  /// Whether the last outcome is unknown because of a rule alone.
  [[nodiscard]] bool is_open_for_rules() const { return is_open_for_rules_; }
  /// Looks for models that keep each rule whatever its unknown parts say (Rules::take_unknown_for_true). An outcome
  /// other than a model says nothing then. Resets the search.
  void take_unknown_for_true(bool does) {
    reset();
    rules_.take_unknown_for_true(does);
  }
  /// Why the last outcome is unknown, in a line for a user.
  [[nodiscard]] const std::string& reason() const { return effort_.reason(); }

  /// Makes the model that is in the graph the base of later questions.
  ///
  /// Their nodes are added to it, and its nodes block theirs. Without nominals no fact leads from one model to another,
  /// so that a kept model does not change.
  void keep();
  [[nodiscard]] bool has_base() const { return base_.has_value(); }
  /// Whether the models of questions have brought so many nodes that no more should be kept.
  [[nodiscard]] bool is_base_full() const;
  /// Takes the base away because a former question that is in it hid an answer. Where this happens often, fewer models
  /// are kept.
  void forget_misleading_base();
  /// To be called after find_instance(): keeps the model, or takes the question back. Models that share more of values
  /// than literals are not kept (lemma 7 of README.md). With nominals a certain number of models is (lemma 8).
  void end_question(Outcome outcome);

  /// The same after find_supposing(). A model that was found outside of the base becomes the base. Whatever is still
  /// supposed in it depends on a choice.
  void end_supposing(Outcome outcome);

  [[nodiscard]] bool has_nominals() const { return program_.has_nominals(); }
  /// Whether the last outcome, which was no_model, depends on nothing that former questions left in the base.
  [[nodiscard]] bool is_refuted_alone() const { return is_refuted_alone_; }
  /// Whether the base depends on former questions.
  [[nodiscard]] bool has_tainted_base() const { return suppositions_.current() > 0; }

 private:
  /// Sizes of all stacks.
  struct Sizes {
    Mark mark;
    std::size_t assertions = 0;
    FactId processed = 0;
    Disjunctions::Sizes disjunctions;
    Bounds::Sizes bounds;
    Expansion::Sizes expansion;
    FactId rules = 0;  ///< facts that were matched
  };
  struct Branch {
    Sizes sizes;
    Decision decision;
    std::size_t next = 0;                  ///< the alternative that is tried
    DependencySet failed = no_dependency;  ///< of the alternatives that failed, without this branch
  };

  Outcome run();
  void begin(bool is_about_world);
  void ask();
  void suppose();
  void ask_again();
  bool saturate();
  bool choose();
  bool choose_for_bound();
  bool expand();
  [[nodiscard]] Expansion::Order order_of_nodes() const;
  void branch(Decision decision);
  void apply(const Choice& choice, DependencySet dependency);
  bool go_back();
  void begin_again();
  void note(const Suspect& suspect);
  [[nodiscard]] bool may_keep();
  void forget_base();
  /// Whether the base is the model of the facts.
  [[nodiscard]] bool keeps_world() const { return is_about_facts_ || program_.has_nominals(); }
  [[nodiscard]] DependencySet supposed() const {
    return suppositions_.count() == 0 ? no_dependency : graph_.depending_on(suppositions_.current());
  }
  [[nodiscard]] Sizes sizes() const;
  void restore(const Sizes& sizes);
  [[nodiscard]] DependencySet unite(DependencySet first, DependencySet second) { return graph_.unite(first, second); }

  const clauses::ClauseSet& set_;
  const bool is_about_facts_;
  Program program_;
  Graph graph_;
  Effort effort_;
  Assertions facts_;
  Neighbours neighbours_;
  Numbers numbers_;
  ChoiceRecords records_;
  ChoiceCheck choice_check_;
  Disjunctions disjunctions_;
  Bounds bounds_;
  Blocking blocking_;
  Witnesses witnesses_;
  DenialWitnesses denial_witnesses_;
  Sharing sharing_;
  NewNeighbours new_neighbours_;
  Expansion expansion_;
  ClauseMatches matches_;
  Derivation derivation_;
  Keys keys_;
  Rules rules_;
  bool is_open_for_rules_ = false;

  std::vector<Branch> branches_;
  std::size_t wrong_guesses_ = 0;      ///< since the search began, or began again
  std::size_t all_wrong_guesses_ = 0;  ///< of the question
  std::size_t patience_ = 0;           ///< wrong guesses beyond those that stand, after which the search begins again

  std::vector<clauses::ConceptId> question_;
  bool is_outside_ = false;  ///< it is also outside of concepts, which Assertions know
  Supposition supposed_;
  bool has_question_ = false;
  std::size_t question_mark_ = 0;  ///< facts that are older than it
  /// All that is supposed, or asked beside the model of the facts, depends on one of these. A clash that depends on
  /// nothing else refutes what is supposed.
  Suppositions suppositions_;
  bool is_refuted_alone_ = false;
  std::size_t world_nodes_ = 0;  ///< of the model of the facts, with nominals
  NodeId question_node_ = none;
  /// The models of the questions that were kept; with nominals beside, or instead of, the model of the facts.
  std::optional<Sizes> base_;
  std::size_t base_branches_ = 0;
  std::optional<Sizes> before_choices_;  ///< of a search about facts: all that is derived without a choice
};

}  // namespace geminga::hypertableau

#endif
