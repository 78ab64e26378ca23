// How at-least restrictions are satisfied. The rule is in expansion.hpp.
#include "reasoning/dl/hypertableau/expansion.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

namespace geminga::hypertableau {

using clauses::number;

namespace {

/// Nodes that are deeper have no neighbours made before alternatives are chosen. 0 are individuals, and what is asked
/// for.
constexpr std::uint32_t deepest_certain = 1;

}  // namespace

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

bool Expansion::is_of_nominal(const Fact& at_least) const {
  return program_.nominal(number(program_.at_least(at_least.predicate).filler)).has_value();
}

void Expansion::add(const Fact& fact, FactId id) {
  const auto at = static_cast<std::uint32_t>(existentials_.size());
  if (newest_.size() <= fact.a) newest_.resize(graph_.node_count(), none);
  existentials_.push_back({.fact = id, .node = fact.a, .older = std::exchange(newest_[fact.a], at)});
  open_.insert({fact.a, at});
  if (fact.kind != FactKind::at_least) return;
  if (program_.needed(fact.predicate) != 1 || is_of_nominal(fact)) return;
  if (new_neighbours_.give_to_neighbour(fact)) note_done(at);
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
  while (expanded < most && !offer_ && !facts_.must_stop()) {
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
    if (has_witness(at) || !expand_one(at)) continue;
    ++expanded;
    if (facts_.must_stop()) return expanded;
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
  if (witnesses_.satisfy(fact)) {
    note_done(at);
    return Way::satisfied;
  }
  if (new_neighbours_.may_share(fact)) {
    if (!may_offer) return Way::open;
    const auto choice = [&](ChoiceKind kind) { return Choice{kind, fact.predicate, fact.a, fact.a, at}; };
    offer_ = Decision{{choice(ChoiceKind::share_neighbours), choice(ChoiceKind::make_neighbours)}, fact.dependency, {}};
    return Way::open;
  }
  note_done(at);
  new_neighbours_.make(fact);
  return Way::expanded;
}

void Expansion::apply(const Choice& choice, DependencySet dependency) {
  const Fact fact = graph_.fact(existentials_[choice.bound].fact);
  note_done(choice.bound);
  if (choice.kind == ChoiceKind::share_neighbours) {
    new_neighbours_.share(fact, dependency);
  } else {
    new_neighbours_.make(fact);
  }
}

bool Expansion::has_witness(std::uint32_t at) {
  return denial_witnesses_.satisfy(graph_.fact(existentials_[at].fact), existentials_[at].witness);
}

bool Expansion::is_of_several(std::uint32_t at) const {
  const Fact& fact = graph_.fact(existentials_[at].fact);
  return program_.counts() && fact.kind == FactKind::at_least && program_.needed(fact.predicate) > 1;
}

// Each at-least is looked at once. Those of blocked nodes are left to expand(), and so are those of nodes that are
// deep: most of them are blocked as soon as their alternatives are chosen, and before that each would bring all
// neighbours that its properties with one value ask for, and theirs.
bool Expansion::expand_certain() {
  if (next_certain_ == existentials_.size()) return false;
  bool has_expanded = false;
  bool has_looked = false;
  while (next_certain_ < existentials_.size() && !has_expanded) {
    const std::uint32_t at = next_certain_++;
    const Fact fact = graph_.fact(existentials_[at].fact);
    if (existentials_[at].is_done || fact.kind != FactKind::at_least || !graph_.is_active(fact.a)) continue;
    const bool is_certain = program_.needed(fact.predicate) == 1 && is_of_nominal(fact);
    if (!is_certain && (graph_.node(fact.a).depth > deepest_certain || !new_neighbours_.is_functional(fact))) continue;
    if (!has_looked) blocking_.update();
    has_looked = true;
    has_expanded = !graph_.node(fact.a).is_blocked && expand_one(at);
  }
  return has_expanded;
}

bool Expansion::expand_one(std::uint32_t at) {
  const Fact fact = graph_.fact(existentials_[at].fact);
  if (!witnesses_.satisfy(fact) && needs_plain(fact)) {
    existentials_[at].plain = new_neighbours_.make_plain(fact);
    return true;
  }
  note_done(at);
  if (witnesses_.satisfy(fact)) return false;
  new_neighbours_.make(fact);
  return true;
}

// Most denials of a node hold of one neighbour of which nothing is said. So that one is made first, and the at-least
// stays open. If something comes to be forbidden of that neighbour, the at-least makes one with the filler.
bool Expansion::needs_plain(const Fact& fact) const {
  if (!denial_witnesses_.is_about_denial(fact) || new_neighbours_.is_functional(fact)) return false;
  const clauses::Role role = program_.at_least(fact.predicate).role;
  for (std::uint32_t at = newest_[fact.a]; at != none; at = existentials_[at].older) {
    const NodeId plain = existentials_[at].plain;
    if (plain >= graph_.node_count() || graph_.node(plain).parent != fact.a) continue;
    if (program_.at_least(graph_.fact(existentials_[at].fact).predicate).role == role) return false;
  }
  return true;
}

}  // namespace geminga::hypertableau
