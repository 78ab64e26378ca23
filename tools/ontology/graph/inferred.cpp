#include "ontology/graph/inferred.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/budget.hpp"
#include "ontology/graph/document.hpp"
#include "ontology/loading/hierarchy.hpp"
#include "reasoning/owl/left_out.hpp"
#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::ontology {
namespace {

using graph::iri;
using graph::Node;

/// The predicates of one hierarchy.
struct Predicates {
  std::string below;
  std::string equal;
};

class Writer {
 public:
  Writer(bool as_closure, base::Budget& budget, graph::Graph& graph)
      : as_closure_(as_closure), steps_(&budget), graph_(graph) {}

  /// Whether the budget ended the work.
  [[nodiscard]] bool is_spent() const { return is_spent_; }

  void write(const Hierarchy& hierarchy, const Predicates& words) {
    for (std::uint32_t node = 0; node < hierarchy.members.row_count() && goes_on(); ++node) {
      if (hierarchy.members[node].empty()) continue;
      if (node == hierarchy.representative[hierarchy.bottom]) {
        write_empty(hierarchy, words);
      } else {
        write_node(hierarchy, node, words);
      }
    }
  }

  /// Writes the types of individuals, and which are the same.
  void write(const owl::Ontology& source, const Hierarchy& classes, const taxonomy::Classification& classification,
             const realization::Realization& realization) {
    const std::string same = std::string(syntax::owl_namespace) + "sameAs";
    std::vector<std::vector<std::string_view>> things(realization.individuals.size());
    for (std::uint32_t at = 0; at < things.size() && goes_on(); ++at) {
      const std::string_view individual = source.name_of(realization.individuals[at]);
      things[realization.representative[at]].push_back(individual);
      const auto& all = realization.type_sets[realization.types[at]];
      for (const taxonomy::ClassNumber of : as_closure_ ? all : realization::most_specific(classification, all)) {
        for (const std::string_view type : names(classes, static_cast<std::uint32_t>(of))) {
          if (!goes_on()) return;
          link(individual, graph::rdf_type, type);
        }
      }
      if (!as_closure_) continue;
      for (const std::string_view type : names(classes, classes.representative[classes.top])) {
        if (type != owl::owl_thing) link(individual, graph::rdf_type, type);
      }
    }
    for (const auto& names_of_one : things) write_equal(names_of_one, same);
  }
  void write(const owl::Ontology& source, const std::vector<realization::Fact>& facts) {
    const std::set<realization::Fact> stated = stated_with_language(source);
    for (const realization::Fact& fact : facts) {
      if (!goes_on()) return;
      if (!stated.contains(fact))
        graph_.add(iri(source.name_of(fact.subject)), iri(source.name_of(fact.property)), node_of(source, fact.object));
    }
  }

 private:
  /// The facts with a language that files state. Their triples may have its tag in other letters, upper or lower.
  static std::set<realization::Fact> stated_with_language(const owl::Ontology& source) {
    std::set<realization::Fact> stated;
    for (std::uint32_t number = 0; number < source.axiom_count(); ++number) {
      const owl::Axiom axiom = source.axiom(number);
      if (axiom.kind != owl::AxiomKind::data_property_assertion) continue;
      if (source.term(axiom.arguments[2]).arguments.size() > 1)
        stated.insert({axiom.arguments[1], axiom.arguments[0], axiom.arguments[2]});
    }
    return stated;
  }

  static Node node_of(const owl::Ontology& source, owl::TermId object) {
    const owl::Term term = source.term(object);
    Node node = iri(source.name(term.name));
    if (term.kind != owl::TermKind::literal) return node;
    node.kind = Node::Kind::literal;
    if (term.arguments.size() > 1) {
      node.language = source.name_of(term.arguments[1]);
    } else {
      node.datatype = source.name_of(term.arguments[0]);
    }
    return node;
  }

  /// Counts a step. False where a limit was reached.
  bool goes_on() {
    if (!steps_.spend(1)) is_spent_ = true;
    return !is_spent_ && !graph_.problem();
  }

  static std::vector<std::string_view> names(const Hierarchy& hierarchy, std::uint32_t node) {
    std::vector<std::string_view> found;
    for (const std::uint32_t member : hierarchy.members[node]) found.push_back(hierarchy.iris[member]);
    return found;
  }

  /// The nodes right above a node, or all above it; without the top one.
  std::vector<std::uint32_t> above(const Hierarchy& hierarchy, std::uint32_t node) {
    std::vector<std::uint32_t> found;
    std::set<std::uint32_t> seen{node};
    std::vector<std::uint32_t> stack{node};
    while (!stack.empty() && goes_on()) {
      const std::uint32_t at = stack.back();
      stack.pop_back();
      for (const std::uint32_t parent : hierarchy.parents_of(at)) {
        if (!seen.insert(parent).second || parent == hierarchy.representative[hierarchy.top]) continue;
        found.push_back(parent);
        if (as_closure_) stack.push_back(parent);
      }
    }
    std::ranges::sort(found);
    return found;
  }

  void link(std::string_view subject, std::string_view predicate, std::string_view object) {
    graph_.add(iri(subject), iri(predicate), iri(object));
  }

  /// Links equal names: each with the next, or each with each.
  void write_equal(const std::vector<std::string_view>& names, std::string_view predicate) {
    for (std::size_t a = 0; a < names.size(); ++a) {
      for (std::size_t b = 0; b < names.size(); ++b) {
        if (!goes_on()) return;
        if (a != b && (as_closure_ || b == a + 1)) link(names[a], predicate, names[b]);
      }
    }
  }

  void write_node(const Hierarchy& hierarchy, std::uint32_t node, const Predicates& words) {
    const auto classes = names(hierarchy, node);
    write_equal(classes, words.equal);
    if (as_closure_) write_equal(classes, words.below);
    for (const std::uint32_t parent : above(hierarchy, node)) {
      const auto supers = names(hierarchy, parent);
      // Of equivalent superclasses one is enough where only direct relations are written.
      const std::size_t count = as_closure_ ? supers.size() : std::min<std::size_t>(supers.size(), 1);
      for (std::size_t at = 0; at < count; ++at) {
        for (const std::string_view name : classes) {
          if (!goes_on()) return;
          link(name, words.below, supers[at]);
        }
      }
    }
  }

  /// Writes the names that can have no instance.
  void write_empty(const Hierarchy& hierarchy, const Predicates& words) {
    const std::string_view bottom = hierarchy.iris[hierarchy.bottom];
    for (const std::uint32_t member : hierarchy.members[hierarchy.representative[hierarchy.bottom]]) {
      if (member != hierarchy.bottom) link(hierarchy.iris[member], words.below, bottom);
    }
  }

  const bool as_closure_;
  base::BudgetUse steps_;
  graph::Graph& graph_;
  bool is_spent_ = false;
};

}  // namespace

std::optional<std::string> add_inferred(const ClassifiedFiles& classified, const realization::Realization& realization,
                                        bool as_closure, base::Budget& budget, graph::Graph& graph) {
  const owl::Ontology& source = classified.loaded.source;
  const taxonomy::Classification& classification = classified.classification;
  const std::string owl(syntax::owl_namespace);
  Writer writer(as_closure, budget, graph);
  const Hierarchy classes = class_hierarchy(source, classification);
  writer.write(classes, {std::string(graph::rdfs_sub_class_of), owl + "equivalentClass"});
  writer.write(source, classes, classification, realization);
  writer.write(source, realization.facts);
  const auto properties = [&](const taxonomy::PropertyTaxonomy& taxonomy) {
    writer.write(property_hierarchy(source, taxonomy, classification.is_consistent),
                 {std::string(graph::rdfs_sub_property_of), owl + "equivalentProperty"});
  };
  properties(classification.object_properties);
  properties(classification.data_properties);
  if (!writer.is_spent()) return std::nullopt;
  return "more relations follow than can be written: give fewer files, or ask for less (without --closure)";
}

std::optional<std::string> add_declarations(ClassifiedFiles& classified, graph::Graph& graph) {
  owl::Ontology& source = classified.loaded.source;
  const std::vector<std::uint32_t> names = add_declarations(add_inferred_axioms(graph, classified), source);
  if (source.problem()) return source.problem();
  graph::AxiomTriples triples(source, [&](const Node& s, const Node& p, const Node& o) { graph.add(s, p, o); });
  for (const std::uint32_t number : names) triples.add(source.axiom(number));
  return graph.problem();
}

std::optional<std::string> why_incomplete(const ClassifiedFiles& classified) {
  const auto& classification = classified.classification;
  const auto left_out = taxonomy::left_out(classified.loaded.source, classification);
  if (!left_out.empty()) return left_out.front().construct + " was not used, first at " + left_out.front().first;
  if (!classification.gaps.empty()) return classification.gaps.front();
  return std::nullopt;
}

}  // namespace geminga::ontology
