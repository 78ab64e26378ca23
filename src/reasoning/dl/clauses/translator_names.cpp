// The names of parts and of the states of automata, and their definitions.
#include <algorithm>
#include <utility>

#include "reasoning/dl/clauses/translator.hpp"

namespace geminga::clauses {

Translator::Key Translator::key_of(Literal literal) const {
  while (source_.kind(literal.term) == owl::TermKind::object_complement_of) {
    literal = {source_.term(literal.term).arguments[0], !literal.is_negated, Part::whole};
  }
  return {vocabulary_.hashes().hash_of(literal.term), literal.is_negated, literal.part};
}

bool Translator::is_positive(Literal literal) {
  const Key key = key_of(literal);
  if (const auto found = is_positive_.find(key); found != is_positive_.end()) return found->second;
  const bool result = is_positive_shape(shape_of(source_, literal));
  is_positive_.emplace(key, result);
  return result;
}

bool Translator::is_positive_shape(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::all_of:
    case ShapeKind::any_of:
      return std::ranges::any_of(shape.operands, [&](Literal operand) { return is_positive(operand); });
    case ShapeKind::every:
      return is_positive(shape.filler);
    case ShapeKind::data_every:
      return !shape.range.is_complement;
    case ShapeKind::negated_atom:
    case ShapeKind::not_self:
    case ShapeKind::falsity:
      return false;
    default:
      return true;
  }
}

Translator::Name& Translator::name_of(Literal literal) {
  const auto [found, is_new] = names_.try_emplace(key_of(literal));
  if (is_new) {
    found->second.id = vocabulary_.auxiliary(literal.term);
    found->second.literal = literal;
  }
  return found->second;
}

ConceptId Translator::below(Literal literal) {
  const Shape shape = shape_of(source_, literal);
  if (shape.kind == ShapeKind::truth) return thing;
  if (shape.kind == ShapeKind::falsity) return nothing;
  if (shape.kind == ShapeKind::atom) return vocabulary_.concept_of(shape.term);
  Name& name = name_of(literal);
  if (!std::exchange(name.is_defined_below, true)) definitions_.push_back({name.id, name.literal, false});
  return name.id;
}

ConceptId Translator::above(Literal literal) {
  const Shape shape = shape_of(source_, literal);
  if (shape.kind == ShapeKind::truth) return thing;
  if (shape.kind == ShapeKind::falsity) return nothing;
  if (shape.kind == ShapeKind::atom) return vocabulary_.concept_of(shape.term);
  Name& name = name_of(literal);
  if (!std::exchange(name.is_defined_above, true)) definitions_.push_back({name.id, name.literal, true});
  return name.id;
}

Draft Translator::clause_of(const Definition& definition) {
  const bool is_above = definition.is_above;
  Draft draft;
  (is_above ? draft.clause.head : draft.clause.body)
      .push_back({AtomKind::concept_of, centre, centre, number(definition.id)});
  draft.waiting.push_back({is_above ? complement(definition.literal) : definition.literal, centre});
  return draft;
}

void Translator::define_names() {
  for (std::size_t at = 0; at < definitions_.size() && !is_full(); ++at) {
    const Definition definition = definitions_[at];
    add(clause_of(definition));
  }
}

void Translator::add_every(Role role, Literal filler, Literal literal) {
  role = roles_.canonical(role);
  if (!roles_.is_simple(role) && shape_of(source_, literal).kind == ShapeKind::all_of) {
    const std::vector<Literal> operands = shape_of(source_, literal).operands;
    for (const Literal operand : operands) add_every(role, filler, operand);
    return;
  }
  Draft draft;
  const bool is_empty = shape_of(source_, filler).kind == ShapeKind::falsity;
  if (roles_.is_simple(role) || (is_empty && begins_in(role, literal))) {
    place_every(draft, role, filler);
    draft.is_binary = true;
  } else {
    const auto [id, is_positive] = path(role, filler);
    put_atom(draft, id, centre, !is_positive);
  }
  draft.waiting.push_back({literal, centre});
  add(std::move(draft));
}

bool Translator::begins_in(Role role, Literal literal) {
  const Shape shape = shape_of(source_, literal);
  const owl::Automaton& automaton = roles_.automaton(role);
  if (shape.kind != ShapeKind::atom || automaton.is_final(owl::Automaton::begin)) return false;
  // The edges of the role itself have a clause in any case.
  return std::ranges::all_of(automaton.moves(), [&](const owl::Automaton::Move& move) {
    return move.from != owl::Automaton::begin || move.label == role || ends_.begins_in(move.label, shape.term);
  });
}

bool Translator::ends_in(Role role, Literal literal) {
  const Shape shape = shape_of(source_, literal);
  const owl::Automaton& automaton = roles_.automaton(role);
  if (shape.kind != ShapeKind::atom || automaton.is_final(owl::Automaton::begin)) return false;
  return std::ranges::all_of(automaton.moves(), [&](const owl::Automaton::Move& move) {
    return !automaton.is_final(move.to) || ends_.ends_in(move.label, shape.term);
  });
}

std::pair<ConceptId, bool> Translator::path(Role role, Literal filler) {
  // Forwards, if the filler goes into the head: Q is below every R.F and travels along the path to F. Backwards, if it
  // goes into the body: Q is above some R.G with G = not F, and travels from G to the beginning of the path.
  const bool is_forward = is_positive(filler);
  // Some R.G is some R.T, if G is a range of R.
  if (!is_forward && ends_in(role, complement(filler))) filler = bottom;
  const Literal named = is_forward ? filler : complement(filler);
  const auto [found, is_new] = paths_.try_emplace({role, key_of(named), is_forward});
  if (!is_new) return {found->second, is_forward};
  const owl::Automaton& automaton = roles_.automaton(role);
  const bool is_everything = !is_forward && shape_of(source_, named).kind == ShapeKind::truth;
  std::vector<ConceptId> states;
  for (owl::Automaton::State state = 0; state < automaton.state_count(); ++state) {
    const bool needs_no_name =
        state != owl::Automaton::begin && automaton.is_final(state) && (is_everything || automaton.is_dead_end(state));
    states.push_back(needs_no_name ? thing : vocabulary_.auxiliary(filler.term));
  }
  found->second = states[owl::Automaton::begin];
  const ConceptId first = found->second;
  add_moves(automaton, states, filler, is_forward);
  return {first, is_forward};
}

void Translator::add_moves(const owl::Automaton& automaton, const std::vector<ConceptId>& states, Literal filler,
                           bool is_forward) {
  //   forwards:   Qp(x), S(x,y) -> Qq(y)      Qf -> F        where F is the filler
  //   backwards:  S(x,y), Qq(y) -> Qp(x)      G -> Qf        where G is its complement
  // A final state without further moves has no name: it is the filler itself.
  const auto leads_to_thing = [&](const owl::Automaton::Move& other) {
    return automaton.is_final(other.to) && states[other.to] == thing && !is_forward &&
           shape_of(source_, filler).kind == ShapeKind::falsity;
  };
  for (const owl::Automaton::Move& move : automaton.moves()) {
    const auto is_shorter = [&](const owl::Automaton::Move& other) {
      return other.from == move.from && other.label == move.label && leads_to_thing(other);
    };
    if (states[move.from] == thing) continue;
    if (!leads_to_thing(move) && std::ranges::any_of(automaton.moves(), is_shorter)) continue;
    Draft draft;
    draft.variables = 2;
    draft.is_binary = true;
    draft.clause.body.push_back(role_atom(move.label, centre, 1));
    put_atom(draft, states[move.from], centre, is_forward);
    if (automaton.is_final(move.to) && automaton.is_dead_end(move.to)) {
      draft.waiting.push_back({filler, 1});
    } else if (states[move.to] != thing) {
      put_atom(draft, states[move.to], 1, !is_forward);
    }
    add(std::move(draft));
  }
  for (owl::Automaton::State state = 0; state < automaton.state_count(); ++state) {
    if (!automaton.is_final(state) || states[state] == thing) continue;
    Draft draft;
    put_atom(draft, states[state], centre, is_forward);
    draft.waiting.push_back({filler, centre});
    add(std::move(draft));
  }
}

}  // namespace geminga::clauses
