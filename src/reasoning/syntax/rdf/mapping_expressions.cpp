// Class and property expressions, individuals and literals (mapping, tables 11 and 13 to 15).
#include "reasoning/syntax/rdf/mapping.hpp"

namespace geminga::rdf {
namespace {

/// Beyond what the reasoner takes (el::SourceLimits::nesting), and far from the end of the stack.
constexpr std::uint32_t max_depth = 500;

}  // namespace

Mapping::Mapped Mapping::class_expression(NodeId node) {
  Memo& memo = classes_[static_cast<std::size_t>(node)];
  switch (memo.state) {
    case Memo::State::mapped:
      return memo.term;
    case Memo::State::failed:
      return std::unexpected(memo.obstacle);
    case Memo::State::open:
      return std::unexpected("a class expression that contains itself");
    case Memo::State::unknown:
      break;
  }
  if (depth_ >= max_depth) return std::unexpected("a class expression nested too deep");
  memo.state = Memo::State::open;
  ++depth_;
  const Mapped mapped = described_class(node);
  --depth_;
  memo.state = mapped ? Memo::State::mapped : Memo::State::failed;
  if (mapped) {
    memo.term = *mapped;
  } else {
    memo.obstacle = mapped.error();
  }
  return mapped;
}

Mapping::Mapped Mapping::described_class(NodeId node) {
  if (graph_.is_literal(node)) return std::unexpected("a literal in place of a class");
  if (graph_.is_iri(node)) {
    if (has_role(node, is_datatype) && !has_role(node, is_class))
      return std::unexpected("a datatype in place of a class");
    return source_.named_class(graph_.text(node));
  }
  syntax::Word constructor = syntax::Word::none;
  NodeId object{};
  for (const std::uint32_t number : graph_.about(node)) {
    const Triple& triple = graph_.triple(number);
    switch (const syntax::Word predicate = word(triple.predicate)) {
      case syntax::Word::owl_on_property:
        if (constructor == predicate) break;
        [[fallthrough]];
      case syntax::Word::owl_on_properties:
      case syntax::Word::owl_intersection_of:
      case syntax::Word::owl_union_of:
      case syntax::Word::owl_complement_of:
      case syntax::Word::owl_one_of:
        if (constructor != syntax::Word::none) return std::unexpected("a blank class with several descriptions");
        constructor = predicate;
        object = triple.object;
        used_[number] = true;
        break;
      default:
        break;
    }
  }
  if (constructor == syntax::Word::none) return std::unexpected("a blank class without a description");
  if (constructor == syntax::Word::owl_on_properties) return std::unexpected("owl:onProperties");
  if (constructor == syntax::Word::owl_on_property) return restriction(node);
  return boolean_class(node, constructor, object);
}

Mapping::Mapped Mapping::boolean_class(NodeId, syntax::Word constructor, NodeId object) {
  if (constructor == syntax::Word::owl_complement_of) {
    const Mapped complement = class_expression(object);
    if (!complement) return complement;
    return source_.term(owl::TermKind::object_complement_of, {*complement});
  }
  const bool is_enumeration = constructor == syntax::Word::owl_one_of;
  const auto members = terms(object, is_enumeration ? &Mapping::individual : &Mapping::class_expression);
  if (!members) return std::unexpected(members.error());
  if (constructor == syntax::Word::owl_intersection_of) {
    if (members->empty()) return source_.named_class(owl::owl_thing);
    return members->size() == 1 ? members->front() : source_.term(owl::TermKind::object_intersection_of, *members);
  }
  if (members->empty()) return source_.named_class(owl::owl_nothing);
  if (is_enumeration) return source_.term(owl::TermKind::object_one_of, *members);
  return members->size() == 1 ? members->front() : source_.term(owl::TermKind::object_union_of, *members);
}

Mapping::Mapped Mapping::object_property(NodeId node) {
  if (has_role(node, is_data_property) && !has_role(node, is_object_property))
    return std::unexpected("a data property in place of an object property");
  if (graph_.is_iri(node)) return source_.object_property(graph_.text(node));
  if (graph_.is_literal(node)) return std::unexpected("a literal in place of a property");
  const NodeId inverse = object_of(node, syntax::Word::owl_inverse_of);
  if (inverse == NodeId{} || !graph_.is_iri(inverse)) {
    if (!graph_.about(node, syntax::Word::owl_union_of).empty()) return std::unexpected("a union of properties");
    if (!graph_.about(node, syntax::Word::owl_intersection_of).empty())
      return std::unexpected("an intersection of properties");
    return std::unexpected("a blank property without owl:inverseOf");
  }
  return source_.term(owl::TermKind::object_inverse_of, {source_.object_property(graph_.text(inverse))});
}

Mapping::Mapped Mapping::data_property(NodeId node) {
  if (!graph_.is_iri(node)) return std::unexpected("a blank data property");
  return source_.data_property(graph_.text(node));
}

Mapping::Mapped Mapping::individual(NodeId node) {
  switch (graph_.kind(node)) {
    case NodeKind::iri:
      return source_.individual(graph_.text(node));
    case NodeKind::blank:
      return source_.anonymous_individual(graph_.text(node));
    case NodeKind::literal:
      break;
  }
  return std::unexpected("a literal in place of an individual");
}

Mapping::Mapped Mapping::literal(NodeId id) {
  const Node node = graph_.node(id);
  if (node.kind != NodeKind::literal) return std::unexpected("an individual in place of a literal");
  const std::string_view datatype = node.datatype == NodeId{} ? std::string_view() : graph_.text(node.datatype);
  const std::string_view language = node.language == NodeId{} ? std::string_view() : graph_.text(node.language);
  // "text@en"^^rdf:PlainLiteral is "text"@en, and "text@"^^rdf:PlainLiteral is "text" (OWL 2, section 5.7).
  if (word(node.datatype) == syntax::Word::rdf_plain_literal) {
    const std::size_t at = node.text.rfind('@');
    if (at == std::string_view::npos) return source_.literal(node.text, {});
    std::string tag(node.text.substr(at + 1));
    for (char& c : tag) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c;
    return source_.literal(node.text.substr(0, at), {}, tag);
  }
  return source_.literal(node.text, datatype, language);
}

bool Mapping::is_data(NodeId property) const {
  return has_role(property, is_data_property) && !has_role(property, is_object_property);
}

bool Mapping::is_object(NodeId property) const {
  return graph_.is_blank(property) || has_role(property, is_object_property);
}

}  // namespace geminga::rdf
