// A blank node is mapped by the one constructor that its triples name.
#include "reasoning/syntax/rdf/mapping/data_range_mapper.hpp"

#include <string_view>
#include <vector>

#include "reasoning/owl/plain_literal.hpp"

namespace geminga::rdf {

using syntax::Word;

namespace {

/// Levels of expressions around a data range.
constexpr std::uint32_t max_range_nesting = 100;

}  // namespace

Mapped DataRangeMapper::data_range(NodeId node, std::uint32_t depth) {
  if (graph_.is_iri(node)) return ontology_.datatype(graph_.text(node));
  MappedOnce& mapped = ranges_[static_cast<std::uint32_t>(node)];
  if (const auto known = mapped.known(obstacles_, "a data range that contains itself")) return *known;
  if (depth >= max_range_nesting) return std::unexpected("a data range nested too deep");
  mapped.begin();
  return mapped.end(described_range(node, depth + 1), obstacles_);
}

Mapped DataRangeMapper::described_range(NodeId node, std::uint32_t depth) {
  using Term = owl::TermKind;
  if (graph_.is_literal(node)) return std::unexpected("a literal in place of a datatype");
  Word constructor = Word::none;
  NodeId object{};
  NodeId facets{};
  std::uint32_t description = 0;
  for (const std::uint32_t number : graph_.about(node)) {
    const Triple& triple = graph_.triple(number);
    switch (const Word predicate = word_of(triple.predicate)) {
      case Word::owl_intersection_of:
      case Word::owl_union_of:
      case Word::owl_complement_of:  // OWL 1 wrote it so
      case Word::owl_datatype_complement_of:
      case Word::owl_one_of:
      case Word::owl_on_datatype:
      case Word::owl_on_data_range:  // OWL 1.1, with the facets beside it
        if (constructor != Word::none) return std::unexpected("a blank data range with several descriptions");
        constructor = predicate;
        description = number;
        object = triple.object;
        triples_.use(number);
        break;
      case Word::owl_with_restrictions:
        facets = triple.object;
        triples_.use(number);
        break;
      default:
        break;
    }
  }
  const auto ranges = [&] { return triples_.terms(object, [&](NodeId part) { return data_range(part, depth); }); };
  switch (constructor) {
    case Word::owl_on_datatype:
      return restricted_datatype(object, facets);
    case Word::owl_on_data_range:
      return facets == NodeId{} ? with_facets(object, {&node, 1}) : restricted_datatype(object, facets);
    case Word::owl_complement_of:
    case Word::owl_datatype_complement_of: {
      const Mapped complement = data_range(object, depth);
      if (!complement) return complement;
      return ontology_.term(Term::data_complement_of, {*complement});
    }
    case Word::owl_one_of:
      return range_of_list(description, Term::data_one_of,
                           triples_.terms(object, [&](NodeId member) { return literal(member); }));
    case Word::owl_intersection_of:
      return range_of_list(description, Term::data_intersection_of, ranges());
    case Word::owl_union_of:
      return range_of_list(description, Term::data_union_of, ranges());
    default:
      return std::unexpected("a blank data range without a description");
  }
}

Mapped DataRangeMapper::range_of_list(std::uint32_t triple, owl::TermKind kind, const MappedList& members) {
  if (!members) return std::unexpected(members.error());
  return axioms_.term_of_list(triple, kind, *members);
}

Mapped DataRangeMapper::restricted_datatype(NodeId datatype, NodeId facets) {
  const auto members = facets == NodeId{} ? std::nullopt : triples_.list(facets);
  if (!members) return std::unexpected("owl:onDatatype without a list of owl:withRestrictions");
  return with_facets(datatype, *members);
}

Mapped DataRangeMapper::with_facets(NodeId datatype, std::span<const NodeId> nodes) {
  if (!graph_.is_iri(datatype)) return std::unexpected("owl:onDatatype of a blank node");
  std::vector<owl::TermId> parts{ontology_.datatype(graph_.text(datatype))};
  for (const NodeId node : nodes) {
    for (const std::uint32_t number : graph_.about(node)) {
      const Triple& triple = graph_.triple(number);
      const bool is_facet = graph_.text(triple.predicate).starts_with(syntax::xsd_namespace);
      if (!is_facet && !graph_.about(node, Word::owl_on_data_range).empty()) continue;
      const Mapped value = literal(triple.object);
      if (!value) return value;
      triples_.use(number);
      parts.push_back(ontology_.facet(graph_.text(triple.predicate), *value));
    }
  }
  return parts.size() == 1 ? parts.front() : ontology_.term(owl::TermKind::datatype_restriction, parts);
}

Mapped DataRangeMapper::literal(NodeId id) {
  const Node node = graph_.node(id);
  if (node.kind != NodeKind::literal) return std::unexpected("an individual in place of a literal");
  const std::string_view datatype = node.datatype == NodeId{} ? std::string_view() : graph_.text(node.datatype);
  const std::string_view language = node.language == NodeId{} ? std::string_view() : graph_.text(node.language);
  if (word_of(node.datatype) == Word::rdf_plain_literal) {
    const auto plain = owl::split_plain_literal(node.text);
    return ontology_.literal(plain.text, {}, plain.language);
  }
  return ontology_.literal(node.text, datatype, language);
}

}  // namespace geminga::rdf
