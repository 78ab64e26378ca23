// The equivalences of negation normal form.
#include "reasoning/dl/clauses/literal.hpp"

#include "reasoning/owl/datatypes.hpp"

namespace geminga::clauses {
namespace {

using owl::TermKind;

Shape constant(bool is_true) {
  Shape shape;
  shape.kind = is_true ? ShapeKind::truth : ShapeKind::falsity;
  return shape;
}

/// (>= n R.C) or, negated, (<= n-1 R.C).
Shape at_least(const owl::Ontology& source, const owl::Term& term, std::uint32_t count, bool is_negated, bool is_data) {
  if (count == 0) return constant(!is_negated);
  Shape shape;
  shape.property = term.arguments[0];
  shape.count = is_negated ? count - 1 : count;
  const bool is_qualified = term.arguments.size() > 1;
  const bool is_universal = is_negated && count == 1;  // at most none in C: all in not C
  if (is_data) {
    shape.range = is_qualified ? range_of(source, term.arguments[1], is_universal) : DataRange{no_term, is_universal};
    if (is_negated) {
      shape.kind = is_universal ? ShapeKind::data_every : ShapeKind::data_at_most;
    } else {
      shape.kind = count == 1 ? ShapeKind::data_some : ShapeKind::data_at_least;
    }
    return shape;
  }
  shape.filler = is_qualified ? Literal{term.arguments[1], is_universal, Part::whole} : (is_universal ? bottom : top);
  if (is_negated) {
    shape.kind = is_universal ? ShapeKind::every : ShapeKind::at_most;
  } else {
    shape.kind = count == 1 ? ShapeKind::some : ShapeKind::at_least;
  }
  return shape;
}

/// (<= n R.C) is not (>= n+1 R.C).
Shape at_most(const owl::Ontology& source, const owl::Term& term, bool is_negated, bool is_data) {
  if (term.number == 0xffffffffU) return constant(!is_negated);
  return at_least(source, term, term.number + 1, !is_negated, is_data);
}

Shape exactly(const owl::Ontology& source, const owl::Term& term, Literal literal, bool is_data) {
  if (literal.part == Part::minimum) return at_least(source, term, term.number, literal.is_negated, is_data);
  if (literal.part == Part::maximum || term.number == 0) return at_most(source, term, literal.is_negated, is_data);
  Shape shape;
  shape.kind = literal.is_negated ? ShapeKind::any_of : ShapeKind::all_of;
  shape.operands = {{literal.term, literal.is_negated, Part::minimum},
                    {literal.term, literal.is_negated, Part::maximum}};
  return shape;
}

/// Intersections, and unions as their duals.
Shape set_of(const owl::Term& term, bool is_intersection, bool is_negated) {
  Shape shape;
  shape.kind = is_intersection != is_negated ? ShapeKind::all_of : ShapeKind::any_of;
  for (const owl::TermId argument : term.arguments) shape.operands.push_back({argument, is_negated, Part::whole});
  if (!shape.operands.empty()) return shape;
  return constant(shape.kind == ShapeKind::all_of);
}

Shape quantified(ShapeKind kind, owl::TermId property, Literal filler) {
  Shape shape;
  shape.kind = kind;
  shape.property = property;
  shape.filler = filler;
  return shape;
}
Shape quantified(ShapeKind kind, owl::TermId property, DataRange range) {
  Shape shape;
  shape.kind = kind;
  shape.property = property;
  shape.range = range;
  return shape;
}

}  // namespace

DataRange range_of(const owl::Ontology& source, owl::TermId term, bool is_complement) {
  while (source.kind(term) == TermKind::data_complement_of) {
    term = source.term(term).arguments[0];
    is_complement = !is_complement;
  }
  if (source.kind(term) == TermKind::datatype && source.name_of(term) == owl::rdfs_literal) term = no_term;
  return {term, is_complement};
}

Shape shape_of(const owl::Ontology& source, Literal literal) {
  while (source.kind(literal.term) == TermKind::object_complement_of) {
    literal = {source.term(literal.term).arguments[0], !literal.is_negated, Part::whole};
  }
  const owl::Term term = source.term(literal.term);
  const bool is_negated = literal.is_negated;
  const ShapeKind some = is_negated ? ShapeKind::every : ShapeKind::some;
  const ShapeKind every = is_negated ? ShapeKind::some : ShapeKind::every;
  const ShapeKind data_some = is_negated ? ShapeKind::data_every : ShapeKind::data_some;
  const ShapeKind data_every = is_negated ? ShapeKind::data_some : ShapeKind::data_every;
  switch (term.kind) {
    case TermKind::object_intersection_of:
      return set_of(term, true, is_negated);
    case TermKind::object_union_of:
    case TermKind::object_one_of:
      return set_of(term, false, is_negated);
    case TermKind::object_some_values_from:
    case TermKind::object_has_value:
      return quantified(some, term.arguments[0], Literal{term.arguments[1], is_negated, Part::whole});
    case TermKind::object_all_values_from:
      return quantified(every, term.arguments[0], Literal{term.arguments[1], is_negated, Part::whole});
    case TermKind::object_has_self:
      return quantified(is_negated ? ShapeKind::not_self : ShapeKind::self, term.arguments[0], top);
    case TermKind::object_min_cardinality:
      return at_least(source, term, term.number, is_negated, false);
    case TermKind::object_max_cardinality:
      return at_most(source, term, is_negated, false);
    case TermKind::object_exact_cardinality:
      return exactly(source, term, literal, false);
    case TermKind::data_some_values_from:
    case TermKind::data_has_value:
      return quantified(data_some, term.arguments[0], range_of(source, term.arguments[1], is_negated));
    case TermKind::data_all_values_from:
      return quantified(data_every, term.arguments[0], range_of(source, term.arguments[1], is_negated));
    case TermKind::data_min_cardinality:
      return at_least(source, term, term.number, is_negated, true);
    case TermKind::data_max_cardinality:
      return at_most(source, term, is_negated, true);
    case TermKind::data_exact_cardinality:
      return exactly(source, term, literal, true);
    default:
      break;
  }
  if (literal.term == owl::thing_term) return constant(!is_negated);
  if (literal.term == owl::nothing_term) return constant(is_negated);
  Shape shape;
  shape.kind = is_negated ? ShapeKind::negated_atom : ShapeKind::atom;
  shape.term = literal.term;
  return shape;
}

}  // namespace geminga::clauses
