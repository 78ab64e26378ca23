#include "ontology/graph/document.hpp"

#include <numeric>
#include <set>
#include <string>

#include "ontology/graph/asserted.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/graph/axioms/axiom_triples.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::ontology {
namespace {

using graph::Node;
using owl::AxiomKind;
using owl::TermId;

/// The axiom that a relation between names is.
class Relations {
 public:
  explicit Relations(ClassifiedFiles& classified) : source_(classified.loaded.source) {
    for (const owl::NameId name : classified.classification.data_properties.properties)
      data_properties_.emplace(source_.name(name));
  }

  void add(const Node& subject, const Node& predicate, const Node& object) {
    const std::string_view word = predicate.text;
    if (word == graph::rdfs_sub_class_of) return add_classes(AxiomKind::sub_class_of, subject, object);
    if (word == owl_ + "equivalentClass") return add_classes(AxiomKind::equivalent_classes, subject, object);
    if (word == graph::rdfs_sub_property_of)
      return add_properties(AxiomKind::sub_object_property_of, AxiomKind::sub_data_property_of, subject, object);
    if (word == owl_ + "equivalentProperty")
      return add_properties(AxiomKind::equivalent_object_properties, AxiomKind::equivalent_data_properties, subject,
                            object);
    if (word == owl_ + "sameAs") {
      source_.add(AxiomKind::same_individual, {source_.individual(subject.text), source_.individual(object.text)},
                  owl::FileId{0}, 0);
    } else if (word == graph::rdf_type) {
      source_.add(AxiomKind::class_assertion, {source_.named_class(object.text), source_.individual(subject.text)},
                  owl::FileId{0}, 0);
    } else {
      add_fact(subject, predicate, object);
    }
  }

 private:
  void add_classes(AxiomKind kind, const Node& sub, const Node& super) {
    source_.add(kind, {source_.named_class(sub.text), source_.named_class(super.text)}, owl::FileId{0}, 0);
  }

  void add_properties(AxiomKind of_objects, AxiomKind of_data, const Node& sub, const Node& super) {
    const bool is_of_data = data_properties_.contains(sub.text) && data_properties_.contains(super.text);
    const auto property = [&](const std::string& iri) {
      return is_of_data ? source_.data_property(iri) : source_.object_property(iri);
    };
    source_.add(is_of_data ? of_data : of_objects, {property(sub.text), property(super.text)}, owl::FileId{0}, 0);
  }

  void add_fact(const Node& subject, const Node& predicate, const Node& object) {
    const TermId individual = source_.individual(subject.text);
    if (object.kind == Node::Kind::literal) {
      source_.add(AxiomKind::data_property_assertion,
                  {source_.data_property(predicate.text), individual,
                   source_.literal(object.text, object.datatype, object.language)},
                  owl::FileId{0}, 0);
    } else {
      source_.add(AxiomKind::object_property_assertion,
                  {source_.object_property(predicate.text), individual, source_.individual(object.text)},
                  owl::FileId{0}, 0);
    }
  }

  owl::Ontology& source_;
  const std::string owl_ = std::string(syntax::owl_namespace);
  std::set<std::string, std::less<>> data_properties_;
};

std::vector<std::uint32_t> numbers_from(std::size_t first, const owl::Ontology& source) {
  std::vector<std::uint32_t> numbers(source.axiom_count() - first);
  std::iota(numbers.begin(), numbers.end(), static_cast<std::uint32_t>(first));
  return numbers;
}

}  // namespace

writing::Document document_of(const rdf::Loaded& loaded, const owl::Annotations& annotations) {
  writing::Document document{loaded.source, annotations, ontology_name(loaded), {}, {}, numbers_from(0, loaded.source)};
  for (std::uint32_t number = 0; number < annotations.size(); ++number) {
    const owl::Annotation& annotation = annotations.at(number);
    const bool is_version = annotation.of == owl::Annotation::Of::ontology &&
                            annotation.property == writing::version_property && !annotation.is_literal;
    if (is_version && loaded.source.files()[annotation.number].ontology_iri == document.iri)
      document.version_iri = annotation.value;
  }
  for (const rdf::UnresolvedImport& import : loaded.unresolved) document.imports.push_back(import.iri);
  return document;
}

std::vector<std::uint32_t> add_inferred_axioms(const graph::Graph& inferred, ClassifiedFiles& classified) {
  const std::size_t first = classified.loaded.source.axiom_count();
  Relations relations(classified);
  inferred.for_each([&](const Node& subject, const Node& predicate, const Node& object) {
    relations.add(subject, predicate, object);
  });
  return numbers_from(first, classified.loaded.source);
}

std::vector<std::uint32_t> add_declarations(const std::vector<std::uint32_t>& axioms, owl::Ontology& source) {
  const std::size_t first = source.axiom_count();
  std::set<TermId> names;
  for (const std::uint32_t number : axioms) {
    for (const TermId argument : source.axiom(number).arguments)
      names.insert(source.kind(argument) == owl::TermKind::literal ? source.term(argument).arguments[0] : argument);
  }
  for (const TermId name : names) {
    if (!is_of_w3c(source.name_of(name))) source.add(AxiomKind::declaration, {name}, owl::FileId{0}, 0);
  }
  return numbers_from(first, source);
}

}  // namespace geminga::ontology
