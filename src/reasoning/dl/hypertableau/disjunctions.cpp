// The alternatives of a disjunction that are left.
#include "reasoning/dl/hypertableau/disjunctions.hpp"

#include <algorithm>
#include <utility>

namespace geminga::hypertableau {

using clauses::number;

namespace {

/// The number of open disjunctions that are compared before one is taken. Few suffice as long as every guess was right.
constexpr std::size_t few_compared = 16;
constexpr std::size_t max_compared = 256;
/// The disjunctions whose nodes have not changed that are compared in the time of a look.
constexpr std::size_t known_a_look = 16;

}  // namespace

void Disjunctions::restore(const Sizes& sizes) {
  while (done_.size() > sizes.done) {
    disjunctions_[done_.back()].is_done = false;
    done_.pop_back();
  }
  disjunctions_.resize(sizes.disjunctions);
  next_ = sizes.next;
  choices_.resize(sizes.choices);
}

void Disjunctions::add(std::vector<Choice>& alternatives, DependencySet dependency) {
  std::erase_if(alternatives, [this](const Choice& choice) { return facts_.is_impossible(choice); });
  if (alternatives.empty()) {
    facts_.clash(dependency);
  } else if (alternatives.size() == 1) {
    facts_.apply(alternatives.front(), dependency);
  } else {
    const auto begin = static_cast<std::uint32_t>(choices_.size());
    effort_.count_step();
    choices_.insert(choices_.end(), alternatives.begin(), alternatives.end());
    Disjunction& added = disjunctions_.emplace_back(begin, static_cast<std::uint32_t>(choices_.size()), dependency);
    added.left = added.end - added.begin;
    added.is_local = is_local(alternatives);
  }
}

bool Disjunctions::is_local(std::span<const Choice> alternatives) const {
  return std::ranges::all_of(alternatives, [this](const Choice& choice) {
    return choice.kind == ChoiceKind::concept_of && program_.bounds_of_guard(choice.predicate).empty();
  });
}

// The labels of its nodes; if it is not local, also those of their neighbours in the tree. A change further away, which
// this does not show, is seen when the disjunction is decided.
std::uint64_t Disjunctions::state_of(const Disjunction& disjunction) const {
  const NodeId first = graph_.current(choices_[disjunction.begin].a);
  const NodeId last = graph_.current(choices_[disjunction.end - 1].b);
  std::uint64_t state = 0;
  for (const NodeId id : {first, last}) {
    const Node& node = graph_.node(id);
    state += node.version;
    if (disjunction.is_local) continue;
    if (node.parent == none && program_.has_nominals()) return 0;
    state += node.surroundings + (node.parent == none ? 0 : graph_.node(node.parent).version);
  }
  return state;
}

std::variant<Disjunctions::AllDecided, Disjunctions::Asserted, Decision> Disjunctions::find_next() {
  const std::size_t most = records_.has_failed() ? max_compared : few_compared;
  while (true) {
    std::size_t compared = 0;
    std::size_t chosen = 0;
    Promise best;
    for (std::size_t at = next_; at < disjunctions_.size() && compared < most; ++at) {
      Disjunction& one = disjunctions_[at];
      if (at % known_a_look == 0) effort_.count_look();
      // Those that have to be looked at anyway are many where there are individuals, and few of them change.
      if (const std::uint64_t state = one.is_done ? 0 : state_of(one);
          !one.is_done && (state == 0 ? compared < few_compared : state != one.seen)) {
        if (settle(at) && !one.is_done) return Asserted();
        one.seen = state;
      }
      if (one.is_done) {
        if (at == next_) ++next_;
        continue;
      }
      const auto alternatives = std::span(choices_).subspan(one.begin, one.end - one.begin);
      const Promise promise{one.left, records_.has_failed() ? records_.failures_of(alternatives) : 0};
      if (compared++ > 0 && !promise.is_before(best)) continue;
      best = promise;
      chosen = at;
    }
    if (compared == 0) return AllDecided();
    if (!settle(chosen)) return Decision{open_.alternatives, open_.dependency, {}};
    if (!disjunctions_[chosen].is_done) return Asserted();
  }
}

bool Disjunctions::settle(std::size_t disjunction) {
  open(disjunctions_[disjunction], open_);
  disjunctions_[disjunction].left = static_cast<std::uint32_t>(open_.alternatives.size());
  if (open_.is_done) {
    note_done(disjunction);
  } else if (open_.alternatives.empty()) {
    facts_.clash(open_.dependency);
  } else if (open_.alternatives.size() == 1) {
    facts_.apply(open_.alternatives.front(), open_.dependency);
  } else {
    return false;
  }
  return true;
}

// A disjunction of which one alternative holds stays decided until this branch is taken back.
void Disjunctions::note_done(std::size_t disjunction) {
  disjunctions_[disjunction].is_done = true;
  done_.push_back(static_cast<std::uint32_t>(disjunction));
}

// The fewest alternatives for each failure known of them. A disjunction whose many alternatives all fail leads to the
// cause sooner than many disjunctions of two (dom/wdeg: Boussemart, Hemery, Lecoutre, Sais: Boosting systematic search
// by weighting constraints, 2004).
bool Disjunctions::Promise::is_before(const Promise& other) const {
  return alternatives * (1 + other.failures) < other.alternatives * (1 + failures);
}

void Disjunctions::open(const Disjunction& disjunction, Open& result) {
  result.alternatives.clear();
  result.dependency = disjunction.dependency;
  for (std::uint32_t at = disjunction.begin; at < disjunction.end; ++at) {
    effort_.count_look();
    Choice choice = choices_[at];
    choice.a = graph_.current(choice.a, result.dependency);
    choice.b = graph_.current(choice.b, result.dependency);
    result.is_done =
        !graph_.is_active(choice.a) || !graph_.is_active(choice.b) || check_.holds(choice) || derive(choice);
    if (result.is_done) return;
    if (!check_.is_excluded(choice, result.dependency)) result.alternatives.push_back(choice);
  }
}

// Derives a choice that follows from the facts: an at-least that a neighbour satisfies.
bool Disjunctions::derive(const Choice& choice) {
  if (choice.kind != ChoiceKind::at_least || program_.needed(choice.predicate) > 1) return false;
  const clauses::AtLeast& at_least = program_.at_least(choice.predicate);
  const bool is_inverse = at_least.role.is_inverse;
  for (FactId id = is_inverse ? graph_.node(choice.a).in : graph_.node(choice.a).out; id != none;
       id = is_inverse ? graph_.fact(id).next_b : graph_.fact(id).next_a) {
    effort_.count_look();
    const Fact& edge = graph_.fact(id);
    const NodeId node = is_inverse ? edge.a : edge.b;
    if (edge.kind != FactKind::role || edge.predicate != number(at_least.role.property) || !graph_.is_active(node))
      continue;
    DependencySet dependency = edge.dependency;
    if (at_least.filler != clauses::thing) {
      const FactId filler = graph_.find(FactKind::concept_of, number(at_least.filler), node);
      if (filler == none) continue;
      dependency = graph_.unite(dependency, graph_.fact(filler).dependency);
    }
    facts_.add_fact(FactKind::at_least, choice.predicate, choice.a, 0, dependency);
    return true;
  }
  return false;
}

}  // namespace geminga::hypertableau
