// Writes terms recursively; tests nest them a few levels at most.
#include "reasoning/syntax/owlxml/writer.hpp"

namespace geminga::owlxml {
namespace {

using owl::TermKind;

class Writer {
 public:
  explicit Writer(const owl::Ontology& source) : source_(source) {}

  std::string document() const {
    std::string text = "<?xml version=\"1.0\"?>\n<Ontology xmlns=\"http://www.w3.org/2002/07/owl#\">\n";
    for (std::size_t number = 0; number < source_.axiom_count(); ++number) {
      const owl::Axiom axiom = source_.axiom(number);
      text += element(owl::to_string(axiom.kind), "", list(axiom.arguments)) + '\n';
    }
    return text + "</Ontology>\n";
  }

 private:
  static std::string escaped(std::string_view text) {
    std::string written;
    for (const char c : text) {
      if (c == '<' || c == '&' || c == '"') {
        written += c == '<' ? "&lt;" : c == '&' ? "&amp;" : "&quot;";
      } else {
        written += c;
      }
    }
    return written;
  }

  static std::string element(std::string_view name, std::string_view attributes, std::string_view content) {
    const std::string word(name);
    const std::string begin = '<' + word + std::string(attributes);
    return content.empty() ? begin + "/>" : begin + '>' + std::string(content) + "</" + word + '>';
  }

  static std::string attribute(std::string_view name, std::string_view value) {
    return ' ' + std::string(name) + "=\"" + escaped(value) + '"';
  }

  std::string list(std::span<const owl::TermId> terms) const {
    std::string text;
    for (const owl::TermId id : terms) text += term(id);
    return text;
  }

  std::string term(owl::TermId id) const {
    const owl::Term of = source_.term(id);
    const std::string_view name =
        of.kind <= TermKind::language_tag || of.kind == TermKind::facet ? source_.name(of.name) : std::string_view();
    switch (of.kind) {
      case TermKind::named_class:
        return element("Class", attribute("IRI", name), "");
      case TermKind::object_property:
        return element("ObjectProperty", attribute("IRI", name), "");
      case TermKind::data_property:
        return element("DataProperty", attribute("IRI", name), "");
      case TermKind::annotation_property:
        return element("AnnotationProperty", attribute("IRI", name), "");
      case TermKind::datatype:
        return element("Datatype", attribute("IRI", name), "");
      case TermKind::individual:
        return element("NamedIndividual", attribute("IRI", name), "");
      case TermKind::anonymous_individual:
        return element("AnonymousIndividual",
                       attribute("nodeID", "_:" + std::to_string(static_cast<unsigned>(of.name))), "");
      case TermKind::literal:
        if (of.arguments.size() == 2)
          return element("Literal", attribute("xml:lang", source_.name_of(of.arguments[1])), escaped(name));
        return element("Literal", attribute("datatypeIRI", source_.name_of(of.arguments[0])), escaped(name));
      case TermKind::facet:
        return element("FacetRestriction", attribute("facet", name), list(of.arguments));
      default:
        break;
    }
    const bool is_counted =
        (of.kind >= TermKind::object_min_cardinality && of.kind <= TermKind::object_exact_cardinality) ||
        (of.kind >= TermKind::data_min_cardinality && of.kind <= TermKind::data_exact_cardinality);
    return element(owl::to_string(of.kind), is_counted ? attribute("cardinality", std::to_string(of.number)) : "",
                   list(of.arguments));
  }

  const owl::Ontology& source_;
};

}  // namespace

std::string owl_xml(const owl::Ontology& source) { return Writer(source).document(); }

}  // namespace geminga::owlxml
