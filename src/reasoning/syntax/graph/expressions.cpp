#include "reasoning/syntax/graph/expressions.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"
#include "reasoning/syntax/graph/terms/literals.hpp"

namespace geminga::graph {
namespace {

/// The words that describe a class expression, of which each has one (mapping to RDF, table 13).
constexpr std::string_view constructors[] = {"onProperty",     "onProperties", "unionOf",
                                             "intersectionOf", "complementOf", "oneOf"};

bool is_type(const rasqal_triple& pattern) { return iri_of(pattern.predicate) == rdf_type; }

/// Whether it relates two classes in a way that the reasoner knows of class expressions.
bool relates_classes(const rasqal_triple& pattern) {
  const std::string_view predicate = iri_of(pattern.predicate);
  return predicate == rdfs_sub_class_of || predicate == owl("equivalentClass");
}

bool describes_class(const rasqal_triple& pattern) {
  const std::string_view predicate = iri_of(pattern.predicate);
  return predicate.starts_with(syntax::owl_namespace) &&
         std::ranges::find(constructors, predicate.substr(syntax::owl_namespace.size())) != std::end(constructors);
}

/// The class expressions that patterns name beside the words that ask for names, still without triples.
std::map<std::string_view, AskedExpression> named_expressions(const std::vector<rasqal_triple*>& patterns) {
  std::set<std::string_view> described;
  for (const rasqal_triple* pattern : patterns) {
    if (describes_class(*pattern)) described.insert(blank_name(pattern->subject));
  }
  described.erase(std::string_view());
  std::map<std::string_view, AskedExpression> named;
  for (const rasqal_triple* pattern : patterns) {
    const std::string_view subject = blank_name(pattern->subject);
    const std::string_view object = blank_name(pattern->object);
    if (is_type(*pattern) && described.contains(object)) named[object].asks_instances = true;
    if (!relates_classes(*pattern)) continue;
    for (const std::string_view label : {subject, object}) {
      if (described.contains(label)) named[label].asks_classes = true;
    }
  }
  for (auto& [label, expression] : named) expression.root = blank(std::string(label));
  return named;
}

}  // namespace

std::optional<std::string> Expressions::read(const Patterns& patterns) {
  for (auto& [label, expression] : named_expressions(patterns)) {
    if (add_triples(patterns, expression)) {
      roots_.emplace(label);
      for (const auto& triple : expression.triples) nodes_.insert(triple.subject.text);
      asked_.push_back(std::move(expression));
    } else if (expression.asks_instances) {
      return "a variable stands in a class expression: write the name of what it stands for, or ask --asserted only";
    }
  }
  has_asserted_ = std::ranges::any_of(patterns, [&](const rasqal_triple* pattern) {
    const std::string_view label = blank_name(pattern->subject);
    return describes_class(*pattern) && !label.empty() && !has_node(label);
  });
  for (const rasqal_triple* pattern : patterns) {
    const bool is_within = has_node(blank_name(pattern->subject));
    const bool is_named = has_node(blank_name(pattern->object));
    if (relates_classes(*pattern) && is_within && is_named)
      return "a query does not compare two class expressions: ask geminga-ontology subsumes";
    if (is_named && !is_within && !asks_names(*pattern))
      return "a class expression may stand beside rdf:type, rdfs:subClassOf and owl:equivalentClass alone: its blank "
             "nodes stand elsewhere, too, or ask --asserted only";
  }
  return std::nullopt;
}

bool Expressions::asks_names(const rasqal_triple& pattern) const {
  if (is_type(pattern)) return roots_.contains(blank_name(pattern.object));
  return relates_classes(pattern) &&
         (roots_.contains(blank_name(pattern.subject)) || roots_.contains(blank_name(pattern.object)));
}

/// Adds the patterns about the root, and about the blank nodes that they name. False if a variable stands there.
bool Expressions::add_triples(const Patterns& patterns, AskedExpression& expression) const {
  std::vector<std::string> open{expression.root.text};
  std::set<std::string> seen{open.front()};
  while (!open.empty()) {
    const std::string subject = std::move(open.back());
    open.pop_back();
    for (const rasqal_triple* pattern : patterns) {
      if (blank_name(pattern->subject) != subject || relates_classes(*pattern)) continue;
      const std::string_view predicate = iri_of(pattern->predicate);
      const std::string_view below = blank_name(pattern->object);
      const OwnedTerm object = below.empty() ? term_of(own_.world(), pattern->object) : nullptr;
      if (predicate.empty() || (below.empty() && object == nullptr)) return false;
      expression.triples.push_back(
          {blank(subject), iri(predicate), below.empty() ? node_of(*object) : blank(std::string(below))});
      if (!below.empty() && seen.emplace(below).second) open.emplace_back(below);
    }
  }
  return true;
}

std::optional<std::string> Expressions::find(const FindNames& find_names) {
  bool has_room = true;
  const auto add = [&](const Node& subject, const Node& predicate, const Node& object) {
    has_room = has_room && own_.add(subject, predicate, object);
  };
  for (const AskedExpression& asked : asked_) {
    const auto names = find_names(asked);
    if (!names) return names.error();
    for (const std::string& instance : names->instances) add(iri(instance), iri(rdf_type), asked.root);
    for (const std::string& below : names->subclasses) add(iri(below), iri(rdfs_sub_class_of), asked.root);
    for (const std::string& above : names->superclasses) {
      add(asked.root, iri(rdfs_sub_class_of), iri(above));
      if (std::ranges::find(names->subclasses, above) == names->subclasses.end()) continue;
      add(asked.root, owl_word("equivalentClass"), iri(above));
      add(iri(above), owl_word("equivalentClass"), asked.root);
    }
    for (const auto& [subject, predicate, object] : asked.triples) add(subject, predicate, object);
  }
  own_.sort();
  if (!has_room) return "memory is short";
  return std::nullopt;
}

bool Expressions::answers(const rasqal_triple& pattern) const {
  return has_node(blank_name(pattern.subject)) || asks_names(pattern);
}

}  // namespace geminga::graph
