#include "triples.hpp"

#include <set>
#include <vector>

#include "graph/axiom_triples.hpp"
#include "output.hpp"

namespace geminga::ontology {
namespace {

using graph::Node;

/// Passes over the headers of all files but the first, and imports that a file answered.
class Header {
 public:
  explicit Header(const rdf::Loaded& loaded) : first_(ontology_name(loaded)) {
    for (const el::LoadedFile& file : loaded.source.files()) {
      if (!file.ontology_iri.empty() && file.ontology_iri != first_) others_.insert(file.ontology_iri);
    }
    for (const rdf::UnresolvedImport& import : loaded.unresolved) missing_.insert(import.iri);
  }

  [[nodiscard]] bool keeps(const Node& subject, std::string_view predicate, const Node& object) const {
    if (subject.kind == Node::Kind::iri && others_.contains(subject.text)) return false;
    return predicate != imports_ || missing_.contains(object.text);
  }

 private:
  std::string first_;
  std::set<std::string> others_;
  std::set<std::string> missing_;
  std::string imports_ = std::string(graph::owl_namespace) + "imports";
};

/// What files without triples say, their annotations, and imports that nobody answered.
void add_axioms(const rdf::Loaded& loaded, const std::vector<bool>& has_triples, graph::Graph& graph) {
  const el::OntologySource& source = loaded.source;
  const auto add = [&](const Node& s, const Node& p, const Node& o) { graph.add(s, p, o); };
  graph::AxiomTriples triples(source, add);
  for (std::size_t number = 0; number < source.axiom_count() && !graph.problem(); ++number) {
    const el::Axiom axiom = source.axiom(number);
    if (!has_triples[static_cast<std::size_t>(axiom.file)]) triples.add(axiom);
  }
  for (std::size_t number = 0; number < has_triples.size(); ++number) {
    const std::string& name = source.files()[number].ontology_iri;
    if (!has_triples[number] && !name.empty())
      graph.add(graph::iri(name), graph::iri(graph::rdf_type), graph::owl_word("Ontology"));
  }
  const std::string name = ontology_name(loaded);
  for (const rdf::UnresolvedImport& import : loaded.unresolved) {
    if (!name.empty()) graph.add(graph::iri(name), graph::owl_word("imports"), graph::iri(import.iri));
  }
  for (const el::Annotation& annotation : loaded.annotations) {
    const Node value = annotation.is_literal
                           ? Node{Node::Kind::literal, annotation.value,
                                  annotation.language.empty() ? annotation.datatype : "", annotation.language}
                           : graph::iri(annotation.value);
    graph.add(graph::iri(annotation.subject), graph::iri(annotation.property), value);
  }
}

}  // namespace

std::string ontology_name(const rdf::Loaded& loaded) {
  for (const el::LoadedFile& file : loaded.source.files()) {
    if (!file.ontology_iri.empty()) return file.ontology_iri;
  }
  return {};
}

std::optional<std::string> add_asserted(const rdf::Loaded& loaded, graph::Graph& graph) {
  const Header header(loaded);
  graph.set_filter([&](const Node& s, std::string_view p, const Node& o) { return header.keeps(s, p, o); });
  std::vector<bool> has_triples;
  bool have_all = true;
  for (std::size_t number = 0; number < loaded.syntaxes.size(); ++number) {
    has_triples.push_back(rdf::has_triples(loaded.syntaxes[number]));
    have_all = have_all && has_triples.back();
    if (!has_triples.back()) continue;
    if (const auto error = graph.add_file(loaded.source.files()[number].path, number)) return rdf::to_string(*error);
  }
  if (!have_all) add_axioms(loaded, has_triples, graph);
  graph.set_filter({});
  return graph.problem();
}

graph::Prefixes prefixes_of(const el::OntologySource& source) {
  graph::Prefixes prefixes;
  for (const el::OntologySource::Prefix& prefix : source.prefixes())
    prefixes.emplace_back(source.name(prefix.prefix), source.name(prefix.iri));
  return prefixes;
}

std::expected<graph::Format, std::string> chosen_format(const std::string& name, const std::string& out) {
  if (name.empty() && out == to_standard_output) return graph::Format::turtle;
  const auto format = name.empty() ? graph::format_of_file(out) : graph::find_format(name);
  if (format) return *format;
  return std::unexpected(name.empty() ? out + ": the name ends in none of .ttl, .nt, .owl, .rdf and .xml: write --to " +
                                            format_names
                                      : name + " is no format: write --to " + format_names);
}

}  // namespace geminga::ontology
