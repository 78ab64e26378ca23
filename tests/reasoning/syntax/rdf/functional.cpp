// Writes terms recursively; tests nest them a few levels at most.
#include "reasoning/syntax/rdf/functional.hpp"

#include <map>

#include "reasoning/owl/unit.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::rdf {
namespace {

class Writer {
 public:
  explicit Writer(const owl::Ontology& source) : source_(source) {}

  std::string axiom(const owl::Axiom& axiom) {
    std::string text(owl::to_string(axiom.kind));
    return text + arguments(axiom.arguments, "");
  }

 private:
  std::string arguments(std::span<const owl::TermId> terms, std::string head) {
    std::string text = "(" + std::move(head);
    for (const owl::TermId id : terms) text += (text.size() == 1 ? "" : " ") + term(id);
    return text + ")";
  }

  std::string iri(std::string_view name) {
    constexpr std::string_view here = "http://e/";
    if (name.starts_with(here)) return ':' + std::string(name.substr(here.size()));
    return syntax::short_word(name);
  }

  std::string term(owl::TermId id) {
    const owl::Term term = source_.term(id);
    const std::string_view name = source_.name(term.name);
    switch (term.kind) {
      case owl::TermKind::literal: {
        std::string text = '"' + std::string(name) + '"';
        if (term.arguments.size() == 2) return text + '@' + std::string(source_.name_of(term.arguments[1]));
        const std::string datatype = this->term(term.arguments[0]);
        return datatype == "xsd:string" ? text : text + "^^" + datatype;
      }
      case owl::TermKind::facet:
        return iri(name) + ' ' + this->term(term.arguments[0]);
      case owl::TermKind::anonymous_individual:
        return "_:" + std::to_string(blanks_.try_emplace(std::string(name), blanks_.size() + 1).first->second);
      default:
        if (term.kind <= owl::TermKind::individual) return iri(name);
        if (term.kind == owl::TermKind::variable) return '?' + iri(name);
        break;
    }
    const bool is_counted =
        (term.kind >= owl::TermKind::object_min_cardinality && term.kind <= owl::TermKind::object_exact_cardinality) ||
        (term.kind >= owl::TermKind::data_min_cardinality && term.kind <= owl::TermKind::data_exact_cardinality);
    if (term.kind == owl::TermKind::built_in_atom) return "BuiltInAtom" + arguments(term.arguments, iri(name));
    return std::string(owl::to_string(term.kind)) +
           arguments(term.arguments, is_counted ? std::to_string(term.number) : "");
  }

  const owl::Ontology& source_;
  std::map<std::string, std::size_t> blanks_;
};

}  // namespace

std::vector<std::string> functional(const owl::Ontology& source, bool with_declarations) {
  Writer writer(source);
  std::vector<std::string> lines;
  for (std::size_t index = 0; index < source.axiom_count(); ++index) {
    const owl::Axiom axiom = source.axiom(index);
    if (axiom.kind != owl::AxiomKind::declaration || with_declarations) lines.push_back(writer.axiom(axiom));
  }
  return lines;
}

std::vector<std::string> functional_with_left_out(const owl::Ontology& source) {
  std::vector<std::string> lines = functional(source, true);
  for (const owl::Ontology::Omission& omission : source.omissions())
    lines.push_back("left out: " + std::string(source.name(omission.construct)) + ", " +
                    std::to_string(omission.count) + ", line " + std::to_string(omission.line));
  return lines;
}

std::vector<std::string> labels(const owl::Ontology& source) {
  std::vector<std::string> lines;
  for (const owl::Ontology::Label& label : source.labels()) {
    const std::string language(source.name(label.language));
    lines.push_back(std::string(source.name(label.entity)) + ' ' + std::string(source.name(label.text)) +
                    (language.empty() ? "" : '@' + language));
  }
  return lines;
}

std::vector<std::string> conversions(const owl::Ontology& source) {
  std::vector<std::string> lines;
  for (const owl::Ontology::Conversion& one : source.conversions()) {
    lines.push_back(std::string(source.name(one.from)) + " > " + std::string(source.name(one.to)) + ' ' +
                    std::to_string(one.cost) + ", line " + std::to_string(one.line));
  }
  return lines;
}

std::vector<std::string> unit_names(const owl::Ontology& source) {
  const owl::DeclaredUnits declared = owl::units_of(source);
  std::vector<std::string> lines;
  for (const owl::UnitName& name : declared.names) {
    lines.push_back(name.text + ' ' + std::to_string(static_cast<int>(declared.units[name.unit].factor)));
  }
  return lines;
}

}  // namespace geminga::rdf
