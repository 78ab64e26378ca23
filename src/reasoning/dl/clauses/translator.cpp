// Puts each shape of literal into its place in a clause.
#include "reasoning/dl/clauses/translator.hpp"

#include <algorithm>
#include <ranges>
#include <utility>

#include "base/sorted.hpp"

namespace geminga::clauses {
namespace {

/// The most clauses that the unions in one body may become. Beyond it unions get names.
constexpr std::size_t max_split = 16;
/// The most neighbours in one clause, beside those of a number restriction.
constexpr std::size_t max_quantified = 2;
/// Parts may be shared, so that a small text is large when it is written out. Beyond these numbers of clauses of one
/// inclusion, and of literals of one clause, nested unions and conjunctions get names.
constexpr std::size_t max_copies = 4096;
constexpr std::size_t max_spread = 4096;

constexpr Atom concept_atom(ConceptId id, Variable at) { return {AtomKind::concept_of, at, centre, number(id)}; }

}  // namespace

void Translator::add(std::vector<Literal> disjunction) {
  Draft draft;
  for (const Literal literal : std::views::reverse(disjunction)) draft.waiting.push_back({literal, centre});
  add(std::move(draft));
}

void Translator::add(Draft draft) {
  spread(draft);
  if (draft.is_true) return;
  // A body with more than one neighbour would be matched in all combinations, so parts of it get names.
  std::vector<Literal> quantified = std::exchange(draft.quantified, {});
  const std::size_t count = quantified.size() + (draft.is_binary ? 1 : 0);
  if (count > 1) {
    std::erase_if(quantified, [&](Literal literal) {
      const ShapeKind kind = shape_of(source_, literal).kind;
      const bool is_number = kind == ShapeKind::at_most || kind == ShapeKind::data_at_most;
      if (is_positive(literal) && !is_number && count <= max_quantified) return false;
      put_name(draft, {literal, centre});
      return true;
    });
  }
  for (const Literal literal : quantified) {
    const Shape shape = shape_of(source_, literal);
    if (shape.kind == ShapeKind::every) {
      place_every(draft, role(shape.property), shape.filler);
    } else if (shape.kind == ShapeKind::at_most) {
      place_at_most(draft, shape);
    } else {
      place_data(draft, shape);
    }
  }
  spread(draft);
  split(std::move(draft));
}

void Translator::spread(Draft& draft) {
  while (!draft.waiting.empty() && !draft.is_true) {
    const Placed placed = draft.waiting.back();
    draft.waiting.pop_back();
    place(draft, placed);
  }
}

void Translator::place(Draft& draft, Placed placed) {
  Shape shape = shape_of(source_, placed.literal);
  switch (shape.kind) {
    case ShapeKind::truth:
      draft.is_true = true;
      return;
    case ShapeKind::falsity:
      return;
    case ShapeKind::atom:
    case ShapeKind::negated_atom:
      put_atom(draft, vocabulary_.concept_of(shape.term), placed.at, shape.kind == ShapeKind::negated_atom);
      return;
    case ShapeKind::any_of:
      if (draft.spread > max_spread) {
        put_name(draft, placed);
        return;
      }
      draft.spread += shape.operands.size();
      for (const Literal operand : std::views::reverse(shape.operands)) draft.waiting.push_back({operand, placed.at});
      return;
    case ShapeKind::all_of:
      draft.conjunctions.push_back(placed);
      return;
    default:
      if (placed.at == centre) {
        place_at_centre(draft, placed.literal, std::move(shape));
      } else {
        put_name(draft, placed);
      }
  }
}

void Translator::place_at_centre(Draft& draft, Literal literal, Shape&& shape) {
  switch (shape.kind) {
    case ShapeKind::some:
    case ShapeKind::at_least:
      place_at_least(draft, shape);
      return;
    case ShapeKind::data_some:
    case ShapeKind::data_at_least: {
      const DataRangeId range = vocabulary_.data_range(shape.range);
      if (range == DataRangeId{1}) return;
      const DataAtLeast at_least{shape.count, vocabulary_.data_property(shape.property), range};
      draft.clause.head.push_back({AtomKind::data_at_least, centre, centre, vocabulary_.index(at_least)});
      return;
    }
    case ShapeKind::self:
      draft.clause.head.push_back(role_atom(role(shape.property), centre, centre));
      return;
    case ShapeKind::not_self:
      draft.clause.body.push_back(role_atom(role(shape.property), centre, centre));
      return;
    case ShapeKind::every:
      if (shape_of(source_, shape.filler).kind == ShapeKind::truth) {
        draft.is_true = true;
      } else if (const Role along = role(shape.property); roles_.is_simple(along)) {
        draft.quantified.push_back(literal);
      } else {
        const auto [id, is_positive] = path(along, shape.filler);
        put_atom(draft, id, centre, !is_positive);
      }
      return;
    default:
      draft.quantified.push_back(literal);
  }
}

void Translator::place_at_least(Draft& draft, const Shape& shape) {
  if (shape_of(source_, shape.filler).kind == ShapeKind::falsity) return;
  const AtLeast at_least{shape.count, role(shape.property), below(shape.filler)};
  draft.clause.head.push_back({AtomKind::at_least, centre, centre, vocabulary_.index(at_least)});
}

void Translator::place_every(Draft& draft, Role role, Literal filler) {
  const Variable neighbour = draft.variables++;
  draft.clause.body.push_back(role_atom(role, centre, neighbour));
  draft.waiting.push_back({filler, neighbour});
}

void Translator::place_at_most(Draft& draft, const Shape& shape) {
  const Role along = role(shape.property);
  const ShapeKind filler = shape_of(source_, shape.filler).kind;
  if (filler == ShapeKind::falsity) {
    draft.is_true = true;
    return;
  }
  if (shape.count > inline_at_most) {
    const AtMost at_most{shape.count, along, above(shape.filler)};
    draft.clause.head.push_back({AtomKind::at_most, centre, centre, vocabulary_.index(at_most)});
    return;
  }
  const Variable first = draft.variables;
  const bool is_negated = filler == ShapeKind::negated_atom;
  const ConceptId id = is_negated ? below(complement(shape.filler)) : above(shape.filler);
  for (std::uint32_t at = 0; at <= shape.count; ++at) {
    const Variable neighbour = draft.variables++;
    draft.clause.body.push_back(role_atom(along, centre, neighbour));
    put_atom(draft, id, neighbour, !is_negated);
    for (Variable other = first; other < neighbour; ++other) {
      draft.clause.head.push_back({AtomKind::equal, other, neighbour, 0});
    }
  }
}

void Translator::place_data(Draft& draft, const Shape& shape) {
  const DataPropertyId property = vocabulary_.data_property(shape.property);
  const auto put = [&](Variable value, const DataRange& range) {
    draft.clause.body.push_back({AtomKind::data_role, centre, value, number(property)});
    const DataRangeId id = vocabulary_.data_range(range);
    if (id == DataRangeId{0}) draft.is_true = true;
    if (number(id) > 1) draft.clause.head.push_back({AtomKind::data_range, value, centre, number(id)});
  };
  if (shape.kind == ShapeKind::data_every) {
    put(draft.variables++, shape.range);
    return;
  }
  DataRange outside = shape.range;
  outside.is_complement = !outside.is_complement;
  if (shape.count > inline_at_most) {
    const DataRangeId counted = vocabulary_.data_range(shape.range);
    const DataAtMost at_most{shape.count, property, counted, vocabulary_.data_range(outside)};
    draft.clause.head.push_back({AtomKind::data_at_most, centre, centre, vocabulary_.index(at_most)});
    return;
  }
  const Variable first = draft.variables;
  for (std::uint32_t at = 0; at <= shape.count; ++at) {
    const Variable value = draft.variables++;
    put(value, outside);
    for (Variable other = first; other < value; ++other) {
      draft.clause.head.push_back({AtomKind::data_equal, other, value, 0});
    }
  }
}

void Translator::put_atom(Draft& draft, ConceptId of, Variable at, bool is_negated) const {
  if (is_negated) {
    if (of == nothing) draft.is_true = true;
    if (of != thing) draft.clause.body.push_back(concept_atom(of, at));
  } else {
    if (of == thing) draft.is_true = true;
    if (of != nothing) draft.clause.head.push_back(concept_atom(of, at));
  }
}

void Translator::put_name(Draft& draft, Placed placed) {
  if (is_positive(placed.literal)) {
    put_atom(draft, below(placed.literal), placed.at, false);
  } else {
    put_atom(draft, above(complement(placed.literal)), placed.at, true);
  }
}

void Translator::split(Draft draft) {
  if (draft.is_true) return;
  // B -> (C and D) is two clauses, and so is (B or C) -> D. Beside other literals in the head a conjunction gets a
  // name.
  std::size_t product = draft.copies;
  std::size_t positive = 0;
  for (const Placed& placed : draft.conjunctions) {
    if (is_positive(placed.literal)) ++positive;
    product = std::min(product * shape_of(source_, placed.literal).operands.size(), max_copies);
  }
  const bool names_positive =
      positive > 1 || (positive == 1 && !draft.clause.head.empty()) || draft.copies >= max_copies;
  const bool names_negative = product > max_split && (draft.conjunctions.size() > 1 || draft.copies > 1);
  std::erase_if(draft.conjunctions, [&](const Placed& placed) {
    const bool is_named = is_positive(placed.literal) ? names_positive : names_negative;
    if (is_named) put_name(draft, placed);
    return is_named;
  });
  if (draft.conjunctions.empty()) {
    finish(std::move(draft));
    return;
  }
  const Placed last = draft.conjunctions.back();
  draft.conjunctions.pop_back();
  const bool is_binary = draft.is_binary || draft.variables > 1;
  const std::vector<Literal> operands = shape_of(source_, last.literal).operands;
  for (const Literal operand : operands) {
    Draft copy = draft;
    copy.is_binary = is_binary;
    copy.copies = std::min(draft.copies * operands.size(), max_copies);
    copy.waiting.push_back({operand, last.at});
    add(std::move(copy));
  }
}

void Translator::finish(Draft draft) {
  if (!draft.is_true) add_clause(std::move(draft.clause));
}

void Translator::add_clause(Clause clause) {
  base::sort_unique(clause.body);
  base::sort_unique(clause.head);
  const bool is_tautology = std::ranges::any_of(clause.head, [&](const Atom& atom) {
    return std::ranges::binary_search(clause.body, atom) ||
           (atom.kind == AtomKind::concept_of && atom.predicate == number(thing));
  });
  if (!is_tautology && !is_full()) set_.clauses.push_back(std::move(clause));
}

Atom Translator::role_atom(Role role, Variable from, Variable to) const {
  const Role along = roles_.canonical(role);
  if (along.is_inverse) std::swap(from, to);
  return {AtomKind::role, from, to, number(along.property)};
}

}  // namespace geminga::clauses
