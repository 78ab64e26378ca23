// The restrictions that keep OWL 2 DL decidable.
#include "reasoning/dl/clauses/allowed.hpp"

namespace geminga::clauses {

bool Allowed::is_simple(owl::TermId property) { return roles_.is_simple(vocabulary_.role(property)); }

bool Allowed::is_top_data(owl::TermId property) const {
  return vocabulary_.source().name_of(property) == owl::owl_top_data_property;
}

std::string_view Allowed::problem(Literal literal) {
  const auto [found, is_new] = known_.try_emplace({literal.term, literal.is_negated, literal.part});
  if (is_new) found->second = problem_of(shape_of(vocabulary_.source(), literal));
  return found->second;
}

std::string_view Allowed::problem_of(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::all_of:
    case ShapeKind::any_of:
      for (const Literal operand : shape.operands) {
        if (const std::string_view found = problem(operand); !found.empty()) return found;
      }
      return {};
    case ShapeKind::at_most:
      if (!is_simple(shape.property)) return "owl:maxCardinality of a property that is not simple";
      if (shape.count > max_cardinality_) return "a cardinality that is too large";
      return problem(complement(shape.filler));
    case ShapeKind::at_least:
      if (shape.count > max_cardinality_) return "a cardinality that is too large";
      return problem(shape.filler);
    case ShapeKind::some:
    case ShapeKind::every:
      return problem(shape.filler);
    case ShapeKind::not_self:
      return is_simple(shape.property) ? std::string_view() : "owl:hasSelf of a property that is not simple";
    case ShapeKind::data_at_least:
    case ShapeKind::data_at_most:
      if (shape.count > max_cardinality_) return "a cardinality that is too large";
      [[fallthrough]];
    case ShapeKind::data_some:
    case ShapeKind::data_every:
      return is_top_data(shape.property) ? "owl:topDataProperty" : std::string_view();
    default:
      return {};
  }
}

}  // namespace geminga::clauses
