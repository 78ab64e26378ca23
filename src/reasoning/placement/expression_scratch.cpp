// The axioms are copied, one is added, and all of them are classified.
#include "reasoning/placement/expression_scratch.hpp"

#include <algorithm>
#include <set>

#include "reasoning/el/classify.hpp"

namespace geminga::placement {
namespace {

/// No file can contain it, because an IRI has no space.
constexpr std::string_view query_name = "the expression";

/// The nodes of a view for the classes of a classification. The expression's own class has none.
std::vector<std::optional<taxonomy::ClassNumber>> nodes_of(const taxonomy::ClassifiedView& view,
                                                           const owl::Ontology& source,
                                                           const taxonomy::Classification& classification) {
  std::vector<std::optional<taxonomy::ClassNumber>> nodes;
  std::uint32_t at = 0;  // both lists ascend by IRI
  for (const owl::NameId name : classification.classes) {
    const std::string_view iri = source.name(name);
    while (at < view.class_count() && view.class_iri(at) < iri) ++at;
    const bool is_known = at < view.class_count() && view.class_iri(at) == iri;
    nodes.push_back(is_known ? std::optional(taxonomy::ClassNumber{view.representative[at]}) : std::nullopt);
  }
  return nodes;
}

ExpressionPlace place_in(const taxonomy::ClassifiedView& view, const owl::Ontology& source,
                         const taxonomy::Classification& classification) {
  const std::vector<std::optional<taxonomy::ClassNumber>> nodes = nodes_of(view, source, classification);
  const auto find = [&](std::string_view name) {
    const auto found = std::ranges::find(classification.classes, name, [&](owl::NameId id) { return source.name(id); });
    return static_cast<std::size_t>(found - classification.classes.begin());
  };
  const taxonomy::ClassNumber own = classification.representative[find(query_name)];
  ExpressionPlace place;
  if (own == classification.representative[static_cast<std::size_t>(classification.nothing)]) {
    place.is_satisfiable = false;
    return place;
  }
  std::set<taxonomy::ClassNumber> children;
  for (std::size_t at = 0; at < nodes.size(); ++at) {
    if (classification.representative[at] == own && nodes[at]) place.equivalent = nodes[at];
    for (const taxonomy::ClassNumber parent :
         classification.parents_of(taxonomy::ClassNumber{static_cast<std::uint32_t>(at)})) {
      if (parent == own && nodes[at]) children.insert(*nodes[at]);
    }
  }
  place.children.assign(children.begin(), children.end());
  for (const taxonomy::ClassNumber parent : classification.parents_of(own)) {
    const auto& node = nodes[static_cast<std::size_t>(parent)];
    if (node) place.parents.push_back(*node);
  }
  std::ranges::sort(place.parents);
  return place;
}

}  // namespace

std::optional<ExpressionPlace> place_by_scratch(const ExpressionBase& base, const owl::Ontology& query,
                                                owl::TermId expression) {
  if (base.source().axiom_count() > base.limits().scratch_axioms) return std::nullopt;
  owl::Ontology source = base.source();
  const owl::TermId own = source.named_class(query_name);
  source.add(owl::AxiomKind::equivalent_classes, {own, source.copy(query, expression)}, owl::FileId{0}, 0);
  const auto classification = el::classify(source);
  if (!classification || !classification->is_consistent) return std::nullopt;
  ExpressionPlace place = place_in(base.view(), source, *classification);
  if (!place.is_satisfiable) return place;
  std::set<std::string> gaps;
  for (const taxonomy::UnusedAxiom& unused : classification->unused) gaps.emplace(unused.construct);
  place.gaps.assign(gaps.begin(), gaps.end());
  return place;
}

}  // namespace geminga::placement
