#include "ontology/graph/asserted.hpp"

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/owl/prefixes/prefixes.hpp"
#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::ontology {
namespace {

using graph::Node;

/// Leaves out the headers of all files but the first, and the imports that a file answered.
class Header {
 public:
  explicit Header(const rdf::Loaded& loaded) : first_(ontology_name(loaded)) {
    for (const owl::LoadedFile& file : loaded.source.files()) {
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
  std::string imports_ = std::string(syntax::owl_namespace) + "imports";
};

/// Adds the axioms and annotations of files without triples, and the imports that no file answered.
class OtherFiles {
 public:
  OtherFiles(const rdf::Loaded& loaded, const std::vector<bool>& has_triples, graph::Graph& graph)
      : loaded_(loaded),
        has_triples_(has_triples),
        graph_(graph),
        triples_(loaded.source, [this](const Node& s, const Node& p, const Node& o) { graph_.add(s, p, o); }),
        annotations_(loaded.annotations) {
    for (const owl::LoadedFile& file : loaded.source.files()) {
      if (file.ontology_iri != name_) others_.insert(file.ontology_iri);
    }
  }

  void add() {
    const owl::Ontology& source = loaded_.source;
    using Of = owl::Annotation::Of;
    for (std::uint32_t number = 0; number < source.axiom_count() && !graph_.problem(); ++number)
      add(source.axiom(number), Of::axiom, number);
    // Axioms with an ill-typed literal are written as they were read.
    for (std::uint32_t number = 0; number < source.ill_typed_count() && !graph_.problem(); ++number)
      add(source.ill_typed(number), Of::ill_typed, number);
    add_headers();
    declare_names();
    for (std::uint32_t number = 0; number < annotations_.size() && !graph_.problem(); ++number) {
      const owl::Annotation& annotation = annotations_.at(number);
      const bool is_of_name = annotation.of == Of::name && !is_other(annotation.subject);
      const bool is_of_ontology = annotation.of == Of::ontology && !is_other(iri_of(annotation.number));
      if (is_of_name || is_of_ontology) triples_.add(annotations_, number);
    }
  }

 private:
  void add(const owl::Axiom& axiom, owl::Annotation::Of of, std::uint32_t number) {
    if (has_triples_[static_cast<std::size_t>(axiom.file)]) return;
    triples_.add(axiom);
    triples_.annotate(annotations_, annotations_.about(of, number));
  }

  [[nodiscard]] const std::string& iri_of(std::size_t file) const { return loaded_.source.files()[file].ontology_iri; }
  /// Whether this names another ontology than the one that is written.
  [[nodiscard]] bool is_other(const std::string& iri) const { return others_.contains(iri); }

  void add_headers() {
    for (std::size_t number = 0; number < has_triples_.size(); ++number) {
      const bool is_said =
          !iri_of(number).empty() ||
          !annotations_.about(owl::Annotation::Of::ontology, static_cast<std::uint32_t>(number)).empty();
      if (!has_triples_[number] && is_said && !is_other(iri_of(number)))
        graph_.add(triples_.ontology(static_cast<owl::FileId>(number)), graph::iri(graph::rdf_type),
                   graph::owl_word("Ontology"));
    }
    for (const rdf::UnresolvedImport& import : loaded_.unresolved) {
      if (!name_.empty()) graph_.add(graph::iri(name_), graph::owl_word("imports"), graph::iri(import.iri));
    }
  }

  /// Declares properties and datatypes that no file declares: by their declarations alone triples say which axioms they
  /// are (OWL 2 mapping to RDF, section 3.1.2).
  void declare_names() {
    const owl::Ontology& source = loaded_.source;
    std::set<owl::TermId> declared;
    for (std::uint32_t number = 0; number < source.axiom_count(); ++number) {
      const owl::Axiom& axiom = source.axiom(number);
      if (axiom.kind == owl::AxiomKind::declaration) declared.insert(axiom.arguments[0]);
    }
    for (std::uint32_t number = 0; number < source.term_count() && !graph_.problem(); ++number) {
      const owl::TermId id{number};
      const owl::TermKind kind = source.kind(id);
      const bool is_told_apart = kind == owl::TermKind::object_property || kind == owl::TermKind::data_property ||
                                 kind == owl::TermKind::datatype;
      if (is_told_apart && !declared.contains(id) && !is_of_w3c(source.name_of(id)))
        triples_.add({.kind = owl::AxiomKind::declaration, .arguments = std::span(&id, 1)});
    }
    declare_annotation_properties();
  }

  /// Without a declaration rdfs:subPropertyOf, rdfs:domain and rdfs:range say something of another property, and a fact
  /// of an individual might be meant. A name that is another property as well stays that one.
  void declare_annotation_properties() {
    const owl::Ontology& source = loaded_.source;
    std::set<std::string_view> known;
    for (std::uint32_t number = 0; number < source.term_count(); ++number) {
      const owl::TermKind kind = source.kind(owl::TermId{number});
      if (kind == owl::TermKind::object_property || kind == owl::TermKind::data_property)
        known.insert(source.name_of(owl::TermId{number}));
    }
    const auto declare = [&](std::string_view name) {
      if (is_of_w3c(name) || !known.insert(name).second) return;
      graph_.add(graph::iri(std::string(name)), graph::iri(graph::rdf_type),
                 graph::type_of_entity(owl::TermKind::annotation_property));
    };
    for (std::uint32_t number = 0; number < annotations_.size() && !graph_.problem(); ++number) {
      const owl::Annotation& annotation = annotations_.at(number);
      declare(annotation.property);
      if (annotation.of != owl::Annotation::Of::name) continue;
      const std::string_view word = owl::annotation_axiom_of(annotation);
      if (word != owl::annotation_assertion) declare(annotation.subject);
      if (word == owl::sub_annotation_property_of) declare(annotation.value);
    }
  }

  const rdf::Loaded& loaded_;
  const std::vector<bool>& has_triples_;
  graph::Graph& graph_;
  graph::AxiomTriples triples_;
  const owl::Annotations annotations_;
  const std::string name_ = ontology_name(loaded_);
  std::set<std::string> others_;  ///< the names of other ontologies than the one that is written
};

}  // namespace

bool is_of_w3c(std::string_view name) {
  return name.starts_with(syntax::rdf_namespace) || name.starts_with(syntax::rdfs_namespace) ||
         name.starts_with(syntax::xsd_namespace) || name.starts_with(syntax::owl_namespace);
}

std::string ontology_name(const rdf::Loaded& loaded) {
  for (const owl::LoadedFile& file : loaded.source.files()) {
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
    has_triples.push_back(syntax::has_triples(loaded.syntaxes[number]));
    have_all = have_all && has_triples.back();
    if (!has_triples.back()) continue;
    if (const auto error = graph.add_file(loaded.source.files()[number].path, number)) return syntax::to_string(*error);
  }
  if (!have_all) OtherFiles(loaded, has_triples, graph).add();
  graph.set_filter({});
  return graph.problem();
}

graph::Prefixes prefixes_of(const owl::Ontology& source) {
  graph::Prefixes prefixes;
  for (const owl::Ontology::Prefix& prefix : source.prefixes())
    prefixes.emplace_back(source.name(prefix.prefix), source.name(prefix.iri));
  return prefixes;
}

graph::Prefixes found_prefixes_of(const owl::Ontology& source) { return owl::Prefixes(source).all(); }

}  // namespace geminga::ontology
