// Hyperresolution: a rule of the ontology fires if each atom of its body is maximal in some clause.
//
//  A1 and ... and An -> D in O    Gi -> Di v [Ai s] for each i
//  ----------------------------------------------------------- Hyper [s(x) = x]
//  G1 and ... and Gn -> D1 v ... v Dn v D s
#include <utility>

#include "reasoning/dl/consequence/saturation.hpp"
#include "reasoning/dl/consequence/worker.hpp"

namespace geminga::consequence {
namespace {

/// No term of a context: the variable is not bound yet.
constexpr Term unbound{0xffffffffU};

}  // namespace

void Worker::hyper(Premise premise, const Occurrence& occurrence, Term neighbour) {
  const Rule& rule = rules_.rule(occurrence.rule);
  const std::uint8_t bound = rule.body[occurrence.atom].first;
  // Most rules have an atom in their body that nothing matches.
  for (std::size_t at = 0; at < rule.body.size(); ++at) {
    const std::uint8_t variable = rule.body[at].first;
    if (at == occurrence.atom) continue;
    if (!may_hold(rule.body[at], variable == 0 ? x_term : variable == bound ? neighbour : unbound)) {
      return count_attempt();
    }
  }
  binding_.assign(rule.neighbours + std::size_t{1}, unbound);
  binding_[0] = x_term;
  binding_[bound] = neighbour;
  premises_.assign(1, premise);
  if (rule.body.size() == 1) {
    count_attempt();
    if (!is_stopped_) conclude_rule(rule);
    return;
  }
  is_done_.assign(rule.body.size(), 0);
  is_done_[occurrence.atom] = 1;
  join(rule);
}

bool Worker::may_hold(const RuleAtom& atom, Term term) const {
  const bool is_incoming = atom.kind == LiteralKind::incoming;
  if (term == unbound) return context_->store.may_match(neighbours(atom.predicate, is_incoming));
  if (atom.kind == LiteralKind::unary) return context_->store.may_match(unary(atom.predicate, term));
  return context_->store.may_match(binary(atom.predicate, term, is_incoming));
}

void Worker::count_attempts(std::size_t attempts) {
  attempts_ += attempts;
  if (attempts_ < attempts_at_once) return;
  if (!saturation_.count_attempts(std::exchange(attempts_, 0))) is_stopped_ = true;
}

void Worker::join(const Rule& rule) {
  count_attempt();
  if (is_stopped_) return;
  // Atoms that can be looked up come first, then neighbours are tried.
  std::size_t open = rule.body.size();
  for (std::size_t at = 0; at < rule.body.size(); ++at) {
    if (is_done_[at] != 0) continue;
    const RuleAtom& atom = rule.body[at];
    const Term term = binding_[atom.first];
    if (atom.kind == LiteralKind::unary) return join_with(rule, at, unary(atom.predicate, term));
    if (term != unbound) {
      return join_with(rule, at, binary(atom.predicate, term, atom.kind == LiteralKind::incoming));
    }
    if (open == rule.body.size()) open = at;
  }
  if (open == rule.body.size()) return conclude_rule(rule);
  const RuleAtom& atom = rule.body[open];
  const bool is_incoming = atom.kind == LiteralKind::incoming;
  const auto* const found = context_->store.lists(neighbours(atom.predicate, is_incoming));
  if (found == nullptr) return;
  for (const std::uint32_t number : found->maximal) {
    const Term term{number};
    if (!may_bind(rule, atom.first, term)) continue;
    binding_[atom.first] = term;
    join_with(rule, open, binary(atom.predicate, term, is_incoming));
    binding_[atom.first] = unbound;
  }
}

bool Worker::may_bind(const Rule& rule, std::uint8_t variable, Term term) const {
  if (is_successor(term) && is_replaced(term)) return false;
  if (!rule.is_ordered) return true;
  for (std::uint8_t other = 1; other <= rule.neighbours; ++other) {
    if (binding_[other] == unbound || other == variable) continue;
    if (other < variable ? binding_[other] >= term : binding_[other] <= term) return false;
  }
  return true;
}

void Worker::join_with(const Rule& rule, std::size_t atom, Literal literal) {
  const ClauseStore& store = context_->store;
  is_done_[atom] = 1;
  const ClauseStore::Found found = store.look_up(literal);
  if (found.is_unit) {
    premises_.push_back({no_clause, literal});
    join(rule);
    premises_.pop_back();
  } else if (found.lists != nullptr) {
    for (const ClauseNumber clause : found.lists->maximal) {
      if (!store.is_active(clause)) continue;
      premises_.push_back({clause, literal});
      join(rule);
      premises_.pop_back();
    }
  }
  is_done_[atom] = 0;
}

void Worker::conclude_rule(const Rule& rule) {
  body_.clear();
  for (const RuleAtom& atom : rule.head) {
    const Term term = binding_[atom.first];
    switch (atom.kind) {
      case LiteralKind::equal:
      case LiteralKind::different:
        if (term == binding_[atom.second]) return;
        body_.push_back(equality(term, binding_[atom.second], false));
        break;
      case LiteralKind::unary:
        body_.push_back(unary(atom.predicate, term));
        break;
      case LiteralKind::reflexive:
        body_.push_back(make_literal(LiteralKind::reflexive, term, atom.predicate));
        break;
      default:
        body_.push_back(binary(atom.predicate, term, atom.kind == LiteralKind::incoming));
    }
  }
  begin_conclusion();
  for (const Premise premise : premises_) add_side(premise);
  end_conclusion(body_);
}

//  G -> D v [(>= n R.B)(x)]
//  ----------------------------------------------------------------------
//  G -> D v R(x, fi(x))   G -> D v B(fi(x))   for n functions f1 ... fn of its own
//
// simplify_head() and apply_equality() know that fi(x) and fj(x) are different.
void Worker::expand(Premise premise, const Expansion& expansion) {
  for (std::uint32_t i = 0; i < expansion.count; ++i) {
    const Term f = successor(expansion.first_function + i);
    for (const RuleAtom& atom : expansion.atoms) {
      conclude(premise, atom.kind == LiteralKind::unary
                            ? unary(atom.predicate, f)
                            : binary(atom.predicate, f, atom.kind == LiteralKind::incoming));
    }
  }
}

}  // namespace geminga::consequence
