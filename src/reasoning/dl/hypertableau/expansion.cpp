// How at-least restrictions are satisfied. The rule is in expansion.hpp.
#include "reasoning/dl/hypertableau/expansion.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

#include "reasoning/owl/source.hpp"

namespace geminga::hypertableau {

using clauses::number;

void Expansion::restore(const Sizes& sizes) {
  while (done_.size() > sizes.done) {
    existentials_[done_.back()].is_done = false;
    open_.insert({existentials_[done_.back()].node, done_.back()});
    done_.pop_back();
  }
  offer_.reset();
  while (existentials_.size() > sizes.existentials) {
    const Existential& last = existentials_.back();
    open_.erase({last.node, static_cast<std::uint32_t>(existentials_.size() - 1)});
    newest_[last.node] = last.older;
    existentials_.pop_back();
  }
  next_certain_ = sizes.next_certain;
}

void Expansion::note_done(std::uint32_t at) {
  existentials_[at].is_done = true;
  done_.push_back(at);
}

void Expansion::add(const Fact& fact, FactId id) {
  const auto at = static_cast<std::uint32_t>(existentials_.size());
  if (newest_.size() <= fact.a) newest_.resize(graph_.node_count(), none);
  existentials_.push_back({.fact = id, .node = fact.a, .older = std::exchange(newest_[fact.a], at)});
  open_.insert({fact.a, at});
  if (fact.kind != FactKind::at_least) return;
  const clauses::AtLeast& at_least = set_.at_leasts[fact.predicate];
  const bool is_of_nominal = set_.concepts[number(at_least.filler)].kind == clauses::ConceptKind::nominal;
  if (program_.needed(fact.predicate) != 1 || is_of_nominal || !give_to_neighbour(fact)) return;
  note_done(at);
}

std::size_t Expansion::update_open() {
  const std::size_t looked = blocking_.update();
  for (const NodeId node : blocking_.take_unblocked()) {
    if (node >= newest_.size()) continue;
    for (std::uint32_t at = newest_[node]; at != none; at = existentials_[at].older) {
      if (!existentials_[at].is_done) open_.insert({node, at});
    }
  }
  return looked;
}

bool Expansion::expand(NodeId first, Order order) {
  // The look for blocked nodes is paid for by expanding several at-leasts at a time.
  constexpr std::size_t looked_an_expansion = 64;
  const std::size_t looked = update_open();
  const std::size_t most =
      order == Order::everything ? std::numeric_limits<std::size_t>::max() : 1 + looked / looked_an_expansion;
  const bool is_downward = order == Order::newest_first;
  const auto count = static_cast<std::uint32_t>(existentials_.size());
  std::size_t expanded = 0;
  auto next = is_downward ? open_.end() : open_.lower_bound({first, 0});
  offer_.reset();
  while (expanded < most && !offer_ && !facts_.has_clash() && !effort_.is_over_limit()) {
    if (is_downward) {
      if (next == open_.begin() || std::prev(next)->node < first) break;
      --next;
    } else if (next == open_.end()) {
      break;
    }
    const NodeId node = next->node;
    expanded += expand_node(node, count, expanded == 0);
    next = open_.lower_bound({is_downward ? node : node + 1, 0});
  }
  return expanded > 0;
}

// At-leasts of several neighbours come last, the most special filler first, and one at a time: neighbours that others
// ask for are among them once their labels are derived.
std::size_t Expansion::expand_node(NodeId node, std::uint32_t count, bool may_offer) {
  std::size_t expanded = 0;
  std::vector<std::uint32_t> of_several;
  for (auto next = open_.lower_bound({node, 0}); next != open_.end() && next->node == node && next->number < count;) {
    const std::uint32_t at = next->number;
    if (existentials_[at].is_done || !graph_.is_active(node) || graph_.node(node).is_blocked) {
      next = open_.erase(next);
      continue;
    }
    ++next;
    if (is_of_several(at)) {
      of_several.push_back(at);
      continue;
    }
    if (has_witness(existentials_[at]) || !expand_one(at)) continue;
    ++expanded;
    if (facts_.has_clash() || effort_.is_over_limit()) return expanded;
  }
  if (expanded > 0 || of_several.empty()) return expanded;
  std::ranges::stable_sort(of_several, std::ranges::greater(), [this](std::uint32_t at) {
    return program_.numbers().specificity({graph_.fact(existentials_[at].fact).predicate});
  });
  for (const std::uint32_t at : of_several) {
    const Way way = expand_several(at, may_offer);
    if (way != Way::satisfied) return way == Way::expanded ? 1 : 0;
  }
  return 0;
}

// An offer waits until nothing else is expanded, so that all that is certain is derived first.
Expansion::Way Expansion::expand_several(std::uint32_t at, bool may_offer) {
  const Fact fact = graph_.fact(existentials_[at].fact);
  if (is_satisfied(fact)) {
    note_done(at);
    return Way::satisfied;
  }
  if (sharing_.is_promising(fact)) {
    if (!may_offer) return Way::open;
    const auto choice = [&](ChoiceKind kind) { return Choice{kind, fact.predicate, fact.a, fact.a, at}; };
    offer_ = Decision{{choice(ChoiceKind::share_neighbours), choice(ChoiceKind::make_neighbours)}, fact.dependency, {}};
    return Way::open;
  }
  note_done(at);
  make_neighbours(fact);
  return Way::expanded;
}

void Expansion::apply(const Choice& choice, DependencySet dependency) {
  const Fact fact = graph_.fact(existentials_[choice.bound].fact);
  note_done(choice.bound);
  if (choice.kind == ChoiceKind::share_neighbours) {
    add_neighbours(fact, sharing_.share(fact, dependency), dependency);
  } else {
    make_neighbours(fact);
  }
}

bool Expansion::is_of_several(std::uint32_t at) const {
  const Fact& fact = graph_.fact(existentials_[at].fact);
  return program_.counts() && fact.kind == FactKind::at_least && program_.needed(fact.predicate) > 1;
}

// Each at-least is looked at once. Those of blocked nodes are left to expand().
bool Expansion::expand_certain() {
  if (next_certain_ == existentials_.size()) return false;
  bool has_expanded = false;
  bool has_looked = false;
  while (next_certain_ < existentials_.size() && !has_expanded) {
    const std::uint32_t at = next_certain_++;
    const Fact fact = graph_.fact(existentials_[at].fact);
    if (existentials_[at].is_done || fact.kind != FactKind::at_least || !graph_.is_active(fact.a)) continue;
    const clauses::AtLeast& at_least = set_.at_leasts[fact.predicate];
    const bool is_of_nominal = program_.needed(fact.predicate) == 1 &&
                               set_.concepts[number(at_least.filler)].kind == clauses::ConceptKind::nominal;
    if (!is_of_nominal && !neighbours_.is_functional(at_least.role, fact.a)) continue;
    if (!has_looked) blocking_.update();
    has_looked = true;
    has_expanded = !graph_.node(fact.a).is_blocked && expand_one(at);
  }
  return has_expanded;
}

bool Expansion::expand_one(std::uint32_t at) {
  const Fact fact = graph_.fact(existentials_[at].fact);
  if (!is_satisfied(fact) && needs_plain(fact)) {
    make_plain(at);
    return true;
  }
  note_done(at);
  if (is_satisfied(fact)) return false;
  if (fact.kind == FactKind::at_least) {
    expand_object(fact);
  } else {
    expand_data(fact);
  }
  return true;
}

// Most denials of a node hold of one neighbour of which nothing is said. So that one is made first, and the at-least
// stays open. If something comes to be forbidden of that neighbour, the at-least makes one with the filler.
bool Expansion::needs_plain(const Fact& fact) const {
  if (fact.kind != FactKind::at_least || program_.needed(fact.predicate) != 1) return false;
  const clauses::AtLeast& one = set_.at_leasts[fact.predicate];
  if (!program_.denials().is_denial(number(one.filler)) || neighbours_.is_functional(one.role, fact.a)) return false;
  for (std::uint32_t at = newest_[fact.a]; at != none; at = existentials_[at].older) {
    const NodeId plain = existentials_[at].plain;
    if (plain >= graph_.node_count() || graph_.node(plain).parent != fact.a) continue;
    if (set_.at_leasts[graph_.fact(existentials_[at].fact).predicate].role == one.role) return false;
  }
  return true;
}

void Expansion::make_plain(std::uint32_t at) {
  const Fact fact = graph_.fact(existentials_[at].fact);
  const NodeId node = facts_.add_node(NodeKind::tree, fact.a, fact.dependency);
  add_edge(fact, node, fact.dependency);
  existentials_[at].plain = node;
}

// If more than the label matters, the witness must be a child: only then has each copy of the node in the unravelled
// model a copy of the witness with all that is around it. What is around a blocked child in the model is its parent,
// and what is around its blocker.
bool Expansion::may_be_witness(std::uint32_t denial, NodeId node, NodeId of) const {
  const Node& one = graph_.node(node);
  if (one.state != NodeState::active) return false;
  if (program_.denials().forbidden(denial).empty()) return true;
  return one.kind == NodeKind::tree && one.parent == of && (!one.is_blocked || blocking_.blocker_of(node) != none);
}

std::uint64_t Expansion::version_of_witness(std::uint32_t denial, NodeId node, NodeId of) const {
  const Node& one = graph_.node(node);
  if (program_.denials().forbidden(denial).empty()) return one.version;
  std::uint64_t version = one.version + one.surroundings + graph_.node(of).version;
  if (const NodeId blocker = blocking_.blocker_of(node); blocker != none) {
    const Node& other = graph_.node(blocker);
    version += other.version + other.surroundings;
    if (other.parent != none) version += graph_.node(other.parent).version;
  }
  return version;
}

NodeId Expansion::find_witness(std::uint32_t at_least, NodeId node) {
  const clauses::AtLeast& one = set_.at_leasts[at_least];
  const std::uint32_t filler = number(one.filler);
  if (program_.needed(at_least) != 1 || !program_.denials().is_denial(filler)) return none;
  const bool is_inverse = one.role.is_inverse;
  for (FactId id = is_inverse ? graph_.node(node).in : graph_.node(node).out; id != none;
       id = is_inverse ? graph_.fact(id).next_b : graph_.fact(id).next_a) {
    effort_.count_look();
    const Fact& edge = graph_.fact(id);
    const NodeId other = is_inverse ? edge.a : edge.b;
    if (edge.kind != FactKind::role || edge.predicate != number(one.role.property)) continue;
    if (!may_be_witness(filler, other, node) || neighbours_.is_denied(filler, other)) continue;
    const NodeId blocker = program_.denials().forbidden(filler).empty() ? none : blocking_.blocker_of(other);
    if (blocker == none || !neighbours_.is_denied(filler, blocker)) return other;
  }
  return none;
}

bool Expansion::has_witness(Existential& existential) {
  const Fact fact = graph_.fact(existential.fact);
  if (fact.kind != FactKind::at_least) return false;
  const clauses::AtLeast& at_least = set_.at_leasts[fact.predicate];
  const std::uint32_t filler = number(at_least.filler);
  if (program_.needed(fact.predicate) != 1 || !program_.denials().is_denial(filler)) return false;
  effort_.count_look();
  // After a branch was taken back, the number may be that of another node, so the edge is looked up again.
  const NodeId known = existential.witness;
  const bool is_inverse = at_least.role.is_inverse;
  // Changes of an individual beside the witness have no version that is looked at.
  const bool is_noted = !program_.has_nominals() || program_.denials().forbidden(filler).empty();
  const bool is_known = is_noted && known < graph_.node_count() && may_be_witness(filler, known, fact.a) &&
                        blocking_.blocker_of(known) == existential.blocker &&
                        version_of_witness(filler, known, fact.a) == existential.version &&
                        graph_.find(FactKind::role, number(at_least.role.property), is_inverse ? known : fact.a,
                                    is_inverse ? fact.a : known) != none;
  if (is_known) return true;
  existential.witness = find_witness(fact.predicate, fact.a);
  if (existential.witness == none) return false;
  existential.blocker = blocking_.blocker_of(existential.witness);
  existential.version = version_of_witness(filler, existential.witness, fact.a);
  return true;
}

bool Expansion::is_satisfied(const Fact& fact) {
  const bool is_data = fact.kind == FactKind::data_at_least;
  if (!is_data && program_.needed(fact.predicate) == 1) return witnesses_.satisfy(fact.predicate, fact.a);
  const std::uint32_t count = is_data ? set_.data_at_leasts[fact.predicate].count : program_.needed(fact.predicate);
  const bool is_inverse = !is_data && set_.at_leasts[fact.predicate].role.is_inverse;
  const std::uint32_t property = is_data ? number(set_.data_at_leasts[fact.predicate].property)
                                         : number(set_.at_leasts[fact.predicate].role.property);
  const Choice filler = is_data ? Choice{ChoiceKind::data_range, number(set_.data_at_leasts[fact.predicate].range)}
                                : Choice{ChoiceKind::concept_of, number(set_.at_leasts[fact.predicate].filler)};
  const FactKind kind = is_data ? FactKind::data_role : FactKind::role;
  std::vector<NodeId> found;
  for (FactId id = is_inverse ? graph_.node(fact.a).in : graph_.node(fact.a).out; id != none && found.size() < count;
       id = is_inverse ? graph_.fact(id).next_b : graph_.fact(id).next_a) {
    const Fact& edge = graph_.fact(id);
    const NodeId node = is_inverse ? edge.a : edge.b;
    if (edge.kind != kind || edge.predicate != property || !graph_.is_active(node)) continue;
    const bool is_in = is_data || count == 1 || !program_.counts()
                           ? facts_.holds({filler.kind, filler.predicate, node, node})
                           : neighbours_.membership(filler.predicate, node).has_value();
    if (!is_in) continue;
    const bool is_different =
        std::ranges::all_of(found, [&](NodeId other) { return neighbours_.difference(node, other).has_value(); });
    if (is_different) found.push_back(node);
  }
  return found.size() >= count;
}

void Expansion::expand_object(const Fact& fact) {
  const clauses::AtLeast& at_least = set_.at_leasts[fact.predicate];
  const clauses::Concept& filler = set_.concepts[number(at_least.filler)];
  const std::uint32_t needed = program_.needed(fact.predicate);
  if (needed == 1) {
    if (filler.kind == clauses::ConceptKind::nominal) {
      DependencySet dependency = fact.dependency;
      const NodeId node = graph_.current(facts_.individuals()[number(filler.individual)], sets_, dependency);
      add_edge(fact, node, dependency);
      return;
    }
    if (give_to_neighbour(fact)) return;
  }
  make_neighbours(fact);
}

void Expansion::add_edge(const Fact& at_least, NodeId node, DependencySet dependency) {
  const clauses::Role role = set_.at_leasts[at_least.predicate].role;
  const auto [from, to] = role.is_inverse ? std::pair(node, at_least.a) : std::pair(at_least.a, node);
  facts_.add_fact(FactKind::role, number(role.property), from, to, dependency);
}

void Expansion::make_neighbours(const Fact& fact) {
  DependencySet dependency = fact.dependency;
  std::vector<NodeId> known;
  if (program_.needed(fact.predicate) > 1 && program_.counts()) known = sharing_.find_different(fact, dependency);
  add_neighbours(fact, known, dependency);
}

// Makes the neighbours that are missing to the known ones, which differ.
void Expansion::add_neighbours(const Fact& fact, std::span<const NodeId> known, DependencySet dependency) {
  const clauses::AtLeast& at_least = set_.at_leasts[fact.predicate];
  const std::uint32_t needed = program_.needed(fact.predicate);
  const auto first = static_cast<NodeId>(graph_.node_count());
  for (std::size_t at = known.size(); at < needed; ++at) {
    const NodeId node = facts_.add_node(NodeKind::tree, fact.a, dependency);
    add_edge(fact, node, dependency);
    if (at_least.filler != clauses::thing) {
      facts_.add_fact(FactKind::concept_of, number(at_least.filler), node, 0, dependency);
    }
    for (const NodeId other : known) facts_.add_unequal(other, node, dependency);
    if (effort_.is_over_limit()) return;
  }
  if (known.size() < needed) facts_.add_siblings(first, dependency);
}

// If the property has at most one value, the neighbour in the graph must have the filler.
bool Expansion::give_to_neighbour(const Fact& fact) {
  const clauses::AtLeast& at_least = set_.at_leasts[fact.predicate];
  const auto neighbour = neighbours_.only(at_least.role, fact.a);
  if (!neighbour) return false;
  facts_.apply({ChoiceKind::concept_of, number(at_least.filler), neighbour->node, neighbour->node},
               sets_.unite(neighbour->dependency, fact.dependency));
  return true;
}

void Expansion::expand_data(const Fact& fact) {
  const clauses::DataAtLeast& at_least = set_.data_at_leasts[fact.predicate];
  const clauses::DataRange& range = set_.data_ranges[number(at_least.range)];
  const bool is_literal = number(at_least.range) > 1 && source_.kind(range.term) == owl::TermKind::literal;
  if (at_least.count == 1 && is_literal && !range.is_complement) {
    DependencySet dependency = fact.dependency;
    const NodeId value = graph_.current(facts_.constant(range.term), sets_, dependency);
    facts_.add_fact(FactKind::data_role, number(at_least.property), fact.a, value, dependency);
    return;
  }
  const auto first = static_cast<NodeId>(graph_.node_count());
  for (std::uint32_t at = 0; at < at_least.count; ++at) {
    const NodeId node = facts_.add_value(fact.a);
    facts_.add_fact(FactKind::data_role, number(at_least.property), fact.a, node, fact.dependency);
    if (number(at_least.range) != 0) {
      facts_.add_fact(FactKind::data_range, number(at_least.range), node, 0, fact.dependency);
    }
    if (effort_.is_over_limit()) return;
  }
  facts_.add_siblings(first, fact.dependency);
}

}  // namespace geminga::hypertableau
