// What the occurrences of an expression left or right of "SubClassOf" need. Legend as in indexed_ontology.hpp; X is the
// atom that stands for an expression without rules.
#include "reasoning/el/rule_normaliser.hpp"

namespace geminga::el {
namespace {

owl::Construct both(owl::Construct first, owl::Construct second) {
  return first != owl::Construct::none ? first : second;
}

}  // namespace

ExprId RuleNormaliser::negative_some(const Property& property, ExprId filler) {
  const ExprId some = index_.existential(property.role, filler);
  index_.mark_negative(some);
  return some;
}

owl::Construct RuleNormaliser::use_negative(owl::TermId id) { return use_once(id, false); }

owl::Construct RuleNormaliser::use_positive(owl::TermId id) { return use_once(id, true); }

owl::Construct RuleNormaliser::use_once(owl::TermId id, bool is_positive) {
  std::uint8_t& known = (is_positive ? positive_ : negative_)[static_cast<std::size_t>(id)];
  if (known == 0) {
    const std::size_t begin = pending_uses_.size();
    const owl::Construct unused = is_positive ? make_positive(id) : make_negative(id);
    known = static_cast<std::uint8_t>(1 + static_cast<int>(unused));
    if (pending_uses_.size() != begin) uses_of_term_[{id, is_positive}] = {begin, pending_uses_.size(), current_axiom_};
  } else if (!uses_of_term_.empty()) {
    repeat_uses(id, is_positive);
  }
  return static_cast<owl::Construct>(known - 1);
}

owl::Construct RuleNormaliser::use_negative_filler(const owl::Term& term) {
  return is_qualified(term) ? use_negative(term.arguments[1]) : owl::Construct::none;
}

owl::Construct RuleNormaliser::use_positive_filler(const owl::Term& term) {
  return is_qualified(term) ? use_positive(term.arguments[1]) : owl::Construct::none;
}

owl::Construct RuleNormaliser::make_negative(owl::TermId id) {
  const owl::Term term = source_.term(id);
  const ExprId expr = expression(id);
  // What is T or F is exact as it is, whatever it was written with.
  if (expr == top_expr || expr == bottom_expr) return owl::Construct::none;
  owl::Construct unused = owl::Construct::none;
  switch (term.kind) {
    case owl::TermKind::named_class:
    case owl::TermKind::datatype:
    case owl::TermKind::individual:
    case owl::TermKind::anonymous_individual:
      return owl::Construct::none;
    case owl::TermKind::literal:
      use_negative_literal(id);
      return owl::Construct::none;
    case owl::TermKind::object_intersection_of:
    case owl::TermKind::data_intersection_of:
      for (const owl::TermId part : term.arguments) unused = both(unused, use_negative(part));
      index_.mark_negative(expr);
      return unused;
    case owl::TermKind::object_union_of:
    case owl::TermKind::data_union_of:
    case owl::TermKind::object_one_of:
    case owl::TermKind::data_one_of:
      //  C or D < E  is  C < X, D < X, X < E
      for (const owl::TermId part : term.arguments) {
        unused = both(unused, use_negative(part));
        index_.add_told(expression(part), expr);
      }
      return unused;
    case owl::TermKind::object_complement_of:
      return source_.kind(term.arguments[0]) == term.kind ? use_negative(source_.term(term.arguments[0]).arguments[0])
                                                          : beyond(owl::Construct::complement_of);
    case owl::TermKind::data_complement_of:
      return beyond(owl::Construct::datatype_complement);
    case owl::TermKind::datatype_restriction:
      return beyond(owl::Construct::datatype_restriction);
    default:
      return make_negative_restriction(term, expr);
  }
}

owl::Construct RuleNormaliser::make_negative_restriction(const owl::Term& term, ExprId expr) {
  const Property role = property(term.arguments[0]);
  if (role.is_top) return beyond(owl::Construct::top_property);
  switch (term.kind) {
    case owl::TermKind::object_has_self:
      note_use(SimpleUse{role.role, owl::Construct::self_not_simple});
      index_.mark_negative(expr);
      return owl::Construct::none;
    case owl::TermKind::object_all_values_from:
    case owl::TermKind::data_all_values_from:
      return beyond(owl::Construct::all_values_from);
    case owl::TermKind::object_max_cardinality:
    case owl::TermKind::data_max_cardinality:
    case owl::TermKind::object_exact_cardinality:
    case owl::TermKind::data_exact_cardinality:
      return beyond(owl::Construct::max_cardinality);
    case owl::TermKind::object_min_cardinality:
    case owl::TermKind::data_min_cardinality:
      if (term.number > 1) return beyond(owl::Construct::min_cardinality);
      break;
    default:
      break;
  }
  if (role.is_inverse) return beyond(owl::Construct::inverse_of);
  index_.mark_negative(expr);
  return use_negative_filler(term);
}

owl::Construct RuleNormaliser::make_positive(owl::TermId id) {
  const owl::Term term = source_.term(id);
  const ExprId expr = expression(id);
  if (expr == top_expr || expr == bottom_expr) return owl::Construct::none;
  owl::Construct unused = owl::Construct::none;
  switch (term.kind) {
    case owl::TermKind::named_class:
    case owl::TermKind::individual:
    case owl::TermKind::anonymous_individual:
      return owl::Construct::none;
    case owl::TermKind::datatype:
      return use_positive_datatype(term);
    case owl::TermKind::literal:
      note_literal(id);
      return owl::Construct::none;
    case owl::TermKind::object_intersection_of:
    case owl::TermKind::data_intersection_of:
      for (const owl::TermId part : term.arguments) unused = both(unused, use_positive(part));
      return unused;
    case owl::TermKind::object_union_of:
    case owl::TermKind::data_union_of:
    case owl::TermKind::object_one_of:
    case owl::TermKind::data_one_of: {
      std::size_t possible = 0;
      for (const owl::TermId part : term.arguments) {
        unused = both(unused, use_positive(part));
        if (expression(part) != bottom_expr && expression(part) == expr) ++possible;
      }
      if (possible > 0) return unused;  // it is one of its parts, the others being empty or equal
      if (term.kind == owl::TermKind::data_union_of) return beyond(owl::Construct::datatype_union);
      if (term.kind == owl::TermKind::data_one_of) return beyond(owl::Construct::one_of);
      std::vector<ExprId> parts;
      for (const owl::TermId part : term.arguments) parts.push_back(expression(part));
      open_union(expr, parts);
      return term.kind == owl::TermKind::object_union_of ? owl::Construct::union_of : owl::Construct::one_of;
    }
    case owl::TermKind::object_complement_of:
    case owl::TermKind::data_complement_of: {
      if (source_.kind(term.arguments[0]) == term.kind)
        return use_positive(source_.term(term.arguments[0]).arguments[0]);
      //  C < not D  is  C < X, X and D < F
      const ExprId clash = index_.conjunction({expr, expression(term.arguments[0])});
      index_.mark_negative(clash);
      index_.add_told(clash, bottom_expr);
      return use_negative(term.arguments[0]);
    }
    case owl::TermKind::datatype_restriction:
      return beyond(owl::Construct::datatype_restriction);
    default:
      return make_positive_restriction(term, expr);
  }
}

owl::Construct RuleNormaliser::make_positive_restriction(const owl::Term& term, ExprId expr) {
  const Property role = property(term.arguments[0]);
  if (role.is_top) return beyond(owl::Construct::top_property);
  owl::Construct unused = owl::Construct::none;
  switch (term.kind) {
    case owl::TermKind::object_has_self:
      return owl::Construct::none;
    case owl::TermKind::object_all_values_from:
    case owl::TermKind::data_all_values_from:
      return use_all_values(role, term.arguments[1], expr);
    case owl::TermKind::object_max_cardinality:
    case owl::TermKind::data_max_cardinality:
      return use_at_most(term.number, role, term, expr);
    case owl::TermKind::object_exact_cardinality:
    case owl::TermKind::data_exact_cardinality: {
      const ExprId most = opaque_restriction(owl::TermKind::object_max_cardinality, term.number, role, filler_of(term));
      unused = use_at_most(term.number, role, term, most);
      if (term.number == 0) return unused;
      [[fallthrough]];
    }
    case owl::TermKind::object_min_cardinality:
    case owl::TermKind::data_min_cardinality:
      unused = both(unused, use_positive_filler(term));
      if (role.is_inverse) return both(unused, beyond(owl::Construct::inverse_of));
      if (term.number == 1) return unused;
      return both(unused, use_at_least(term.number, role, term));
    default:
      unused = use_positive_filler(term);
      return both(unused, role.is_inverse ? beyond(owl::Construct::inverse_of) : owl::Construct::none);
  }
}

owl::Construct RuleNormaliser::use_all_values(const Property& role, owl::TermId filler, ExprId expr) {
  const owl::TermKind kind = source_.kind(filler);
  if (role.is_inverse) {
    //  C < inverse R only D  is  C < X, R some X < D
    index_.add_told(negative_some(role, expr), expression(filler));
    return use_positive(filler);
  }
  ExprId excluded = bottom_expr;
  owl::Construct unused = owl::Construct::none;
  if (expression(filler) == bottom_expr) {
    excluded = top_expr;
  } else if (kind == owl::TermKind::object_complement_of || kind == owl::TermKind::data_complement_of) {
    const owl::TermId negated = source_.term(filler).arguments[0];
    excluded = expression(negated);
    unused = use_negative(negated);
  } else {
    note_use(UniversalUse{universals_.size()});
    universals_.push_back({expr, role, expression(filler)});
    return use_positive(filler);
  }
  //  C < R only not D  is  C < X, X and R some D < F
  const ExprId clash = index_.conjunction({expr, negative_some(role, excluded)});
  index_.mark_negative(clash);
  index_.add_told(clash, bottom_expr);
  return unused;
}

//  at least n R C < R some C
owl::Construct RuleNormaliser::use_at_least(std::uint32_t count, const Property& role, const owl::Term& term) {
  const ExprId expr = opaque_restriction(owl::TermKind::object_min_cardinality, count, role, filler_of(term));
  index_.add_told(expr, index_.existential(role.role, filler_of(term)));
  if (role.is_data) return beyond(owl::Construct::min_cardinality);
  open_count(open_.at_least, {expr, role.role, count});
  return owl::Construct::min_cardinality;
}

owl::Construct RuleNormaliser::use_at_most(std::uint32_t limit, const Property& role, const owl::Term& term,
                                           ExprId expr) {
  if (limit == 1 && !role.is_inverse && filler_of(term) == top_expr) {
    if (!role.is_data) note_use(SimpleUse{role.role, owl::Construct::max_cardinality_not_simple});
    index_.add_functional(expr, role.role);
    return owl::Construct::none;
  }
  if (limit > 0) {
    if (role.is_inverse || role.is_data) return beyond(owl::Construct::max_cardinality);
    open_count(open_.at_most, {expr, role.role, limit});
    return owl::Construct::max_cardinality;
  }
  //  C < at most 0 R D          is  C < X, X and R some D < F
  //  C < at most 0 inverse R D  is  C < X, R some X and D < F
  const ExprId clash = role.is_inverse ? index_.conjunction({negative_some(role, expr), filler_of(term)})
                                       : index_.conjunction({expr, negative_some(role, filler_of(term))});
  index_.mark_negative(clash);
  index_.add_told(clash, bottom_expr);
  return use_negative_filler(term);
}

}  // namespace geminga::el
