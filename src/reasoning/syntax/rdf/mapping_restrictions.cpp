// Restrictions on properties (mapping, table 13).
#include <algorithm>
#include <string>

#include "base/text.hpp"
#include "reasoning/syntax/rdf/mapping.hpp"

namespace geminga::rdf {
namespace {

bool is_quantifier(syntax::Word word) {
  return word == syntax::Word::owl_some_values_from || word == syntax::Word::owl_all_values_from ||
         word == syntax::Word::owl_has_value || word == syntax::Word::owl_has_self;
}

/// Numbers and truth values may stand between white space (XML Schema, part 2, section 4.3.6).
std::string_view without_blanks(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
}

bool is_cardinality(syntax::Word word) {
  return word >= syntax::Word::owl_min_cardinality && word <= syntax::Word::owl_qualified_cardinality;
}

}  // namespace

Mapping::Mapped Mapping::restriction(NodeId node) {
  NodeId property{};
  NodeId value{};
  NodeId on_class{};
  NodeId on_range{};
  syntax::Word constraint = syntax::Word::none;
  for (const std::uint32_t number : graph_.about(node)) {
    const Triple& triple = graph_.triple(number);
    const syntax::Word predicate = word(triple.predicate);
    NodeId* place = nullptr;
    if (predicate == syntax::Word::owl_on_property) {
      place = &property;
    } else if (predicate == syntax::Word::owl_on_class) {
      place = &on_class;
    } else if (predicate == syntax::Word::owl_on_data_range) {
      place = &on_range;
    } else if (is_quantifier(predicate) || is_cardinality(predicate)) {
      place = &value;
      constraint = predicate;
    } else {
      continue;
    }
    used_[number] = true;
    if (*place != NodeId{}) return std::unexpected("an owl:Restriction with several constraints");
    *place = triple.object;
  }
  if (constraint == syntax::Word::none) return std::unexpected("an owl:Restriction without a constraint");
  if (is_cardinality(constraint)) return cardinality(property, constraint, value, on_class, on_range);
  return quantifier(property, constraint, value);
}

Mapping::Mapped Mapping::quantifier(NodeId property, syntax::Word constraint, NodeId filler) {
  using Kind = owl::TermKind;
  const bool is_data_filler = constraint == syntax::Word::owl_has_value
                                  ? graph_.is_literal(filler)
                                  : constraint != syntax::Word::owl_has_self && is_range(filler);
  // A property of both kinds is a different one in each; a property of one kind decides over its filler.
  const bool is_data_restriction =
      is_data_filler ? !is_object(property) || has_role(property, is_data_property) : is_data(property);
  if (is_data_restriction) {
    const Mapped on = data_property(property);
    if (!on) return on;
    if (constraint == syntax::Word::owl_has_self) return std::unexpected("owl:hasSelf on a data property");
    const Mapped range = constraint == syntax::Word::owl_has_value ? literal(filler) : data_range(filler);
    if (!range) return range;
    const Kind kind = constraint == syntax::Word::owl_some_values_from  ? Kind::data_some_values_from
                      : constraint == syntax::Word::owl_all_values_from ? Kind::data_all_values_from
                                                                        : Kind::data_has_value;
    return source_.term(kind, {*on, *range});
  }
  const Mapped on = object_property(property);
  if (!on) return on;
  switch (constraint) {
    case syntax::Word::owl_has_self: {
      const std::string_view is_true = without_blanks(graph_.text(filler));
      if (!graph_.is_literal(filler) || (is_true != "true" && is_true != "1"))
        return std::unexpected("owl:hasSelf that is not true");
      return source_.term(Kind::object_has_self, {*on});
    }
    case syntax::Word::owl_has_value: {
      const Mapped value = individual(filler);
      if (!value) return value;
      return source_.term(Kind::object_has_value, {*on, *value});
    }
    default: {
      const Mapped class_filler = class_expression(filler);
      if (!class_filler) return class_filler;
      return source_.term(constraint == syntax::Word::owl_some_values_from ? Kind::object_some_values_from
                                                                           : Kind::object_all_values_from,
                          {*on, *class_filler});
    }
  }
}

Mapping::Mapped Mapping::cardinality(NodeId property, syntax::Word constraint, NodeId number, NodeId on_class,
                                     NodeId on_range) {
  using Kind = owl::TermKind;
  const std::string_view text = without_blanks(graph_.text(number));
  const auto count = base::parse_number<std::uint32_t>(text.starts_with('+') ? text.substr(1) : text);
  if (!graph_.is_literal(number) || !count)
    return std::unexpected("a cardinality that is no number, or above 4294967295");
  const bool is_min =
      constraint == syntax::Word::owl_min_cardinality || constraint == syntax::Word::owl_min_qualified_cardinality;
  const bool is_max =
      constraint == syntax::Word::owl_max_cardinality || constraint == syntax::Word::owl_max_qualified_cardinality;
  if (on_class != NodeId{} && on_range != NodeId{})
    return std::unexpected("an owl:Restriction with several constraints");
  const bool is_data_restriction = on_range != NodeId{} || (on_class == NodeId{} && is_data(property));
  const Mapped on = is_data_restriction ? data_property(property) : object_property(property);
  if (!on) return on;
  const Kind kind = is_data_restriction ? (is_min   ? Kind::data_min_cardinality
                                           : is_max ? Kind::data_max_cardinality
                                                    : Kind::data_exact_cardinality)
                                        : (is_min   ? Kind::object_min_cardinality
                                           : is_max ? Kind::object_max_cardinality
                                                    : Kind::object_exact_cardinality);
  const bool is_qualified = constraint >= syntax::Word::owl_min_qualified_cardinality;
  // A draft of OWL 1.1 wrote it so. Whoever does means fewer than the restriction without it says.
  if (!is_qualified && (on_class != NodeId{} || on_range != NodeId{}))
    return std::unexpected("owl:onClass or owl:onDataRange beside a cardinality that is not qualified");
  if (!is_qualified) return source_.term(kind, {*on}, *count);
  if (on_class == NodeId{} && on_range == NodeId{})
    return std::unexpected("a qualified cardinality without owl:onClass or owl:onDataRange");
  const Mapped filler = is_data_restriction ? data_range(on_range) : class_expression(on_class);
  if (!filler) return filler;
  return source_.term(kind, {*on, *filler}, *count);
}

}  // namespace geminga::rdf
