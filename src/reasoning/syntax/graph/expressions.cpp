#include "reasoning/syntax/graph/expressions.hpp"

#include <algorithm>
#include <utility>

#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"
#include "reasoning/syntax/graph/terms/literals.hpp"

namespace geminga::graph {
namespace {

/// The words that describe a class expression, of which each has one (mapping to RDF, table 13).
constexpr std::string_view constructors[] = {"onProperty",     "onProperties", "unionOf",
                                             "intersectionOf", "complementOf", "oneOf"};

bool is_type(const rasqal_triple& pattern) { return iri_of(pattern.predicate) == rdf_type; }

bool describes_class(const rasqal_triple& pattern) {
  const std::string_view predicate = iri_of(pattern.predicate);
  return predicate.starts_with(syntax::owl_namespace) &&
         std::ranges::find(constructors, predicate.substr(syntax::owl_namespace.size())) != std::end(constructors);
}

}  // namespace

std::optional<std::string> Expressions::read(const std::vector<rasqal_triple*>& patterns) {
  std::set<std::string_view> described;
  for (const rasqal_triple* pattern : patterns) {
    if (describes_class(*pattern)) described.insert(blank_name(pattern->subject));
  }
  described.erase(std::string_view());
  for (const rasqal_triple* pattern : patterns) {
    const std::string_view of = blank_name(pattern->object);
    if (is_type(*pattern) && described.contains(of)) roots_.emplace(of);
  }
  for (const std::string& root : roots_) {
    if (auto refusal = take(root, patterns)) return refusal;
  }
  for (const rasqal_triple* pattern : patterns) {
    const bool is_elsewhere = has_node(blank_name(pattern->object)) && !has_node(blank_name(pattern->subject)) &&
                              !(is_type(*pattern) && roots_.contains(blank_name(pattern->object)));
    if (is_elsewhere)
      return "a class expression may stand behind rdf:type alone: its blank nodes stand elsewhere, too, "
             "or ask --asserted only";
  }
  return std::nullopt;
}

/// Takes the patterns about a node, and about the blank nodes that they name.
std::optional<std::string> Expressions::take(std::string_view root, const std::vector<rasqal_triple*>& patterns) {
  AskedExpression& asked = asked_.emplace_back();
  asked.root = blank(std::string(root));
  std::vector<std::string> open{std::string(root)};
  std::set<std::string> seen{open.front()};
  while (!open.empty()) {
    const std::string subject = std::move(open.back());
    open.pop_back();
    nodes_.insert(subject);
    for (const rasqal_triple* pattern : patterns) {
      if (blank_name(pattern->subject) != subject) continue;
      const std::string_view predicate = iri_of(pattern->predicate);
      const std::string_view below = blank_name(pattern->object);
      const OwnedTerm object = below.empty() ? term_of(own_.world(), pattern->object) : nullptr;
      if (predicate.empty() || (below.empty() && object == nullptr))
        return "a variable stands in a class expression: write the name of what it stands for, or ask --asserted only";
      asked.triples.push_back(
          {blank(subject), iri(predicate), below.empty() ? node_of(*object) : blank(std::string(below))});
      if (!below.empty() && seen.emplace(below).second) open.emplace_back(below);
    }
  }
  return std::nullopt;
}

std::optional<std::string> Expressions::find(const FindInstances& find_instances) {
  const auto add = [&](const Node& subject, const Node& predicate, const Node& object) {
    return own_.add(subject, predicate, object);
  };
  bool has_room = true;
  for (const AskedExpression& asked : asked_) {
    const auto instances = find_instances(asked);
    if (!instances) return instances.error();
    for (const std::string& instance : *instances) has_room = has_room && add(iri(instance), iri(rdf_type), asked.root);
    for (const auto& [subject, predicate, object] : asked.triples)
      has_room = has_room && add(subject, predicate, object);
  }
  own_.sort();
  if (!has_room) return "memory is short";
  return std::nullopt;
}

bool Expressions::answers(const rasqal_triple& pattern) const {
  return has_node(blank_name(pattern.subject)) || (is_type(pattern) && roots_.contains(blank_name(pattern.object)));
}

}  // namespace geminga::graph
