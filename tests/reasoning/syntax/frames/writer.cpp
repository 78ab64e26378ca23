// Writes terms recursively; tests nest them a few levels at most.
#include "reasoning/syntax/frames/writer.hpp"

#include <map>

namespace geminga::frames {
namespace {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

class Writer {
 public:
  explicit Writer(const owl::Ontology& source) : source_(source) {}

  std::string document() const {
    std::string text = "Ontology: <http://random.example/>\n";
    std::string declarations;
    for (std::size_t number = 0; number < source_.axiom_count(); ++number) {
      const owl::Axiom axiom = source_.axiom(number);
      (axiom.kind == AxiomKind::declaration ? declarations : text) += frame(axiom) + '\n';
    }
    return text + declarations;
  }

 private:
  std::string list(std::span<const TermId> terms, std::string_view separator) const {
    std::string text;
    for (const TermId id : terms) text += (text.empty() ? "" : std::string(separator)) + term(id);
    return text;
  }

  std::string literal(const owl::Term& of) const {
    std::string text = "\"";
    for (const char c : source_.name(of.name)) {
      if (c == '"' || c == '\\') text += '\\';
      text += c;
    }
    text += '"';
    if (of.arguments.size() == 2) return text + '@' + std::string(source_.name_of(of.arguments[1]));
    return text + "^^" + term(of.arguments[0]);
  }

  std::string restriction(const owl::Term& of, std::string_view word) const {
    std::string text = '(' + term(of.arguments[0]) + ' ' + std::string(word);
    const bool is_counted = word == "min" || word == "max" || word == "exactly";
    if (is_counted) text += ' ' + std::to_string(of.number);
    return text + (of.arguments.size() > 1 ? ' ' + term(of.arguments[1]) : "") + ')';
  }

  std::string facets(const owl::Term& of) const {
    static const std::map<std::string, std::string, std::less<>> words{
        {"minInclusive", ">="}, {"maxInclusive", "<="}, {"minExclusive", ">"}, {"maxExclusive", "<"}};
    std::string text = term(of.arguments[0]) + '[';
    for (std::size_t at = 1; at < of.arguments.size(); ++at) {
      const std::string_view iri = source_.name_of(of.arguments[at]);
      const std::string_view local = iri.substr(iri.find('#') + 1);
      const auto word = words.find(local);
      text += (at == 1 ? "" : ", ") + (word == words.end() ? std::string(local) : word->second) + ' ' +
              term(source_.term(of.arguments[at]).arguments[0]);
    }
    return text + ']';
  }

  std::string term(TermId id) const {
    const owl::Term of = source_.term(id);
    switch (of.kind) {
      case TermKind::literal:
        return literal(of);
      case TermKind::anonymous_individual:
        return "_:b" + std::to_string(static_cast<unsigned>(of.name));
      case TermKind::object_inverse_of:
        return "inverse (" + term(of.arguments[0]) + ')';
      case TermKind::object_property_chain:
        return list(of.arguments, " o ");
      case TermKind::object_intersection_of:
      case TermKind::data_intersection_of:
        return '(' + list(of.arguments, " and ") + ')';
      case TermKind::object_union_of:
      case TermKind::data_union_of:
        return '(' + list(of.arguments, " or ") + ')';
      case TermKind::object_complement_of:
      case TermKind::data_complement_of:
        return "(not " + term(of.arguments[0]) + ')';
      case TermKind::object_one_of:
      case TermKind::data_one_of:
        return '{' + list(of.arguments, ", ") + '}';
      case TermKind::object_some_values_from:
      case TermKind::data_some_values_from:
        return restriction(of, "some");
      case TermKind::object_all_values_from:
      case TermKind::data_all_values_from:
        return restriction(of, "only");
      case TermKind::object_has_value:
      case TermKind::data_has_value:
        return restriction(of, "value");
      case TermKind::object_has_self:
        return restriction(of, "Self");
      case TermKind::object_min_cardinality:
      case TermKind::data_min_cardinality:
        return restriction(of, "min");
      case TermKind::object_max_cardinality:
      case TermKind::data_max_cardinality:
        return restriction(of, "max");
      case TermKind::object_exact_cardinality:
      case TermKind::data_exact_cardinality:
        return restriction(of, "exactly");
      case TermKind::datatype_restriction:
        return facets(of);
      default:
        return '<' + std::string(source_.name(of.name)) + '>';
    }
  }

  /// `Class: FIRST SubClassOf: SECOND`.
  std::string section(std::string_view frame, TermId first, std::string_view word, std::string_view rest) const {
    return std::string(frame) + ' ' + term(first) + "\n    " + std::string(word) + ' ' + std::string(rest);
  }

  std::string frame(const owl::Axiom& axiom) const {
    static const std::map<TermKind, std::string_view> frames{
        {TermKind::named_class, "Class:"},          {TermKind::object_property, "ObjectProperty:"},
        {TermKind::data_property, "DataProperty:"}, {TermKind::annotation_property, "AnnotationProperty:"},
        {TermKind::datatype, "Datatype:"},          {TermKind::individual, "Individual:"},
    };
    const auto of = axiom.arguments;
    const auto property = [&](std::string_view word, std::string_view rest) {
      return section("ObjectProperty:", of[0], word, rest);
    };
    const auto data = [&](std::string_view word, std::string_view rest) {
      return section("DataProperty:", of[0], word, rest);
    };
    const auto fact = [&](std::string_view sign) {
      return section("Individual:", of[1], "Facts:", std::string(sign) + term(of[0]) + ' ' + term(of[2]));
    };
    switch (axiom.kind) {
      case AxiomKind::declaration:
        return std::string(frames.at(source_.kind(of[0]))) + ' ' + term(of[0]);
      case AxiomKind::sub_class_of:
        return section("Class:", of[0], "SubClassOf:", term(of[1]));
      case AxiomKind::equivalent_classes:
        return "EquivalentClasses: " + list(of, ", ");
      case AxiomKind::disjoint_classes:
        return "DisjointClasses: " + list(of, ", ");
      case AxiomKind::disjoint_union:
        return section("Class:", of[0], "DisjointUnionOf:", list(of.subspan(1), ", "));
      case AxiomKind::sub_object_property_of:
        if (source_.kind(of[0]) == TermKind::object_property_chain)
          return section("ObjectProperty:", of[1], "SubPropertyChain:", term(of[0]));
        return property("SubPropertyOf:", term(of[1]));
      case AxiomKind::equivalent_object_properties:
      case AxiomKind::equivalent_data_properties:
        return "EquivalentProperties: " + list(of, ", ");
      case AxiomKind::disjoint_object_properties:
      case AxiomKind::disjoint_data_properties:
        return "DisjointProperties: " + list(of, ", ");
      case AxiomKind::inverse_object_properties:
        return property("InverseOf:", term(of[1]));
      case AxiomKind::object_property_domain:
        return property("Domain:", term(of[1]));
      case AxiomKind::object_property_range:
        return property("Range:", term(of[1]));
      case AxiomKind::functional_object_property:
        return property("Characteristics:", "Functional");
      case AxiomKind::inverse_functional_object_property:
        return property("Characteristics:", "InverseFunctional");
      case AxiomKind::reflexive_object_property:
        return property("Characteristics:", "Reflexive");
      case AxiomKind::irreflexive_object_property:
        return property("Characteristics:", "Irreflexive");
      case AxiomKind::symmetric_object_property:
        return property("Characteristics:", "Symmetric");
      case AxiomKind::asymmetric_object_property:
        return property("Characteristics:", "Asymmetric");
      case AxiomKind::transitive_object_property:
        return property("Characteristics:", "Transitive");
      case AxiomKind::sub_data_property_of:
        return data("SubPropertyOf:", term(of[1]));
      case AxiomKind::data_property_domain:
        return data("Domain:", term(of[1]));
      case AxiomKind::data_property_range:
        return data("Range:", term(of[1]));
      case AxiomKind::functional_data_property:
        return data("Characteristics:", "Functional");
      case AxiomKind::datatype_definition:
        return section("Datatype:", of[0], "EquivalentTo:", term(of[1]));
      case AxiomKind::has_key:
        return section("Class:", of[0], "HasKey:", list(of.subspan(1), ", "));
      case AxiomKind::same_individual:
        return "SameIndividual: " + list(of, ", ");
      case AxiomKind::different_individuals:
        return "DifferentIndividuals: " + list(of, ", ");
      case AxiomKind::class_assertion:
        return section("Individual:", of[1], "Types:", term(of[0]));
      case AxiomKind::object_property_assertion:
      case AxiomKind::data_property_assertion:
        return fact("");
      case AxiomKind::negative_object_property_assertion:
      case AxiomKind::negative_data_property_assertion:
        return fact("not ");
      case AxiomKind::dl_safe_rule:
        break;
    }
    return {};
  }

  const owl::Ontology& source_;
};

}  // namespace

std::string manchester(const owl::Ontology& source) { return Writer(source).document(); }

}  // namespace geminga::frames
