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

#include "reasoning/dl/hypertableau/assertions.hpp"
#include "reasoning/dl/hypertableau/blocking.hpp"
#include "reasoning/dl/hypertableau/bounds.hpp"
#include "reasoning/dl/hypertableau/choice.hpp"
#include "reasoning/dl/hypertableau/choice_records.hpp"
#include "reasoning/dl/hypertableau/dependency.hpp"
#include "reasoning/dl/hypertableau/derivation.hpp"
#include "reasoning/dl/hypertableau/disjunctions.hpp"
#include "reasoning/dl/hypertableau/effort.hpp"
#include "reasoning/dl/hypertableau/expansion.hpp"
#include "reasoning/dl/hypertableau/graph.hpp"
#include "reasoning/dl/hypertableau/keys.hpp"
#include "reasoning/dl/hypertableau/neighbours.hpp"
#include "reasoning/dl/hypertableau/numbers.hpp"
#include "reasoning/dl/hypertableau/program/program.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"

namespace geminga::hypertableau {

enum class Outcome : std::uint8_t { model, no_model, unknown };

/// Runs the rules in their order over one graph, branches where nothing is certain, and goes back.
///
/// Each rule is a class. It owns its state and knows only the classes that are declared before it here.
class Search {
 public:
  Search(const owl::Ontology& source, const clauses::ClauseSet& set, const QuestionLimits& limits);
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  /// Forgets everything, the base too.
  void reset();
  /// Requires reset(). Looks for a model of the facts of the set.
  Outcome find_world();
  /// Looks for a model in which one thing is in all of these concepts, together with the base.
  Outcome find_instance(std::vector<clauses::ConceptId> together);
  /// The labels of the model that the last question found. To be called before end_question().
  [[nodiscard]] Model model();
  /// The steps of all questions.
  [[nodiscard]] std::size_t steps() const { return effort_.all_steps(); }
  /// Why the last outcome is unknown, in a line for a user.
  [[nodiscard]] const std::string& reason() const { return effort_.reason(); }

  /// Makes the model that is in the graph the base of later questions.
  ///
  /// Their nodes are added to it, and its nodes block theirs. Without nominals no fact leads from one model to another,
  /// so that a kept model does not change.
  void keep();
  [[nodiscard]] bool has_base() const { return base_.has_value(); }
  [[nodiscard]] std::size_t base_node_count() const { return base_ ? base_->mark.nodes : 0; }
  /// To be called after find_instance(): keeps the model, or takes the question back. Models with values are not kept,
  /// as models would share values.
  void end_question(Outcome outcome);

  [[nodiscard]] bool has_nominals() const { return program_.has_nominals(); }

 private:
  /// Sizes of all stacks.
  struct Sizes {
    Mark mark;
    std::size_t assertions = 0;
    FactId processed = 0;
    Disjunctions::Sizes disjunctions;
    Bounds::Sizes bounds;
    Expansion::Sizes expansion;
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
  void ask_again();
  bool saturate();
  bool choose();
  bool choose_for_bound();
  bool expand();
  void branch(Decision decision);
  bool go_back();
  void begin_again();
  void note(const Suspect& suspect);
  void forget_base();
  [[nodiscard]] Sizes sizes() const;
  void restore(const Sizes& sizes);
  [[nodiscard]] DependencySet unite(DependencySet first, DependencySet second) { return sets_.unite(first, second); }

  const clauses::ClauseSet& set_;
  Program program_;
  Graph graph_;
  DependencySets sets_;
  Effort effort_;
  Assertions facts_;
  Neighbours neighbours_;
  Numbers numbers_;
  ChoiceRecords records_;
  Disjunctions disjunctions_;
  Bounds bounds_;
  Blocking blocking_;
  Expansion expansion_;
  Derivation derivation_;
  Keys keys_;

  std::vector<Branch> branches_;
  std::size_t wrong_guesses_ = 0;  ///< since the search began, or began again
  std::size_t patience_ = 0;       ///< wrong guesses beyond those that stand, after which the search begins again

  std::vector<clauses::ConceptId> question_;
  bool has_question_ = false;
  std::size_t question_mark_ = 0;  ///< facts that are older than it
  NodeId question_node_ = none;
  /// With nominals the model of the facts; otherwise the models of the questions whose answer was yes.
  std::optional<Sizes> base_;
  std::size_t base_branches_ = 0;
};

}  // namespace geminga::hypertableau

#endif
