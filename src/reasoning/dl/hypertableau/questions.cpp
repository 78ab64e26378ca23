// What is asked: the facts, a fresh instance of concepts, keys; and the model that answers.
#include <algorithm>
#include <utility>

#include "reasoning/dl/hypertableau/search.hpp"

namespace geminga::hypertableau {

using clauses::number;

namespace {

/// Beyond this the models of earlier questions make room.
constexpr std::size_t max_kept_nodes = 20'000;
/// As many choices may be wrong before the search begins again with what it has learnt.
constexpr std::size_t first_patience = 64;

}  // namespace

void Tableau::Search::load_individuals() {
  // There is at least one thing.
  if (set_.individuals.empty()) {
    const NodeId node = add_node(NodeKind::root, none, no_dependency);
    if (!program_.needs_thing()) add_fact(FactKind::concept_of, number(clauses::thing), node, 0, no_dependency);
  }
  for (std::size_t at = 0; at < set_.individuals.size(); ++at) {
    individuals_.push_back(add_node(NodeKind::root, none, no_dependency));
  }
  for (std::uint32_t at = 0; at < set_.concepts.size(); ++at) {
    const clauses::Concept& entry = set_.concepts[at];
    if (entry.kind != clauses::ConceptKind::nominal) continue;
    add_fact(FactKind::concept_of, at, individuals_[number(entry.individual)], 0, no_dependency);
  }
}

void Tableau::Search::load_facts() {
  load_individuals();
  for (const clauses::ConceptFact& fact : set_.concept_facts) {
    add_fact(FactKind::concept_of, number(fact.of), individuals_[number(fact.individual)], 0, no_dependency);
  }
  for (const clauses::RoleFact& fact : set_.role_facts) {
    add_fact(FactKind::role, number(fact.property), individuals_[number(fact.first)], individuals_[number(fact.second)],
             no_dependency);
  }
  for (const clauses::DataFact& fact : set_.data_facts) {
    const NodeId value = constant(fact.value);
    add_fact(FactKind::data_role, number(fact.property), individuals_[number(fact.individual)], value, no_dependency);
  }
  for (const clauses::Equality& equality : set_.equalities) {
    const NodeId first = individuals_[number(equality.first)];
    const NodeId second = individuals_[number(equality.second)];
    if (equality.is_negated) {
      add_unequal(first, second, no_dependency);
    } else {
      merges_.push_back({first, second, no_dependency});
    }
  }
}

NodeId Tableau::Search::constant(owl::TermId literal) {
  const owl::TermId chosen = values_.representative(literal);
  const auto [found, is_new] = constants_.try_emplace(chosen, none);
  const NodeId known = found->second;
  const bool is_there = known < graph_.node_count() && graph_.node(known).kind == NodeKind::constant &&
                        graph_.node(known).literal == static_cast<std::uint32_t>(chosen);
  if (is_there) return known;
  found->second = graph_.add_node(NodeKind::constant, none);
  graph_.set_literal(found->second, static_cast<std::uint32_t>(chosen));
  return found->second;
}

Answer Tableau::Search::answer(Outcome outcome) {
  switch (outcome) {
    case Outcome::model:
      write_model();
      return {Verdict::yes, {}};
    case Outcome::no_model:
      return {Verdict::no, {}};
    case Outcome::unknown:
      break;
  }
  return {Verdict::unknown, reason_};
}

Tableau::Search::Outcome Tableau::Search::find_consistency() {
  has_question_ = false;
  if (consistency_ && (*consistency_ != Outcome::model || !program_.has_nominals() || base_)) return *consistency_;
  reset();
  steps_ = told_ = 0;
  has_failed_ = false;
  wrong_guesses_ = 0;
  patience_ = first_patience;
  reason_.clear();
  load_facts();
  consistency_ = run();
  consistency_reason_ = reason_;
  if (*consistency_ == Outcome::model) {
    write_model();
    consistent_model_ = model_;
    if (program_.has_nominals()) keep_model();
  }
  return *consistency_;
}

Answer Tableau::Search::is_consistent() {
  const Outcome outcome = find_consistency();
  reason_ = consistency_reason_;
  if (outcome != Outcome::model) return answer(outcome);
  model_ = consistent_model_;
  return {Verdict::yes, {}};
}

/// What the question is put onto. Without nominals facts and questions have nothing to do with each other.
bool Tableau::Search::prepare_base() {
  if (find_consistency() != Outcome::model) return false;
  if (!program_.has_nominals() && (!base_ || base_->mark.nodes > max_kept_nodes)) {
    reset();
    keep_model();
  }
  return true;
}

Answer Tableau::Search::is_satisfiable(std::vector<clauses::ConceptId> together) {
  if (!prepare_base()) {
    reason_ = consistency_reason_;
    return answer(*consistency_);
  }
  question_ = std::move(together);
  has_question_ = true;
  steps_ = told_ = 0;
  has_failed_ = false;
  wrong_guesses_ = 0;
  patience_ = first_patience;
  reason_.clear();
  ask();
  const Outcome outcome = run();
  const Answer result = answer(outcome);
  has_question_ = false;
  has_clash_ = false;
  if (!base_) return result;
  const bool has_values = graph_.value_count() > 0;
  if (outcome == Outcome::model && !program_.has_nominals() && !has_values) {
    keep_model();
  } else {
    branches_.resize(base_branches_);
    restore(*base_);
  }
  return result;
}

/// Questions that come are put beside what there is, whose nodes block theirs. Nothing leads from one model to another,
/// so that nothing in a kept model changes; values, which models would share, are not kept.
void Tableau::Search::keep_model() {
  base_ = state();
  base_branches_ = branches_.size();
}

void Tableau::Search::ask() {
  question_mark_ = graph_.mark().facts;
  question_node_ = add_node(NodeKind::root, none, no_dependency);
  if (!program_.needs_thing() && question_.empty()) {
    // So that cutting it off is seen.
    add_fact(FactKind::concept_of, number(clauses::thing), question_node_, 0, no_dependency);
  }
  for (const clauses::ConceptId id : question_) {
    add_fact(FactKind::concept_of, number(id), question_node_, 0, no_dependency);
  }
}

void Tableau::Search::write_label(NodeId node) {
  std::vector<clauses::ConceptId> label;
  for (FactId id = graph_.node(node).labels; id != none; id = graph_.fact(id).next_a) {
    if (graph_.fact(id).predicate < set_.concepts.size())
      label.push_back(clauses::ConceptId{graph_.fact(id).predicate});
  }
  std::ranges::sort(label);
  model_.labels.push_back(std::move(label));
}

void Tableau::Search::write_model() {
  model_ = {};
  DependencySet dependency = no_dependency;
  const NodeId asked = has_question_ ? graph_.current(question_node_, sets_, dependency) : none;
  if (asked != none) {
    write_label(asked);
    for (FactId id = graph_.node(asked).labels; id != none; id = graph_.fact(id).next_a) {
      const Fact& fact = graph_.fact(id);
      // What came to it by a merge that was not certain has that merge among its dependencies.
      if (fact.predicate < set_.concepts.size() && unite(fact.dependency, dependency) == no_dependency)
        model_.certain.push_back(clauses::ConceptId{fact.predicate});
    }
    std::ranges::sort(model_.certain);
  }
  const auto write = [&](NodeId node) {
    const NodeKind kind = graph_.node(node).kind;
    const bool is_object = kind == NodeKind::root || kind == NodeKind::tree;
    const bool is_blocked = kind == NodeKind::tree && graph_.node(node).is_blocked;
    if (node != asked && is_object && graph_.is_active(node) && !is_blocked) write_label(node);
  };
  // What is older than the question and as it was has been written before.
  const Mark before = base_ ? base_->mark : Mark{};
  std::vector<NodeId> changed;
  for (auto id = static_cast<FactId>(before.facts); id < graph_.facts().size(); ++id) {
    const Fact& fact = graph_.fact(id);
    if (fact.kind == FactKind::concept_of && fact.a < before.nodes) changed.push_back(fact.a);
  }
  std::ranges::sort(changed);
  changed.erase(std::ranges::unique(changed).begin(), changed.end());
  std::ranges::for_each(changed, write);
  for (auto node = static_cast<NodeId>(before.nodes); node < graph_.node_count(); ++node) write(node);
}

void Tableau::Search::check_keys() {
  // of(a), of(b), R(a,c), R(b,c), ..., U(a,v), U(b,v), ... -> a = b for named individuals a, b, c
  if (individuals_.empty() || set_.keys.empty()) return;
  is_named_.assign(graph_.node_count(), false);
  for (std::size_t at = 0; at < individuals_.size(); ++at) {
    const owl::TermId term = set_.individuals[at];
    if (term == clauses::no_term || source_.kind(term) != owl::TermKind::individual) continue;
    DependencySet ignored = no_dependency;
    is_named_[graph_.current(individuals_[at], sets_, ignored)] = true;
  }
  for (const clauses::Key& key : set_.keys) {
    std::vector<NodeId> members;
    for (NodeId node = 0; node < is_named_.size(); ++node) {
      if (!is_named_[node] || !graph_.is_active(node)) continue;
      const bool is_in = key.of == clauses::thing || graph_.find(FactKind::concept_of, number(key.of), node) != none;
      if (is_in) members.push_back(node);
    }
    for (std::size_t first = 0; first < members.size(); ++first) {
      for (std::size_t second = first + 1; second < members.size(); ++second) {
        DependencySet dependency = no_dependency;
        if (!agree(key, members[first], members[second], dependency)) continue;
        merges_.push_back({members[first], members[second], dependency});
        return;
      }
    }
  }
}

bool Tableau::Search::agree(const clauses::Key& key, NodeId first, NodeId second, DependencySet& dependency) {
  const auto add = [&](FactId id) {
    if (id != none) dependency = unite(dependency, graph_.fact(id).dependency);
    return id != none;
  };
  if (key.of != clauses::thing) {
    add(graph_.find(FactKind::concept_of, number(key.of), first));
    add(graph_.find(FactKind::concept_of, number(key.of), second));
  }
  const auto shares = [&](FactKind kind, std::uint32_t property, bool is_inverse) {
    for (FactId id = is_inverse ? graph_.node(first).in : graph_.node(first).out; id != none;
         id = is_inverse ? graph_.fact(id).next_b : graph_.fact(id).next_a) {
      const Fact& fact = graph_.fact(id);
      const NodeId other = is_inverse ? fact.a : fact.b;
      if (fact.kind != kind || fact.predicate != property || !graph_.is_active(other)) continue;
      if (kind == FactKind::role && !is_named_[other]) continue;
      const FactId same =
          is_inverse ? graph_.find(kind, property, other, second) : graph_.find(kind, property, second, other);
      if (same == none) continue;
      add(id);
      add(same);
      return true;
    }
    return false;
  };
  return std::ranges::all_of(key.roles,
                             [&](const clauses::Role& role) {
                               return shares(FactKind::role, number(role.property), role.is_inverse);
                             }) &&
         std::ranges::all_of(key.data_properties, [&](clauses::DataPropertyId id) {
           return shares(FactKind::data_role, number(id), false);
         });
}

}  // namespace geminga::hypertableau
