// Data ranges (mapping, table 12).
#include "reasoning/syntax/rdf/mapping.hpp"

namespace geminga::rdf {
namespace {

constexpr int max_depth = 100;

}  // namespace

bool Mapping::is_range(NodeId node, int depth) const {
  if (depth > max_depth || graph_.is_literal(node)) return false;
  if (graph_.is_iri(node)) return has_role(node, is_datatype) && !has_role(node, is_class);
  std::uint8_t& mark = range_marks_[static_cast<std::size_t>(node)];
  if (mark == 0) mark = has_role(node, is_datatype) || is_described_range(node, depth) ? 2 : 1;
  return mark == 2;
}

bool Mapping::is_described_range(NodeId node, int depth) const {
  const auto has = [&](syntax::Word predicate) { return !graph_.about(node, predicate).empty(); };
  if (has(syntax::Word::owl_on_datatype) || has(syntax::Word::owl_datatype_complement_of)) return true;
  if (has(syntax::Word::owl_on_property) || has(syntax::Word::owl_complement_of)) return false;
  const auto first_of = [&](syntax::Word constructor) {
    for (const std::uint32_t number : graph_.about(node, constructor)) {
      for (const std::uint32_t part : graph_.about(graph_.triple(number).object, syntax::Word::rdf_first))
        return graph_.triple(part).object;
    }
    return NodeId{};
  };
  if (const NodeId first = first_of(syntax::Word::owl_one_of); first != NodeId{}) return graph_.is_literal(first);
  if (has_role(node, is_class)) return false;
  for (const syntax::Word constructor : {syntax::Word::owl_intersection_of, syntax::Word::owl_union_of}) {
    if (const NodeId first = first_of(constructor); first != NodeId{}) return is_range(first, depth + 1);
  }
  return false;
}

Mapping::Mapped Mapping::data_range(NodeId node) {
  if (graph_.is_iri(node)) return source_.datatype(graph_.text(node));
  // Not a reference: the map may grow below.
  const Memo known = ranges_[static_cast<std::uint32_t>(node)];
  if (known.state == Memo::State::mapped) return known.term;
  if (known.state == Memo::State::failed) return std::unexpected(known.obstacle);
  if (known.state == Memo::State::open) return std::unexpected("a data range that contains itself");
  if (depth_ >= max_depth) return std::unexpected("a data range nested too deep");
  ranges_[static_cast<std::uint32_t>(node)].state = Memo::State::open;
  ++depth_;
  const Mapped mapped = described_range(node);
  --depth_;
  Memo& memo = ranges_[static_cast<std::uint32_t>(node)];
  memo.state = mapped ? Memo::State::mapped : Memo::State::failed;
  if (mapped) {
    memo.term = *mapped;
  } else {
    memo.obstacle = mapped.error();
  }
  return mapped;
}

Mapping::Mapped Mapping::described_range(NodeId node) {
  using Kind = owl::TermKind;
  if (graph_.is_literal(node)) return std::unexpected("a literal in place of a datatype");
  syntax::Word constructor = syntax::Word::none;
  NodeId object{};
  NodeId restrictions{};
  for (const std::uint32_t number : graph_.about(node)) {
    const Triple& triple = graph_.triple(number);
    switch (const syntax::Word predicate = word(triple.predicate)) {
      case syntax::Word::owl_intersection_of:
      case syntax::Word::owl_union_of:
      case syntax::Word::owl_complement_of:  // OWL 1 wrote it so
      case syntax::Word::owl_datatype_complement_of:
      case syntax::Word::owl_one_of:
      case syntax::Word::owl_on_datatype:
        if (constructor != syntax::Word::none) return std::unexpected("a blank data range with several descriptions");
        constructor = predicate;
        object = triple.object;
        used_[number] = true;
        break;
      case syntax::Word::owl_with_restrictions:
        restrictions = triple.object;
        used_[number] = true;
        break;
      default:
        break;
    }
  }
  switch (constructor) {
    case syntax::Word::owl_on_datatype:
      return facets(object, restrictions);
    case syntax::Word::owl_complement_of:
    case syntax::Word::owl_datatype_complement_of: {
      const Mapped complement = data_range(object);
      if (!complement) return complement;
      return source_.term(Kind::data_complement_of, {*complement});
    }
    case syntax::Word::owl_one_of: {
      const auto members = terms(object, &Mapping::literal);
      if (!members) return std::unexpected(members.error());
      if (members->empty())
        return source_.term(Kind::data_complement_of, {source_.datatype(iri_of(syntax::Word::rdfs_literal))});
      return source_.term(Kind::data_one_of, *members);
    }
    case syntax::Word::owl_intersection_of:
    case syntax::Word::owl_union_of: {
      const auto members = terms(object, &Mapping::data_range);
      if (!members) return std::unexpected(members.error());
      const bool is_union = constructor == syntax::Word::owl_union_of;
      if (members->size() == 1) return members->front();
      if (!members->empty()) return source_.term(is_union ? Kind::data_union_of : Kind::data_intersection_of, *members);
      const owl::TermId all = source_.datatype(iri_of(syntax::Word::rdfs_literal));
      return is_union ? source_.term(Kind::data_complement_of, {all}) : all;
    }
    default:
      return std::unexpected("a blank data range without a description");
  }
}

Mapping::Mapped Mapping::facets(NodeId datatype, NodeId restrictions) {
  if (!graph_.is_iri(datatype)) return std::unexpected("owl:onDatatype of a blank node");
  const auto members = restrictions == NodeId{} ? std::nullopt : list(restrictions);
  if (!members) return std::unexpected("owl:onDatatype without a list of owl:withRestrictions");
  std::vector<owl::TermId> parts{source_.datatype(graph_.text(datatype))};
  for (const NodeId member : *members) {
    for (const std::uint32_t number : graph_.about(member)) {
      const Triple& triple = graph_.triple(number);
      const Mapped value = literal(triple.object);
      if (!value) return value;
      used_[number] = true;
      parts.push_back(source_.facet(graph_.text(triple.predicate), *value));
    }
  }
  return parts.size() == 1 ? parts.front() : source_.term(owl::TermKind::datatype_restriction, parts);
}

}  // namespace geminga::rdf
