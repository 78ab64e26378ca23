// The order of the search, branching and going back.
#include "reasoning/dl/hypertableau/search.hpp"

#include <bit>
#include <utility>
#include <variant>

#include "reasoning/dl/hypertableau/facts/told_facts.hpp"
#include "reasoning/dl/hypertableau/written_model.hpp"

namespace geminga::hypertableau {

using clauses::number;

namespace {

/// The number of wrong choices after which the search begins again with the records that it has.
constexpr std::size_t first_patience = 64;

/// With more nodes of questions than this, no more models are kept.
constexpr std::size_t most_kept_nodes = 20'000;

}  // namespace

Search::Search(const owl::Ontology& source, const clauses::ClauseSet& set, const QuestionLimits& limits,
               bool is_about_facts)
    : set_(set),
      is_about_facts_(is_about_facts),
      program_(set, limits.counts),
      graph_(program_.backward_looks().directions()),
      effort_(limits, graph_),
      facts_(source, set, program_, graph_, effort_),
      neighbours_(program_, graph_, effort_, facts_),
      numbers_(program_, graph_, effort_),
      choice_check_(program_, graph_, facts_, neighbours_, numbers_),
      disjunctions_(program_, graph_, effort_, facts_, choice_check_, records_),
      bounds_(program_, graph_, effort_, facts_, neighbours_, numbers_, disjunctions_),
      blocking_(program_, graph_, effort_),
      witnesses_(set, program_, graph_, effort_, facts_, neighbours_),
      denial_witnesses_(program_, graph_, effort_, neighbours_, blocking_),
      sharing_(program_, graph_, facts_, neighbours_, numbers_, records_),
      new_neighbours_(program_, graph_, effort_, facts_, neighbours_, sharing_),
      expansion_(program_, graph_, facts_, blocking_, witnesses_, denial_witnesses_, new_neighbours_),
      matches_(program_, graph_, effort_, facts_, disjunctions_),
      derivation_(program_, graph_, facts_, matches_, bounds_, expansion_),
      keys_(source, set, graph_, facts_),
      rules_(source, set, graph_, effort_, facts_, disjunctions_),
      suppositions_(is_about_facts            ? 1
                    : program_.has_nominals() ? Suppositions::most
                                              : 0) {}

void Search::begin(bool is_about_world) {
  is_open_for_rules_ = false;
  effort_.begin(is_about_world);
  records_.begin_question();
  wrong_guesses_ = all_wrong_guesses_ = 0;
  patience_ = first_patience;
}

Outcome Search::find_world() {
  begin(true);
  assert_told_facts(set_, program_, facts_);
  branches_.assign(suppositions_.count(), Branch{sizes(), {}});
  base_branches_ = suppositions_.count();
  const Outcome outcome = run();
  world_nodes_ = program_.has_nominals() ? graph_.node_count() : 0;
  if (is_about_facts_ && !before_choices_) before_choices_ = sizes();
  return outcome;
}

Outcome Search::find_world_again() {
  branches_.resize(1);
  restore(*before_choices_);
  forget_base();
  has_question_ = false;
  facts_.forget_clash();
  begin(true);
  return run();
}

Outcome Search::find_supposing(Supposition supposed) {
  supposed_ = std::move(supposed);
  has_question_ = true;
  begin(true);
  ask();
  return run();
}

Outcome Search::find_instance(std::vector<clauses::ConceptId> together,
                              const std::vector<clauses::ConceptId>& outside) {
  question_ = std::move(together);
  std::vector<std::uint32_t> numbers;
  for (const clauses::ConceptId id : outside) numbers.push_back(number(id));
  facts_.set_outside(std::move(numbers));
  is_outside_ = !outside.empty();
  has_question_ = true;
  begin(false);
  ask();
  return run();
}

void Search::suppose() {
  const DependencySet dependency = supposed();
  const auto node_of = [&](clauses::IndividualId individual, DependencySet& merged_by) {
    return graph_.current(facts_.individuals()[number(individual)], merged_by);
  };
  for (const clauses::ConceptFact& fact : supposed_.facts) {
    DependencySet reasons = dependency;
    const NodeId node = node_of(fact.individual, reasons);
    facts_.add_fact(FactKind::concept_of, number(fact.of), node, 0, reasons);
  }
  for (const auto& [first, second] : supposed_.different) {
    DependencySet reasons = dependency;
    const NodeId one = node_of(first, reasons);
    const NodeId other = node_of(second, reasons);
    facts_.add_unequal(one, other, reasons);
  }
}

void Search::ask() {
  question_mark_ = graph_.mark().facts;
  if (is_about_facts_) {
    suppose();
    return;
  }
  facts_.begin_question(suppositions_.current());
  const DependencySet dependency = supposed();
  question_node_ = facts_.add_node(NodeKind::root, none, dependency);
  if (!program_.needs_thing() && question_.empty()) {
    // So that cutting it off is seen.
    facts_.add_fact(FactKind::concept_of, number(clauses::thing), question_node_, 0, dependency);
  }
  if (is_outside_)
    facts_.add_fact(FactKind::concept_of, program_.mark_of_question(), question_node_, suppositions_.current(),
                    dependency);
  for (const clauses::ConceptId id : question_) {
    facts_.add_fact(FactKind::concept_of, number(id), question_node_, 0, dependency);
  }
}

/// Asks the question again if going back has removed it from the graph.
void Search::ask_again() {
  if (has_question_ && graph_.mark().facts <= question_mark_) ask();
}

std::optional<owl::TermId> Search::known_value(NodeId node, bool is_certain) {
  if (const std::uint32_t literal = graph_.node(node).literal; literal != none) return owl::TermId{literal};
  DependencySet dependency = no_dependency;
  bool is_free = false;
  const auto only = facts_.only_value(node, dependency, is_free);
  return is_certain && dependency != no_dependency ? std::nullopt : only;
}

Model Search::model() {
  return write_model(graph_, set_.concepts.size(), has_question_ ? question_node_ : none, supposed(),
                     base_ ? base_->mark : Mark{});
}

void Search::keep() {
  base_ = sizes();
  base_branches_ = branches_.size();
  effort_.set_base(base_->mark);
  facts_.settle_values(keeps_world() ? 0 : static_cast<NodeId>(base_->mark.nodes));
}

void Search::end_question(Outcome outcome) {
  has_question_ = false;
  facts_.forget_clash();
  if (outcome == Outcome::model && may_keep()) {
    if (program_.has_nominals()) suppositions_.keep();
    keep();
  } else if (base_) {
    branches_.resize(base_branches_);
    restore(*base_);
  }
}

bool Search::may_keep() {
  if (!program_.has_nominals()) return facts_.has_values_apart();
  if (!base_) return suppositions_.may_keep();
  return !is_base_full() && suppositions_.may_keep_beside(effort_.steps(), graph_.mark().facts - base_->mark.facts);
}

bool Search::is_base_full() const { return base_ && base_->mark.nodes > world_nodes_ + most_kept_nodes; }

void Search::end_supposing(Outcome outcome) {
  has_question_ = false;
  facts_.forget_clash();
  if (base_) {
    branches_.resize(base_branches_);
    restore(*base_);
  } else if (outcome == Outcome::model) {
    keep();
  }
}

Outcome Search::run() {
  while (true) {
    if (facts_.has_clash()) {
      if (!go_back()) return Outcome::no_model;
      continue;
    }
    if (effort_.is_over_limit()) return Outcome::unknown;
    if (!saturate() || expansion_.expand_certain() || choose() || expand()) continue;
    keys_.check();
    if (facts_.has_clash() || facts_.has_merges()) continue;
    // If the values cannot be decided, this is no model.
    std::string unknown_value = facts_.check_values();
    if (facts_.has_clash()) continue;
    if (effort_.reason().empty()) effort_.set_reason(std::move(unknown_value));
    if (effort_.reason().empty()) {
      effort_.set_reason(rules_.find_open());
      is_open_for_rules_ = !effort_.reason().empty();
    }
    return effort_.reason().empty() ? Outcome::model : Outcome::unknown;
  }
}

/// Derives all that follows without a choice. False: there is a clash.
bool Search::saturate() {
  while (!facts_.has_clash()) {
    if (facts_.has_merges()) {
      facts_.merge_all();
    } else if (derivation_.has_next()) {
      derivation_.process_next();
      if (effort_.is_over_limit()) return true;
    } else if (bounds_.has_suspects()) {
      bounds_.check_last();
      if (effort_.is_over_limit()) return true;
    } else if (rules_.has_next()) {
      rules_.derive();
      if (effort_.is_over_limit()) return true;
    } else if (facts_.take_values_changed()) {
      facts_.check_values();
    } else {
      return true;
    }
  }
  return false;
}

/// Makes a choice. False: nothing is left to choose.
bool Search::choose() {
  auto next = disjunctions_.find_next();
  if (std::holds_alternative<Disjunctions::AllDecided>(next)) return choose_for_bound();
  if (auto* const decision = std::get_if<Decision>(&next)) branch(std::move(*decision));
  return true;
}

bool Search::choose_for_bound() {
  while (const std::optional<Bounds::Demand> demand = bounds_.next_demand()) {
    if (std::optional<Decision> decision = bounds_.enforce(*demand)) branch(std::move(*decision));
    if (facts_.has_clash() || facts_.has_merges() || derivation_.has_next() || !effort_.reason().empty()) return true;
  }
  return false;
}

bool Search::expand() {
  // Without nominals no fact reaches into the models of earlier questions. Their open at-leasts are blocked.
  const std::size_t first = base_ && !keeps_world() ? base_->mark.nodes : 0;
  if (expansion_.expand(static_cast<NodeId>(first), order_of_nodes())) return true;
  std::optional<Decision> offer = expansion_.take_offer();
  if (!offer) return false;
  branch(std::move(*offer));
  return true;
}

void Search::apply(const Choice& choice, DependencySet dependency) {
  if (is_of_expansion(choice.kind)) {
    expansion_.apply(choice, dependency);
  } else {
    facts_.apply(choice, dependency);
  }
}

/// With guesses few nodes are expanded at a time, so that the consequences of each are derived before the next. The
/// oldest first gives small models. The newest first shows a wrong guess before much is built that is lost with it. No
/// order is the better one everywhere, so they take turns, each twice as many wrong guesses as the one before.
Expansion::Order Search::order_of_nodes() const {
  constexpr std::size_t first_turn = 16;
  if (branches_.size() <= base_branches_) return Expansion::Order::everything;
  const bool is_even_turn = std::bit_width(1 + all_wrong_guesses_ / first_turn) % 2 == 0;
  return is_even_turn ? Expansion::Order::newest_first : Expansion::Order::oldest_first;
}

void Search::note(const Suspect& suspect) {
  if (suspect.node != none) bounds_.note(suspect);
}

void Search::branch(Decision decision) {
  const auto number = static_cast<std::uint32_t>(branches_.size());
  if (is_about_facts_ && !before_choices_) before_choices_ = sizes();
  for (Choice& choice : decision.alternatives) {
    choice.meets_neighbour = neighbours_.meets(choice);
    choice.crowds = neighbours_.crowds(choice);
  }
  // The second way in which an at-least is satisfied cannot fail alone.
  if (!is_of_expansion(decision.alternatives.front().kind))
    records_.order_by_promise(decision.alternatives, program_.burdens());
  const Choice first = decision.alternatives.front();
  const DependencySet dependency = decision.dependency;
  const Suspect suspect = decision.suspect;
  records_.note_try(first);
  branches_.push_back({sizes(), std::move(decision)});
  apply(first, unite(dependency, graph_.depending_on(number)));
  note(suspect);
}

/// Takes the next alternative of the branch that is to blame. False: there is none, and no model.
bool Search::go_back() {
  const DependencySet clash = facts_.clash_dependency();
  is_refuted_alone_ = clash == no_dependency || clash == supposed();
  if (is_refuted_alone_) return false;
  const std::uint32_t number = graph_.dependencies().last(clash);
  if (suppositions_.is_one(number)) return false;
  branches_.resize(number + 1);
  Branch& branch = branches_.back();
  const Decision& decision = branch.decision;
  restore(branch.sizes);
  branch.failed = unite(branch.failed, graph_.dependencies().without_last(clash));
  facts_.forget_clash();
  if (number < base_branches_) forget_base();
  records_.note_failure(decision.alternatives[branch.next]);
  ++all_wrong_guesses_;
  // A few wrong guesses among many that hold are no reason to begin again.
  if (++wrong_guesses_ > patience_ + branches_.size() - base_branches_ && number > base_branches_) {
    begin_again();
    return true;
  }
  const Choice choice = decision.alternatives[++branch.next];
  records_.note_try(choice);
  const Suspect suspect = decision.suspect;
  if (branch.next + 1 < decision.alternatives.size()) {
    apply(choice, unite(decision.dependency, graph_.depending_on(number)));
  } else {
    // The last alternative does not depend on this choice. It depends on the reasons why the others failed.
    // That an at-least makes neighbours has no such reasons.
    const DependencySet dependency =
        is_of_expansion(choice.kind) ? decision.dependency : unite(decision.dependency, branch.failed);
    branches_.pop_back();
    apply(choice, dependency);
  }
  note(suspect);
  ask_again();
  return true;
}

/// Takes back all guesses of this question. The first guesses were made without records and are wrong more often than
/// later ones. The patience doubles each time, so that the search ends.
void Search::begin_again() {
  patience_ *= 2;
  wrong_guesses_ = 0;
  const Branch first = std::move(branches_[base_branches_]);
  branches_.resize(base_branches_);
  restore(first.sizes);
  note(first.decision.suspect);
  ask_again();
}

Search::Sizes Search::sizes() const {
  return {graph_.mark(),   facts_.sizes(),     derivation_.sizes(), disjunctions_.sizes(),
          bounds_.sizes(), expansion_.sizes(), rules_.sizes()};
}

void Search::restore(const Sizes& sizes) {
  graph_.cut(sizes.mark);
  facts_.restore(sizes.assertions);
  derivation_.restore(sizes.processed);
  disjunctions_.restore(sizes.disjunctions);
  bounds_.restore(sizes.bounds);
  expansion_.restore(sizes.expansion);
  rules_.restore(sizes.rules);
}

void Search::forget_base() {
  base_.reset();
  base_branches_ = std::min<std::size_t>(suppositions_.count(), branches_.size());
  effort_.set_base({});
  facts_.settle_values(0);
}

void Search::forget_misleading_base() {
  suppositions_.note_misled();
  forget_base();
}

void Search::reset() {
  restore({});
  branches_.clear();
  suppositions_.forget();
  has_question_ = false;
  before_choices_.reset();
  graph_.forget_dependencies();
  forget_base();
  facts_.clear();
}

}  // namespace geminga::hypertableau
