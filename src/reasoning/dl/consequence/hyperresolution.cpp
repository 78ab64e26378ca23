#include "reasoning/dl/consequence/hyperresolution.hpp"

namespace geminga::consequence {
namespace {

/// No term of a context: the variable is not bound yet.
constexpr Term unbound{0xffffffffU};

}  // namespace

void Hyperresolution::fire(const Rule& rule, MatchedContext context) {
  premises_.clear();
  binding_.assign(1, x_term);
  conclude(rule, context.store);
}

void Hyperresolution::apply(Premise premise, const Occurrence& occurrence, Term neighbour, MatchedContext context) {
  const Rule& rule = rules_.rule(occurrence.rule);
  const std::uint8_t bound = rule.body[occurrence.atom].first;
  // Most rules have an atom in their body that nothing matches.
  for (std::size_t at = 0; at < rule.body.size(); ++at) {
    const std::uint8_t variable = rule.body[at].first;
    if (at == occurrence.atom) continue;
    const Term term = variable == 0 ? x_term : variable == bound ? neighbour : unbound;
    if (!may_hold(rule.body[at], term, context.store)) return effort_.count_attempt();
  }
  binding_.assign(rule.neighbours + std::size_t{1}, unbound);
  binding_[0] = x_term;
  binding_[bound] = neighbour;
  premises_.assign(1, premise);
  if (rule.body.size() == 1) {
    effort_.count_attempt();
    if (!effort_.is_stopped()) conclude(rule, context.store);
    return;
  }
  is_done_.assign(rule.body.size(), 0);
  is_done_[occurrence.atom] = 1;
  join(rule, context);
}

bool Hyperresolution::may_hold(const RuleAtom& atom, Term term, const ClauseStore& store) {
  const bool is_incoming = atom.kind == LiteralKind::incoming;
  if (term == unbound) return store.may_match(neighbours(atom.predicate, is_incoming));
  if (atom.kind == LiteralKind::unary) return store.may_match(unary(atom.predicate, term));
  return store.may_match(binary(atom.predicate, term, is_incoming));
}

void Hyperresolution::join(const Rule& rule, MatchedContext context) {
  effort_.count_attempt();
  if (effort_.is_stopped()) return;
  if (rule.head.size() > 1 && !conclusions_.may_match_alternatives(context.store)) return;
  // Atoms that can be looked up come first, then neighbours are tried.
  std::size_t open = rule.body.size();
  for (std::size_t at = 0; at < rule.body.size(); ++at) {
    if (is_done_[at] != 0) continue;
    const RuleAtom& atom = rule.body[at];
    const Term term = binding_[atom.first];
    if (atom.kind == LiteralKind::unary) return join_with(rule, at, unary(atom.predicate, term), context);
    if (term != unbound) {
      return join_with(rule, at, binary(atom.predicate, term, atom.kind == LiteralKind::incoming), context);
    }
    if (open == rule.body.size()) open = at;
  }
  if (open == rule.body.size()) return conclude(rule, context.store);
  const RuleAtom& atom = rule.body[open];
  const bool is_incoming = atom.kind == LiteralKind::incoming;
  const auto* const found = context.store.lists(neighbours(atom.predicate, is_incoming));
  if (found == nullptr) return;
  for (const std::uint32_t number : found->maximal) {
    const Term term{number};
    if (!may_bind(rule, atom.first, term, context)) continue;
    binding_[atom.first] = term;
    join_with(rule, open, binary(atom.predicate, term, is_incoming), context);
    binding_[atom.first] = unbound;
  }
}

bool Hyperresolution::may_bind(const Rule& rule, std::uint8_t variable, Term term, MatchedContext context) const {
  if (is_successor(term) && context.successors.is_replaced(context.store, term)) return false;
  if (!rule.is_ordered) return true;
  for (std::uint8_t other = 1; other <= rule.neighbours; ++other) {
    if (binding_[other] == unbound || other == variable) continue;
    if (other < variable ? binding_[other] >= term : binding_[other] <= term) return false;
  }
  return true;
}

void Hyperresolution::join_with(const Rule& rule, std::size_t atom, Literal literal, MatchedContext context) {
  is_done_[atom] = 1;
  for_each_premise(context.store, literal, [&](Premise premise) {
    premises_.push_back(premise);
    join(rule, context);
    premises_.pop_back();
  });
  is_done_[atom] = 0;
}

void Hyperresolution::conclude(const Rule& rule, ClauseStore& store) {
  head_.clear();
  for (const RuleAtom& atom : rule.head) {
    const Term term = binding_[atom.first];
    switch (atom.kind) {
      case LiteralKind::equal:
      case LiteralKind::different:
        if (term == binding_[atom.second]) return;
        head_.push_back(equality(term, binding_[atom.second], false));
        break;
      case LiteralKind::unary:
        head_.push_back(unary(atom.predicate, term));
        break;
      case LiteralKind::reflexive:
        head_.push_back(make_literal(LiteralKind::reflexive, term, atom.predicate));
        break;
      default:
        head_.push_back(binary(atom.predicate, term, atom.kind == LiteralKind::incoming));
    }
  }
  conclusions_.begin();
  for (const Premise premise : premises_) conclusions_.add_side(store, premise);
  conclusions_.finish(store, head_);
}

void Hyperresolution::expand(Premise premise, const Expansion& expansion, ClauseStore& store) {
  for (std::uint32_t i = 0; i < expansion.count; ++i) {
    const Term f = successor(expansion.first_function + i);
    for (const RuleAtom& atom : expansion.atoms) {
      conclusions_.conclude(store, premise,
                            atom.kind == LiteralKind::unary
                                ? unary(atom.predicate, f)
                                : binary(atom.predicate, f, atom.kind == LiteralKind::incoming));
    }
  }
}

}  // namespace geminga::consequence
