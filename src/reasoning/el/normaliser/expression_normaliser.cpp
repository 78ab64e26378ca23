// Each kind of expression, left of SubClassOf and right of it. Legend as in expression_normaliser.hpp.
#include "reasoning/el/normaliser/expression_normaliser.hpp"

#include <algorithm>
#include <utility>

namespace geminga::el {

ExpressionNormaliser::ExpressionNormaliser(const owl::Ontology& source, IndexBuilder& index, TermExpressions& terms,
                                           DataNormaliser& data, UniversalNormaliser& universals, PendingUses& pending,
                                           OpenParts& open)
    : source_(source),
      index_(index),
      terms_(terms),
      data_(data),
      universals_(universals),
      pending_(pending),
      open_(open),
      left_(source.term_count(), 0),
      right_(source.term_count(), 0) {}

owl::Construct ExpressionNormaliser::use(owl::TermId id, Side side) {
  std::uint8_t& known = (side == Side::right ? right_ : left_)[static_cast<std::size_t>(id)];
  if (known == 0) {
    const std::size_t begin = pending_.all().size();
    const owl::Construct unused = side == Side::right ? make_right(id) : make_left(id);
    known = static_cast<std::uint8_t>(1 + static_cast<int>(unused));
    pending_.keep(id, side, begin);
  } else {
    pending_.repeat(id, side);
  }
  return static_cast<owl::Construct>(known - 1);
}

owl::Construct ExpressionNormaliser::use_all_right(std::span<const owl::TermId> terms) {
  owl::Construct unused = owl::Construct::none;
  for (const owl::TermId term : terms) unused = first_unused(unused, use_right(term));
  return unused;
}

owl::Construct ExpressionNormaliser::use_filler(const owl::Term& term, Side side) {
  return TermExpressions::is_qualified(term) ? use(term.arguments[1], side) : owl::Construct::none;
}

ExprId ExpressionNormaliser::recognised_some(const Property& property, ExprId filler) {
  const ExprId some = index_.existential(property.role, filler);
  index_.mark_negative(some);
  return some;
}

void ExpressionNormaliser::exclude(ExprId one, ExprId other) {
  const ExprId clash = index_.conjunction({one, other});
  index_.mark_negative(clash);
  index_.add_told(clash, bottom_expr);
}

owl::Construct ExpressionNormaliser::make_left(owl::TermId id) {
  const owl::Term term = source_.term(id);
  const ExprId expr = terms_.expression(id);
  // A term that equals T or F is exact, whichever constructs it has.
  if (expr == top_expr || expr == bottom_expr) return owl::Construct::none;
  owl::Construct unused = owl::Construct::none;
  switch (term.kind) {
    case owl::TermKind::named_class:
    case owl::TermKind::individual:
    case owl::TermKind::anonymous_individual:
      return owl::Construct::none;
    case owl::TermKind::datatype:
      data_.note_wanted_datatype(term);
      return owl::Construct::none;
    case owl::TermKind::literal:
      data_.note_wanted_literal(id);
      return owl::Construct::none;
    case owl::TermKind::object_intersection_of:
    case owl::TermKind::data_intersection_of:
      for (const owl::TermId part : term.arguments) unused = first_unused(unused, use_left(part));
      index_.mark_negative(expr);
      return unused;
    case owl::TermKind::object_union_of:
    case owl::TermKind::data_union_of:
    case owl::TermKind::object_one_of:
    case owl::TermKind::data_one_of:
      //  C or D < E  is  C < X, D < X, X < E
      for (const owl::TermId part : term.arguments) {
        unused = first_unused(unused, use_left(part));
        index_.add_told(terms_.expression(part), expr);
      }
      return unused;
    case owl::TermKind::object_complement_of:
      return source_.kind(term.arguments[0]) == term.kind ? use_left(source_.term(term.arguments[0]).arguments[0])
                                                          : open_.beyond(owl::Construct::complement_of);
    case owl::TermKind::data_complement_of:
      return open_.beyond(owl::Construct::datatype_complement);
    case owl::TermKind::datatype_restriction:
      return open_.beyond(owl::Construct::datatype_restriction);
    default:
      return make_left_restriction(term, expr);
  }
}

owl::Construct ExpressionNormaliser::make_left_restriction(const owl::Term& term, ExprId expr) {
  const Property role = terms_.property(term.arguments[0]);
  if (role.is_top) return open_.beyond(owl::Construct::top_property);
  switch (term.kind) {
    case owl::TermKind::object_has_self:
      pending_.note(SimpleUse{role.role, owl::Construct::self_not_simple});
      index_.mark_negative(expr);
      return owl::Construct::none;
    case owl::TermKind::object_all_values_from:
    case owl::TermKind::data_all_values_from:
      return open_.beyond(owl::Construct::all_values_from);
    case owl::TermKind::object_max_cardinality:
    case owl::TermKind::data_max_cardinality:
    case owl::TermKind::object_exact_cardinality:
    case owl::TermKind::data_exact_cardinality:
      return open_.beyond(owl::Construct::max_cardinality);
    case owl::TermKind::object_min_cardinality:
    case owl::TermKind::data_min_cardinality:
      if (term.number > 1) return open_.beyond(owl::Construct::min_cardinality);
      break;
    default:
      break;
  }
  if (role.is_inverse) return open_.beyond(owl::Construct::inverse_of);
  index_.mark_negative(expr);
  return use_filler(term, Side::left);
}

owl::Construct ExpressionNormaliser::make_right(owl::TermId id) {
  const owl::Term term = source_.term(id);
  const ExprId expr = terms_.expression(id);
  if (expr == top_expr || expr == bottom_expr) return owl::Construct::none;
  switch (term.kind) {
    case owl::TermKind::named_class:
    case owl::TermKind::individual:
    case owl::TermKind::anonymous_individual:
      return owl::Construct::none;
    case owl::TermKind::datatype:
      data_.note_datatype(term);
      return owl::Construct::none;
    case owl::TermKind::literal:
      data_.note_literal(id);
      return owl::Construct::none;
    case owl::TermKind::object_intersection_of:
    case owl::TermKind::data_intersection_of:
      return use_all_right(term.arguments);
    case owl::TermKind::object_union_of:
    case owl::TermKind::data_union_of:
    case owl::TermKind::object_one_of:
    case owl::TermKind::data_one_of:
      return make_right_union(term, expr);
    case owl::TermKind::object_complement_of:
    case owl::TermKind::data_complement_of:
      return make_right_complement(term, expr);
    case owl::TermKind::datatype_restriction:
      return open_.beyond(owl::Construct::datatype_restriction);
    default:
      return make_right_restriction(term, expr);
  }
}

owl::Construct ExpressionNormaliser::make_right_union(const owl::Term& term, ExprId expr) {
  const owl::Construct unused = use_all_right(term.arguments);
  std::vector<ExprId> parts;
  for (const owl::TermId part : term.arguments) parts.push_back(terms_.expression(part));
  // A union that equals one of its parts, because the others are empty or equal, is that part.
  if (std::ranges::find(parts, expr) != parts.end()) return unused;
  if (term.kind == owl::TermKind::data_union_of) return open_.beyond(owl::Construct::datatype_union);
  if (term.kind == owl::TermKind::data_one_of) return open_.beyond(owl::Construct::one_of);
  leave_union_open(expr, parts);
  return term.kind == owl::TermKind::object_union_of ? owl::Construct::union_of : owl::Construct::one_of;
}

//  C < not D  is  C < X, X and D < F
owl::Construct ExpressionNormaliser::make_right_complement(const owl::Term& term, ExprId expr) {
  const owl::TermId negated = term.arguments[0];
  if (source_.kind(negated) == term.kind) return use_right(source_.term(negated).arguments[0]);
  exclude(expr, terms_.expression(negated));
  return use_left(negated);
}

owl::Construct ExpressionNormaliser::make_right_restriction(const owl::Term& term, ExprId expr) {
  const Property role = terms_.property(term.arguments[0]);
  if (role.is_top) return open_.beyond(owl::Construct::top_property);
  owl::Construct unused = owl::Construct::none;
  switch (term.kind) {
    case owl::TermKind::object_has_self:
      return owl::Construct::none;
    case owl::TermKind::object_all_values_from:
    case owl::TermKind::data_all_values_from:
      return make_all_values(role, term.arguments[1], expr);
    case owl::TermKind::object_max_cardinality:
    case owl::TermKind::data_max_cardinality:
      return make_at_most(term.number, role, term, expr);
    case owl::TermKind::object_exact_cardinality:
    case owl::TermKind::data_exact_cardinality: {
      const ExprId most =
          terms_.opaque_restriction(owl::TermKind::object_max_cardinality, term.number, role, terms_.filler_of(term));
      unused = make_at_most(term.number, role, term, most);
      if (term.number == 0) return unused;
      [[fallthrough]];
    }
    case owl::TermKind::object_min_cardinality:
    case owl::TermKind::data_min_cardinality:
      unused = first_unused(unused, use_filler(term, Side::right));
      if (role.is_inverse) return first_unused(unused, open_.beyond(owl::Construct::inverse_of));
      if (term.number == 1) return unused;
      return first_unused(unused, make_at_least(term.number, role, term));
    default:
      unused = use_filler(term, Side::right);
      return first_unused(unused, role.is_inverse ? open_.beyond(owl::Construct::inverse_of) : owl::Construct::none);
  }
}

owl::Construct ExpressionNormaliser::make_all_values(const Property& role, owl::TermId filler, ExprId expr) {
  const owl::TermKind kind = source_.kind(filler);
  if (role.is_inverse) {
    //  C < inverse R only D  is  C < X, R some X < D
    index_.add_told(recognised_some(role, expr), terms_.expression(filler));
    return use_right(filler);
  }
  ExprId excluded = bottom_expr;
  owl::Construct unused = owl::Construct::none;
  if (terms_.expression(filler) == bottom_expr) {
    excluded = top_expr;
  } else if (kind == owl::TermKind::object_complement_of || kind == owl::TermKind::data_complement_of) {
    const owl::TermId negated = source_.term(filler).arguments[0];
    excluded = terms_.expression(negated);
    unused = use_left(negated);
  } else {
    universals_.add_universal(expr, role, terms_.expression(filler));
    return use_right(filler);
  }
  //  C < R only not D  is  C < X, X and R some D < F
  exclude(expr, recognised_some(role, excluded));
  return unused;
}

//  at least n R C < R some C
owl::Construct ExpressionNormaliser::make_at_least(std::uint32_t count, const Property& role, const owl::Term& term) {
  const ExprId expr =
      terms_.opaque_restriction(owl::TermKind::object_min_cardinality, count, role, terms_.filler_of(term));
  index_.add_told(expr, index_.existential(role.role, terms_.filler_of(term)));
  if (role.is_data) return open_.beyond(owl::Construct::min_cardinality);
  leave_count_open(open_.at_least, {expr, role.role, count});
  return owl::Construct::min_cardinality;
}

owl::Construct ExpressionNormaliser::make_at_most(std::uint32_t limit, const Property& role, const owl::Term& term,
                                                  ExprId expr) {
  if (limit == 1 && !role.is_inverse && terms_.filler_of(term) == top_expr) {
    if (!role.is_data) pending_.note(SimpleUse{role.role, owl::Construct::max_cardinality_not_simple});
    index_.add_functional(expr, role.role);
    return owl::Construct::none;
  }
  if (limit > 0) {
    if (role.is_inverse || role.is_data) return open_.beyond(owl::Construct::max_cardinality);
    leave_count_open(open_.at_most, {expr, role.role, limit});
    return owl::Construct::max_cardinality;
  }
  if (role.is_inverse) {
    //  C < at most 0 inverse R D  is  C < X, R some X and D < F
    const ExprId source = recognised_some(role, expr);
    exclude(source, terms_.filler_of(term));
  } else {
    //  C < at most 0 R D  is  C < X, X and R some D < F
    exclude(expr, recognised_some(role, terms_.filler_of(term)));
  }
  return use_filler(term, Side::left);
}

//  X < C or D;  and C < X, D < X, which is needed only if X is recognised
void ExpressionNormaliser::leave_union_open(ExprId whole, std::span<const ExprId> parts) {
  OpenUnion open{whole, {}, true};
  for (const ExprId part : parts) {
    // A part that is no atom is not recognised, so that the model has nothing in it.
    if (!index_.is_atom(part)) open.has_all_parts = false;
    if (!index_.is_atom(part)) continue;
    index_.watch(part);
    index_.add_told(part, whole);
    open.parts.push_back(part);
  }
  index_.watch(whole);
  open_.unions.push_back(std::move(open));
}

void ExpressionNormaliser::leave_count_open(std::vector<OpenCount>& counts, const OpenCount& count) {
  index_.watch(count.whole);
  counts.push_back(count);
}

}  // namespace geminga::el
