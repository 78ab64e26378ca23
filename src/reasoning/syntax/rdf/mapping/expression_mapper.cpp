// A blank node is mapped by the one constructor that its triples name.
#include "reasoning/syntax/rdf/mapping/expression_mapper.hpp"

#include <string_view>

#include "base/text.hpp"
#include "reasoning/syntax/count.hpp"

namespace geminga::rdf {

using syntax::Word;

namespace {

/// Beyond what the reasoner takes (owl::SourceLimits::nesting), and far from the end of the stack.
constexpr std::uint32_t max_depth = 500;

bool is_quantifier(Word word) {
  return word == Word::owl_some_values_from || word == Word::owl_all_values_from || word == Word::owl_has_value ||
         word == Word::owl_has_self;
}

bool is_cardinality(Word word) { return word >= Word::owl_min_cardinality && word <= Word::owl_qualified_cardinality; }

}  // namespace

Mapped ExpressionMapper::class_expression(NodeId node) {
  MappedOnce& mapped = classes_[static_cast<std::size_t>(node)];
  if (const auto known = mapped.known(obstacles_, "a class expression that contains itself")) return *known;
  if (depth_ >= max_depth) return std::unexpected("a class expression nested too deep");
  mapped.begin();
  ++depth_;
  const Mapped described = described_class(node);
  --depth_;
  return mapped.end(described, obstacles_);
}

Mapped ExpressionMapper::described_class(NodeId node) {
  if (graph_.is_literal(node)) return std::unexpected("a literal in place of a class");
  if (graph_.is_iri(node)) {
    if (types_.is_datatype(node) && !types_.is_class(node)) return std::unexpected("a datatype in place of a class");
    return ontology_.named_class(graph_.text(node));
  }
  Word constructor = Word::none;
  std::uint32_t description = 0;
  for (const std::uint32_t number : graph_.about(node)) {
    const Triple& triple = graph_.triple(number);
    switch (const Word predicate = word_of(triple.predicate)) {
      case Word::owl_on_property:
        if (constructor == predicate) break;
        [[fallthrough]];
      case Word::owl_on_properties:
      case Word::owl_intersection_of:
      case Word::owl_union_of:
      case Word::owl_complement_of:
      case Word::owl_one_of:
        if (constructor != Word::none) return std::unexpected("a blank class with several descriptions");
        constructor = predicate;
        description = number;
        triples_.use(number);
        break;
      default:
        break;
    }
  }
  if (constructor == Word::none) return std::unexpected("a blank class without a description");
  if (constructor == Word::owl_on_properties) return std::unexpected("owl:onProperties");
  if (constructor == Word::owl_on_property) return restriction(node);
  return boolean_class(description);
}

Mapped ExpressionMapper::boolean_class(std::uint32_t triple) {
  const Word constructor = word_of(graph_.triple(triple).predicate);
  const NodeId object = graph_.triple(triple).object;
  if (constructor == Word::owl_complement_of) {
    const Mapped complement = class_expression(object);
    if (!complement) return complement;
    return ontology_.term(owl::TermKind::object_complement_of, {*complement});
  }
  const bool is_enumeration = constructor == Word::owl_one_of;
  const auto members = is_enumeration ? individuals(object) : class_expressions(object);
  if (!members) return std::unexpected(members.error());
  const owl::TermKind kind = is_enumeration                             ? owl::TermKind::object_one_of
                             : constructor == Word::owl_intersection_of ? owl::TermKind::object_intersection_of
                                                                        : owl::TermKind::object_union_of;
  return axioms_.term_of_list(triple, kind, *members);
}

Mapped ExpressionMapper::object_property(NodeId node) {
  if (types_.is_data_property_only(node)) return std::unexpected("a data property in place of an object property");
  if (graph_.is_iri(node)) return ontology_.object_property(graph_.text(node));
  if (graph_.is_literal(node)) return std::unexpected("a literal in place of a property");
  const NodeId inverse = inverse_of(node);
  if (inverse == NodeId{}) {
    if (!graph_.about(node, Word::owl_union_of).empty()) return std::unexpected("a union of properties");
    if (!graph_.about(node, Word::owl_intersection_of).empty()) return std::unexpected("an intersection of properties");
    return std::unexpected("a blank property without owl:inverseOf");
  }
  return ontology_.term(owl::TermKind::object_inverse_of, {ontology_.object_property(graph_.text(inverse))});
}

NodeId ExpressionMapper::inverse_of(NodeId node) {
  const auto [known, is_new] = inverses_.try_emplace(static_cast<std::uint32_t>(node));
  if (!is_new) return known->second;
  for (const std::uint32_t number : graph_.about(node, Word::owl_inverse_of)) {
    const NodeId object = graph_.triple(number).object;
    if (!graph_.is_iri(object)) continue;
    triples_.use(number);
    return known->second = object;
  }
  return NodeId{};
}

Mapped ExpressionMapper::data_property(NodeId node) {
  if (!graph_.is_iri(node)) return std::unexpected("a blank data property");
  return ontology_.data_property(graph_.text(node));
}

Mapped ExpressionMapper::individual(NodeId node) {
  switch (graph_.kind(node)) {
    case NodeKind::iri:
      return ontology_.individual(graph_.text(node));
    case NodeKind::blank:
      return ontology_.anonymous_individual(graph_.text(node));
    case NodeKind::literal:
      break;
  }
  return std::unexpected("a literal in place of an individual");
}

Mapped ExpressionMapper::restriction(NodeId node) {
  NodeId property{};
  NodeId value{};
  NodeId on_class{};
  NodeId on_range{};
  Word constraint = Word::none;
  for (const std::uint32_t number : graph_.about(node)) {
    const Triple& triple = graph_.triple(number);
    const Word predicate = word_of(triple.predicate);
    NodeId* place = nullptr;
    if (predicate == Word::owl_on_property) {
      place = &property;
    } else if (predicate == Word::owl_on_class) {
      place = &on_class;
    } else if (predicate == Word::owl_on_data_range) {
      place = &on_range;
    } else if (is_quantifier(predicate) || is_cardinality(predicate)) {
      place = &value;
      constraint = predicate;
    } else {
      continue;
    }
    triples_.use(number);
    if (*place != NodeId{}) return std::unexpected("an owl:Restriction with several constraints");
    *place = triple.object;
  }
  if (constraint == Word::none && graph_.has(node, node_of(Word::rdf_type), node_of(Word::owl_self_restriction))) {
    const Mapped on = object_property(property);  // as OWL 1.1 wrote owl:hasSelf
    return on ? ontology_.term(owl::TermKind::object_has_self, {*on}) : on;
  }
  if (constraint == Word::none) return std::unexpected("an owl:Restriction without a constraint");
  if (is_cardinality(constraint)) return cardinality(property, constraint, value, on_class, on_range);
  return quantifier(property, constraint, value);
}

Mapped ExpressionMapper::quantifier(NodeId property, Word constraint, NodeId filler) {
  using Term = owl::TermKind;
  const bool is_data_filler = constraint == Word::owl_has_value
                                  ? graph_.is_literal(filler)
                                  : constraint != Word::owl_has_self && types_.is_data_range(filler);
  // A property of both kinds is a different property in each, and the filler decides. A property of one kind decides
  // itself.
  const bool is_data_restriction =
      is_data_filler ? !types_.is_object_property_expression(property) || types_.is_data_property(property)
                     : types_.is_data_property_only(property);
  if (is_data_restriction) {
    const Mapped on = data_property(property);
    if (!on) return on;
    if (constraint == Word::owl_has_self) return std::unexpected("owl:hasSelf on a data property");
    const Mapped range =
        constraint == Word::owl_has_value ? ranges_.literal(filler) : ranges_.data_range(filler, depth_);
    if (!range) return range;
    const Term kind = constraint == Word::owl_some_values_from  ? Term::data_some_values_from
                      : constraint == Word::owl_all_values_from ? Term::data_all_values_from
                                                                : Term::data_has_value;
    return ontology_.term(kind, {*on, *range});
  }
  const Mapped on = object_property(property);
  if (!on) return on;
  switch (constraint) {
    case Word::owl_has_self: {
      // Truth values and numbers may stand between white space (XML Schema, part 2, section 4.3.6).
      const std::string_view is_true = base::trimmed(graph_.text(filler));
      if (!graph_.is_literal(filler) || (is_true != "true" && is_true != "1"))
        return std::unexpected("owl:hasSelf that is not true");
      return ontology_.term(Term::object_has_self, {*on});
    }
    case Word::owl_has_value: {
      const Mapped value = individual(filler);
      if (!value) return value;
      return ontology_.term(Term::object_has_value, {*on, *value});
    }
    default: {
      const Mapped class_filler = class_expression(filler);
      if (!class_filler) return class_filler;
      return ontology_.term(
          constraint == Word::owl_some_values_from ? Term::object_some_values_from : Term::object_all_values_from,
          {*on, *class_filler});
    }
  }
}

Mapped ExpressionMapper::cardinality(NodeId property, Word constraint, NodeId number, NodeId on_class,
                                     NodeId on_range) {
  using Term = owl::TermKind;
  const auto count = syntax::read_count(graph_.text(number));
  if (!graph_.is_literal(number) || !count)
    return std::unexpected("a cardinality that is no number, or above 4294967295");
  const bool is_min = constraint == Word::owl_min_cardinality || constraint == Word::owl_min_qualified_cardinality;
  const bool is_max = constraint == Word::owl_max_cardinality || constraint == Word::owl_max_qualified_cardinality;
  if (on_class != NodeId{} && on_range != NodeId{})
    return std::unexpected("an owl:Restriction with several constraints");
  const bool is_data_restriction =
      on_range != NodeId{} || (on_class == NodeId{} && types_.is_data_property_only(property));
  const Mapped on = is_data_restriction ? data_property(property) : object_property(property);
  if (!on) return on;
  const Term kind = is_data_restriction ? (is_min   ? Term::data_min_cardinality
                                           : is_max ? Term::data_max_cardinality
                                                    : Term::data_exact_cardinality)
                                        : (is_min   ? Term::object_min_cardinality
                                           : is_max ? Term::object_max_cardinality
                                                    : Term::object_exact_cardinality);
  // A draft of OWL 1.1 wrote owl:maxCardinality beside owl:onClass; the OWL API, too, reads it as qualified.
  const bool is_qualified = on_class != NodeId{} || on_range != NodeId{};
  if (!is_qualified && constraint >= Word::owl_min_qualified_cardinality)
    return std::unexpected("a qualified cardinality without owl:onClass or owl:onDataRange");
  if (!is_qualified) return ontology_.term(kind, {*on}, *count);
  const Mapped filler = is_data_restriction ? ranges_.data_range(on_range, depth_) : class_expression(on_class);
  if (!filler) return filler;
  return ontology_.term(kind, {*on, *filler}, *count);
}

}  // namespace geminga::rdf
