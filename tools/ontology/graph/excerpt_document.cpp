#include "ontology/graph/excerpt_document.hpp"

#include <algorithm>
#include <set>
#include <string_view>

#include "reasoning/owl/datatypes.hpp"
#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::ontology {
namespace {

using Of = owl::Annotation::Of;

/// The entities that axioms use, and these.
std::set<owl::TermId> entities_in(const owl::Ontology& source, std::span<const std::uint32_t> axioms,
                                  std::span<const owl::TermId> more) {
  std::vector<owl::TermId> roots(more.begin(), more.end());
  for (const std::uint32_t axiom : axioms) {
    const auto arguments = source.axiom(axiom).arguments;
    roots.insert(roots.end(), arguments.begin(), arguments.end());
  }
  std::set<owl::TermId> entities;
  for (const owl::TermId term : owl::terms_in(source, roots)) {
    if (source.kind(term) <= owl::TermKind::anonymous_individual) entities.insert(term);
  }
  return entities;
}

bool is_declarable(const owl::Ontology& source, owl::TermId entity) {
  const std::string_view iri = source.name_of(entity);
  return source.kind(entity) != owl::TermKind::anonymous_individual && !iri.starts_with(syntax::owl_namespace) &&
         iri != owl::rdfs_literal && !owl::Datatype::find(iri);
}

/// The axioms and a declaration of each of these entities, ascending. Those that the files lack are added to the
/// source: what a property is may be said elsewhere.
std::vector<std::uint32_t> with_declarations(owl::Ontology& source, std::span<const std::uint32_t> axioms,
                                             std::set<owl::TermId> entities) {
  std::vector<std::uint32_t> all(axioms.begin(), axioms.end());
  const auto count = static_cast<std::uint32_t>(source.axiom_count());
  for (std::uint32_t number = 0; number < count; ++number) {
    const owl::Axiom axiom = source.axiom(number);
    if (axiom.kind == owl::AxiomKind::declaration && entities.erase(axiom.arguments[0]) > 0) all.push_back(number);
  }
  for (const owl::TermId entity : entities) {
    if (!is_declarable(source, entity)) continue;
    all.push_back(static_cast<std::uint32_t>(source.axiom_count()));
    source.add(owl::AxiomKind::declaration, {entity}, owl::FileId{0}, 0);
  }
  std::ranges::sort(all);
  return all;
}

std::set<std::string_view> names_of(const owl::Ontology& source, const std::set<owl::TermId>& entities) {
  std::set<std::string_view> names;
  for (const owl::TermId entity : entities) names.insert(source.name_of(entity));
  return names;
}

/// The annotations of these axioms and names, and their own, numbered anew.
std::vector<owl::Annotation> kept_of(const rdf::Loaded& loaded, const std::vector<std::uint32_t>& axioms,
                                     const std::set<std::string_view>& names) {
  const std::vector<owl::Annotation>& all = loaded.annotations;
  std::vector<bool> is_kept(all.size());
  // An annotation of another one may stand before it or behind it.
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (std::uint32_t number = 0; number < all.size(); ++number) {
      const owl::Annotation& one = all[number];
      const bool is_wanted = one.of == Of::name    ? names.contains(one.subject)
                             : one.of == Of::axiom ? std::ranges::binary_search(axioms, one.number)
                                                   : one.of == Of::annotation && is_kept[one.number];
      has_grown = has_grown || is_wanted != is_kept[number];
      is_kept[number] = is_wanted;
    }
  }
  std::vector<std::uint32_t> number_of(all.size());
  std::vector<owl::Annotation> kept;
  for (std::uint32_t number = 0; number < all.size(); ++number) {
    if (!is_kept[number]) continue;
    number_of[number] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(all[number]);
  }
  for (owl::Annotation& one : kept) {
    if (one.of == Of::annotation) one.number = number_of[one.number];
  }
  return kept;
}

}  // namespace

ExcerptDocument::ExcerptDocument(rdf::Loaded& loaded, std::span<const std::uint32_t> axioms,
                                 std::span<const owl::TermId> entities)
    : loaded_(loaded),
      axioms_(with_declarations(loaded.source, axioms, entities_in(loaded.source, axioms, entities))),
      kept_(kept_of(loaded, axioms_, names_of(loaded.source, entities_in(loaded.source, axioms, entities)))),
      annotations_(kept_),
      document_{loaded.source, annotations_, {}, {}, {}, axioms_, false} {}

std::optional<std::string> ExcerptDocument::add_to(graph::Graph& graph) const {
  graph::AxiomTriples triples(
      loaded_.source, [&](const graph::Node& s, const graph::Node& p, const graph::Node& o) { graph.add(s, p, o); });
  for (const std::uint32_t number : axioms_) {
    triples.add(loaded_.source.axiom(number));
    triples.annotate(annotations_, annotations_.about(Of::axiom, number));
  }
  for (std::uint32_t number = 0; number < annotations_.size(); ++number) {
    if (annotations_.at(number).of == Of::name) triples.add(annotations_, number);
  }
  return graph.problem();
}

}  // namespace geminga::ontology
