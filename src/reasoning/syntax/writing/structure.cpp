#include "reasoning/syntax/writing/structure.hpp"

#include <span>

#include "reasoning/owl/annotation.hpp"
#include "reasoning/owl/datatypes.hpp"

namespace geminga::writing {
namespace {

using owl::Annotation;
using owl::AxiomKind;
using owl::TermKind;

bool is_counted(TermKind kind) {
  return (kind >= TermKind::object_min_cardinality && kind <= TermKind::object_exact_cardinality) ||
         (kind >= TermKind::data_min_cardinality && kind <= TermKind::data_exact_cardinality);
}

class Structure {
 public:
  Structure(const Document& document, Form& form, const Output& output)
      : document_(document), source_(document.source), form_(form), output_(output) {}

  void run() {
    const owl::Annotations& annotations = document_.annotations;
    const std::size_t count = document_.has_annotations ? annotations.size() : 0;
    form_.begin(document_);
    for (std::uint32_t number = 0; number < count; ++number) {
      if (is_of_ontology(document_, annotations.at(number))) annotation(number);
    }
    for (const std::uint32_t number : document_.axioms) {
      if (output_.has_failed()) return;
      axiom(source_.axiom(number), Annotation::Of::axiom, number);
    }
    for (std::uint32_t number = 0; document_.has_ill_typed && number < source_.ill_typed_count(); ++number)
      axiom(source_.ill_typed(number), Annotation::Of::ill_typed, number);
    for (std::uint32_t number = 0; number < count && !output_.has_failed(); ++number) {
      if (is_of_name(document_, annotations.at(number))) annotation_axiom(number);
    }
    form_.end();
  }

 private:
  void terms(std::span<const owl::TermId> ids) {
    for (const owl::TermId id : ids) term(id);
  }

  void term(owl::TermId id) {
    if (output_.has_failed()) return;
    const owl::Term term = source_.term(id);
    if (term.kind <= TermKind::individual) return form_.entity(term.kind, source_.name(term.name));
    switch (term.kind) {
      case TermKind::anonymous_individual:
        return form_.blank(source_.name(term.name));
      case TermKind::literal: {
        const bool has_language = term.arguments.size() == 2;
        return form_.literal(source_.name(term.name), source_.name_of(term.arguments[0]),
                             has_language ? source_.name_of(term.arguments[1]) : std::string_view());
      }
      case TermKind::variable:
        return form_.variable(source_.name(term.name));
      case TermKind::built_in_atom:
        form_.open_built_in(source_.name(term.name));
        terms(term.arguments);
        return form_.close(owl::to_string(term.kind));
      case TermKind::facet:
        form_.open_facet(source_.name(term.name));
        terms(term.arguments);
        return form_.close_facet();
      case TermKind::object_intersection_of:
      case TermKind::object_union_of:
      case TermKind::data_intersection_of:
      case TermKind::data_union_of:
        if (term.arguments.size() == 1) return this->term(term.arguments[0]);
        [[fallthrough]];
      case TermKind::object_one_of:
      case TermKind::data_one_of:
        if (term.arguments.empty()) return empty_set(term.kind);
        break;
      default:
        break;
    }
    const std::string_view word = owl::to_string(term.kind);
    form_.open(word, is_counted(term.kind) ? std::optional(term.number) : std::nullopt);
    terms(term.arguments);
    form_.close(word);
  }

  /// OWL 2 has no set of no operands, as OWL 1 had; names and a complement mean the same.
  void empty_set(TermKind kind) {
    if (kind < TermKind::data_intersection_of)
      return form_.entity(TermKind::named_class,
                          kind == TermKind::object_intersection_of ? owl::owl_thing : owl::owl_nothing);
    const std::string_view complement = owl::to_string(TermKind::data_complement_of);
    const bool is_complement = kind != TermKind::data_intersection_of;
    if (is_complement) form_.open(complement);
    form_.entity(TermKind::datatype, owl::rdfs_literal);
    if (is_complement) form_.close(complement);
  }

  /// A kind of axiom that is more than its word and operands has its place in this switch.
  void axiom(const owl::Axiom& axiom, Annotation::Of of, std::uint32_t number) {
    const std::string_view word = owl::to_string(axiom.kind);
    form_.open(word);
    if (document_.has_annotations) annotations(document_.annotations.about(of, number));
    switch (axiom.kind) {
      case AxiomKind::declaration:
        form_.declared(source_.kind(axiom.arguments[0]), source_.name_of(axiom.arguments[0]));
        break;
      case AxiomKind::has_key:
        key(axiom.arguments);
        break;
      case AxiomKind::dl_safe_rule:
        part_of_rule("Body", axiom.arguments[0]);
        part_of_rule("Head", axiom.arguments[1]);
        break;
      default:
        terms(axiom.arguments);
        break;
    }
    form_.close(word);
  }

  void key(std::span<const owl::TermId> arguments) {
    term(arguments[0]);
    for (const bool is_of_data : {false, true}) {
      form_.open_group();
      for (const owl::TermId property : arguments.subspan(1)) {
        if ((source_.kind(property) == TermKind::data_property) == is_of_data) term(property);
      }
      form_.close_group();
    }
  }

  void part_of_rule(std::string_view word, owl::TermId atoms) {
    form_.open(word);
    terms(source_.term(atoms).arguments);
    form_.close(word);
  }

  void annotations(std::span<const std::uint32_t> numbers) {
    for (const std::uint32_t number : numbers) annotation(number);
  }

  /// The readers bound how deep annotations nest.
  void annotation(std::uint32_t number) {
    const Annotation& annotation = document_.annotations.at(number);
    form_.open("Annotation");
    annotations(document_.annotations.about(Annotation::Of::annotation, number));
    form_.entity(TermKind::annotation_property, annotation.property);
    value(annotation);
    form_.close("Annotation");
  }

  void name_or_blank(std::string_view name) {
    if (name.starts_with("_:")) return form_.blank(name);
    form_.name(name);
  }

  void value(const Annotation& annotation) {
    if (annotation.is_literal) return form_.literal(annotation.value, annotation.datatype, annotation.language);
    name_or_blank(annotation.value);
  }

  void annotation_axiom(std::uint32_t number) {
    const Annotation& annotation = document_.annotations.at(number);
    const std::string_view word = owl::annotation_axiom_of(annotation);
    form_.open(word);
    annotations(document_.annotations.about(Annotation::Of::annotation, number));
    if (word == owl::annotation_assertion) {
      form_.entity(TermKind::annotation_property, annotation.property);
      name_or_blank(annotation.subject);
      value(annotation);
    } else {
      form_.entity(TermKind::annotation_property, annotation.subject);
      if (word == owl::sub_annotation_property_of) {
        form_.entity(TermKind::annotation_property, annotation.value);
      } else {
        form_.name(annotation.value);
      }
    }
    form_.close(word);
  }

  const Document& document_;
  const owl::Ontology& source_;
  Form& form_;
  const Output& output_;
};

}  // namespace

void write_structure(const Document& document, Form& form, const Output& output) {
  Structure(document, form, output).run();
}

}  // namespace geminga::writing
