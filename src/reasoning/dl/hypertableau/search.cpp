// The order of the search, branching and going back.
#include "reasoning/dl/hypertableau/search.hpp"

#include <algorithm>
#include <utility>

namespace geminga::hypertableau {

Tableau::Search::Search(const owl::Ontology& source, const clauses::ClauseSet& set, const Limits& limits)
    : source_(source), set_(set), limits_(limits), budget_(limits.budget), program_(set), values_(source, set) {
  variables_.assign(256, 0);
}

void Tableau::Search::clash(DependencySet dependency) {
  if (has_clash_) return;
  has_clash_ = true;
  clash_ = dependency;
}

bool Tableau::Search::is_over_limit() {
  if (graph_.node_count() - (base_ ? base_->mark.nodes : 0) > limits_.nodes) {
    reason_ = "more than " + std::to_string(limits_.nodes) + " nodes were needed";
  } else if (graph_.facts().size() - (base_ ? base_->mark.facts : 0) > limits_.facts) {
    reason_ = "more than " + std::to_string(limits_.facts) + " facts were needed";
  } else if (const std::size_t most = limits_.steps + (has_question_ ? 0 : limits_.world_steps); steps_ > most) {
    reason_ = "more than " + std::to_string(most) + " steps were needed";
  } else if (const std::size_t told = std::exchange(told_, steps_); !budget_.spend(steps_ - told)) {
    reason_ = limits_.budget->reason().value_or("");
  } else {
    return false;
  }
  return true;
}

Tableau::Search::Outcome Tableau::Search::run() {
  while (true) {
    if (has_clash_) {
      if (!go_back()) return Outcome::no_model;
      continue;
    }
    if (is_over_limit()) return Outcome::unknown;
    if (!saturate() || expand_functional() || choose() || expand()) continue;
    check_keys();
    if (has_clash_ || !merges_.empty()) continue;
    // A model with values of which not all is known is none.
    unknown_value_.clear();
    check_values();
    if (has_clash_) continue;
    if (reason_.empty()) reason_ = unknown_value_;
    return reason_.empty() ? Outcome::model : Outcome::unknown;
  }
}

/// Whether no clash came.
bool Tableau::Search::saturate() {
  while (!has_clash_) {
    if (!merges_.empty()) {
      // In the order in which they came; new ones come behind.
      for (std::size_t at = 0; at < merges_.size() && !has_clash_; ++at) merge(Merge(merges_[at]));
      merges_.clear();
    } else if (processed_ < graph_.facts().size()) {
      process(processed_++);
      if (is_over_limit()) return true;
    } else if (!suspects_.empty()) {
      const Suspect suspect = suspects_.back();
      suspects_.pop_back();
      check(suspect);
    } else if (values_changed_) {
      values_changed_ = false;
      check_values();
    } else {
      return true;
    }
  }
  return false;
}

void Tableau::Search::branch(std::vector<Choice> alternatives, DependencySet dependency, Suspect suspect) {
  const auto number = static_cast<std::uint32_t>(branches_.size());
  order_by_promise(alternatives);
  const Choice first = alternatives.front();
  ++record_of(first).tries;
  branches_.push_back({state(), std::move(alternatives), 0, dependency, no_dependency, suspect});
  apply(first, unite(dependency, sets_.single(number)));
  if (suspect.node != none) suspects_.push_back(suspect);
}

/// Takes the next alternative of the branch that is to blame. False: there is none, and no model.
bool Tableau::Search::go_back() {
  if (clash_ == no_dependency) return false;
  const std::uint32_t number = sets_.last(clash_);
  branches_.resize(number + 1);
  Branch& branch = branches_.back();
  restore(branch.state);
  branch.failed = unite(branch.failed, sets_.without_last(clash_));
  has_clash_ = false;
  if (number < base_branches_) {
    base_.reset();
    base_branches_ = 0;
  }
  has_failed_ = true;
  ++record_of(branch.alternatives[branch.next]).failures;
  // A guess that fails now and then among many that hold is no reason.
  if (++wrong_guesses_ > patience_ + branches_.size() - base_branches_ && number > base_branches_) {
    begin_again();
    return true;
  }
  const Choice choice = branch.alternatives[++branch.next];
  ++record_of(choice).tries;
  const Suspect suspect = branch.suspect;
  if (branch.next + 1 < branch.alternatives.size()) {
    apply(choice, unite(branch.dependency, sets_.single(number)));
  } else {
    // The last one does not depend on the choice, but on what made the others fail.
    const DependencySet dependency = unite(branch.dependency, branch.failed);
    branches_.pop_back();
    apply(choice, dependency);
  }
  if (suspect.node != none) suspects_.push_back(suspect);
  if (has_question_ && graph_.mark().facts <= question_mark_) ask();
  return true;
}

/// What was guessed first was guessed without knowing what fails, and is wrong more often than what is guessed now: all
/// guesses of this question are taken back. Each time the search goes on for longer, so that it ends.
void Tableau::Search::begin_again() {
  patience_ *= 2;
  wrong_guesses_ = 0;
  const Branch first = std::move(branches_[base_branches_]);
  branches_.resize(base_branches_);
  restore(first.state);
  if (first.suspect.node != none) suspects_.push_back(first.suspect);
  if (has_question_ && graph_.mark().facts <= question_mark_) ask();
}

void Tableau::Search::check_values() {
  if (graph_.value_count() == 0) return;
  constexpr std::size_t values_a_step = 4;  // all of them are looked at again
  steps_ += graph_.value_count() / values_a_step;
  if (const auto dependency = values_.clash(graph_, sets_, unknown_value_)) clash(*dependency);
}

Tableau::Search::State Tableau::Search::state() const {
  return {graph_.mark(),    processed_,   disjunctions_.size(),      next_disjunction_,
          demands_.size(),  next_demand_, choices_.size(),           existentials_.size(),
          next_functional_, done_.size(), done_disjunctions_.size(), introduced_.size()};
}

void Tableau::Search::restore(const State& state) {
  graph_.cut(state.mark);
  processed_ = state.processed;
  while (done_disjunctions_.size() > state.done_disjunctions) {
    disjunctions_[done_disjunctions_.back()].is_done = false;
    done_disjunctions_.pop_back();
  }
  disjunctions_.resize(state.disjunctions);
  next_disjunction_ = state.next_disjunction;
  demands_.resize(state.demands);
  next_demand_ = state.next_demand;
  choices_.resize(state.choices);
  while (done_.size() > state.done) {
    existentials_[done_.back()].is_done = false;
    done_.pop_back();
  }
  existentials_.resize(state.existentials);
  next_functional_ = state.next_functional;
  introduced_.resize(state.introduced);
  merges_.clear();
  suspects_.clear();
  values_changed_ = false;
}

void Tableau::Search::reset() {
  restore({});
  branches_.clear();
  sets_.clear();
  base_.reset();
  base_branches_ = 0;
  has_clash_ = false;
  records_.clear();
  individuals_.clear();
}

}  // namespace geminga::hypertableau
