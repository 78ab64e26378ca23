#include "ontology/graph/asked_names.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string_view>

#include "base/harmless.hpp"
#include "base/text.hpp"
#include "ontology/individuals/realized_files.hpp"
#include "ontology/loading/class_expressions.hpp"
#include "ontology/loading/hierarchy.hpp"
#include "reasoning/realization/realization.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"
#include "reasoning/syntax/rdf/mapping/class_expression.hpp"

namespace geminga::ontology {
namespace {

using graph::Node;
using Kinds = std::map<owl::NameId, std::set<owl::TermKind>>;

constexpr owl::TermKind kinds_of_names[] = {owl::TermKind::named_class, owl::TermKind::object_property,
                                            owl::TermKind::data_property, owl::TermKind::datatype,
                                            owl::TermKind::individual};

bool is_reserved(std::string_view iri) {
  return iri.starts_with(syntax::owl_namespace) || iri.starts_with(syntax::xsd_namespace);
}

/// The kinds in which the files use the names of an expression.
Kinds kinds_in(const owl::Ontology& source, const graph::AskedExpression& asked) {
  Kinds kinds;
  for (const auto& triple : asked.triples) {
    const auto name = triple.object.kind == Node::Kind::iri ? source.find_name(triple.object.text) : std::nullopt;
    if (name) kinds.try_emplace(*name);
  }
  for (std::uint32_t number = 0; number < source.term_count(); ++number) {
    const owl::TermKind kind = source.kind(owl::TermId{number});
    if (std::ranges::find(kinds_of_names, kind) == std::end(kinds_of_names)) continue;
    const auto found = kinds.find(source.term(owl::TermId{number}).name);
    if (found != kinds.end()) found->second.insert(kind);
  }
  return kinds;
}

rdf::NodeId node_in(rdf::Graph& triples, const Node& node) {
  if (node.kind == Node::Kind::iri) return triples.iri(node.text);
  if (node.kind == Node::Kind::blank) return triples.blank(node.text);
  const rdf::NodeId datatype = node.datatype.empty() ? rdf::NodeId{} : triples.iri(node.datatype);
  const rdf::NodeId language = node.language.empty()
                                   ? rdf::NodeId{}
                                   : triples.literal(base::in_lower_case(node.language), rdf::NodeId{}, rdf::NodeId{});
  return triples.literal(node.text, datatype, language);
}

/// The first name of an expression that the files do not use as what it stands for.
std::optional<std::string> unknown_name(const owl::Ontology& expression, owl::TermId term, const owl::Ontology& source,
                                        const Kinds& kinds) {
  for (const owl::TermId part : owl::terms_in(expression, std::span(&term, 1))) {
    const owl::TermKind kind = expression.kind(part);
    if (kind == owl::TermKind::anonymous_individual) return "an individual without a name";
    const std::string_view name = expression.name_of(part);
    if (std::ranges::find(kinds_of_names, kind) == std::end(kinds_of_names) || is_reserved(name)) continue;
    const auto id = source.find_name(name);
    const auto found = id ? kinds.find(*id) : kinds.end();
    if (kind == owl::TermKind::datatype || (found != kinds.end() && found->second.contains(kind))) continue;
    const std::string_view noun = kind == owl::TermKind::named_class  ? "class"
                                  : kind == owl::TermKind::individual ? "individual"
                                                                      : "property of the kind that it needs";
    return "the files have no " + std::string(noun) + " <" + base::printable(name) + '>';
  }
  return std::nullopt;
}

/// A node and all to which steps lead from it.
template <typename Steps>
std::set<std::uint32_t> reached(std::uint32_t node, const Steps& steps) {
  std::set<std::uint32_t> seen{node};
  std::vector<std::uint32_t> open{node};
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    for (const std::uint32_t next : steps(at)) {
      if (seen.insert(next).second) open.push_back(next);
    }
  }
  return seen;
}

}  // namespace

/// The classes of these nodes that the files name.
std::vector<std::string> AskedNames::names_in(const Hierarchy& hierarchy, const std::set<std::uint32_t>& nodes) const {
  const owl::Ontology& source = classified_.loaded.source;
  std::vector<std::string> names;
  for (const std::uint32_t node : nodes) {
    for (const std::uint32_t member : hierarchy.members[node]) {
      const std::string_view iri = hierarchy.iris[member];
      if (std::ranges::binary_search(classified_.classification.classes, iri, {},
                                     [&](owl::NameId name) { return source.name(name); }))
        names.emplace_back(iri);
    }
  }
  return names;
}

std::expected<owl::TermId, std::string> AskedNames::read(const graph::AskedExpression& asked) {
  const owl::Ontology& source = classified_.loaded.source;
  const Kinds kinds = kinds_in(source, asked);
  rdf::Graph triples;
  triples.begin_file();
  for (const auto& [subject, predicate, object] : asked.triples)
    triples.add({node_in(triples, subject), node_in(triples, predicate), node_in(triples, object)});
  for (const auto& [name, kinds_of_one] : kinds) {
    for (const owl::TermKind kind : kinds_of_one)
      triples.add({triples.iri(source.name(name)), rdf::node_of(syntax::Word::rdf_type),
                   node_in(triples, graph::type_of_entity(kind))});
  }
  const rdf::NodeId root = node_in(triples, asked.root);
  triples.index();
  owl::Ontology expression;
  const auto term = rdf::map_class_expression(triples, root, expression);
  if (!term) return term;
  if (auto unknown = unknown_name(expression, *term, source, kinds)) return std::unexpected(std::move(*unknown));
  return classified_.loaded.source.copy(expression, *term);
}

std::optional<std::string> AskedNames::find_instances(owl::TermId expression, graph::FoundNames& found) {
  realization::Options options{.budget = &budget_};
  options.progress = [&](std::string_view phase, double done) { progress_.show(phase, done); };
  owl::Ontology& source = classified_.loaded.source;
  const realization::Instances instances = realization::find_instances(source, expression, options);
  progress_.clear();
  if (!instances.is_consistent) return std::string(contradiction_words);
  if (!open_) open_ = describe_open(source, instances.undecided, instances.gaps);
  for (const owl::TermId individual : instances.found) found.instances.emplace_back(source.name_of(individual));
  return std::nullopt;
}

/// Classifies the files with a class that is equivalent to the expression.
std::optional<std::string> AskedNames::find_classes(owl::TermId expression, graph::FoundNames& found) {
  owl::Ontology& source = classified_.loaded.source;
  const std::string name = define_class(source, "about:expression", expression, owl::FileId{0});
  if (source.problem()) return source.problem();
  reasoner::Options options{.budget = &budget_};
  options.progress = [&](std::string_view phase, double done) { progress_.show(phase, done); };
  const auto classified = reasoner::classify(source, options);
  progress_.clear();
  if (!classified) return classified.error().text;
  if (!classified->is_consistent) return std::string(contradiction_words);
  if (!open_ && !classified->gaps.empty()) open_ = classified->gaps.front();
  const Hierarchy hierarchy = class_hierarchy(source, *classified);
  const auto place = std::ranges::find(hierarchy.iris, name);
  const std::uint32_t node = hierarchy.representative[static_cast<std::size_t>(place - hierarchy.iris.begin())];
  const base::Rows<std::uint32_t> children = children_of(hierarchy);
  auto below = reached(node, [&](std::uint32_t of) { return children[of]; });
  const std::uint32_t bottom = hierarchy.representative[hierarchy.bottom];
  below.insert(bottom);  // what can have no instance is below everything
  found.subclasses = names_in(hierarchy, below);
  if (node != bottom) std::erase(found.subclasses, std::string(owl::owl_nothing));
  auto above = reached(node, [&](std::uint32_t of) { return hierarchy.parents_of(of); });
  if (node != hierarchy.representative[hierarchy.top]) above.erase(hierarchy.representative[hierarchy.top]);
  found.superclasses = names_in(hierarchy, above);
  return std::nullopt;
}

std::expected<graph::FoundNames, std::string> AskedNames::find(const graph::AskedExpression& asked) {
  const auto expression = read(asked);
  if (!expression) return std::unexpected("a class expression of the query cannot be used: " + expression.error());
  graph::FoundNames found;
  std::optional<std::string> problem;
  if (asked.asks_instances) problem = find_instances(*expression, found);
  if (!problem && asked.asks_classes) problem = find_classes(*expression, found);
  if (problem) return std::unexpected(std::move(*problem));
  return found;
}

}  // namespace geminga::ontology
