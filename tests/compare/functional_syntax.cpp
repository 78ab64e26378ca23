#include "compare/functional_syntax.hpp"

#include <map>
#include <string_view>

namespace geminga::compare {
namespace {

using owl::AxiomKind;
using owl::Term;
using owl::TermId;
using owl::TermKind;

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

std::string in_brackets(std::string_view iri) { return '<' + std::string(iri) + '>'; }

/// The word for a declaration of an entity; empty for what is none.
std::string_view declared_as(TermKind kind) {
  switch (kind) {
    case TermKind::named_class:
      return "Class";
    case TermKind::object_property:
      return "ObjectProperty";
    case TermKind::data_property:
      return "DataProperty";
    case TermKind::datatype:
      return "Datatype";
    case TermKind::individual:
      return "NamedIndividual";
    default:
      return {};
  }
}

bool is_built_in(std::string_view iri) {
  return iri.starts_with("http://www.w3.org/2002/07/owl#") || iri.starts_with("http://www.w3.org/2001/XMLSchema#") ||
         iri.starts_with("http://www.w3.org/1999/02/22-rdf-syntax-ns#") ||
         iri.starts_with("http://www.w3.org/2000/01/rdf-schema#");
}

class Writer {
 public:
  explicit Writer(const owl::Ontology& source) : source_(source) {}

  std::string document() {
    text_ = "Ontology(\n";
    for (std::uint32_t id = 0; id < source_.term_count(); ++id) declare(TermId{id});
    for (std::size_t at = 0; at < source_.axiom_count(); ++at) axiom(source_.axiom(at));
    return text_ + ")\n";
  }

 private:
  void declare(TermId id) {
    const std::string_view word = declared_as(source_.kind(id));
    if (word.empty() || is_built_in(source_.name_of(id))) return;
    ((((text_ += "Declaration(") += word) += '(') += in_brackets(source_.name_of(id))) += "))\n";
  }

  void axiom(const owl::Axiom& axiom) {
    if (axiom.kind == AxiomKind::declaration) return;
    const bool is_key = axiom.kind == AxiomKind::has_key;
    (text_ += to_string(axiom.kind)) += '(';
    if (is_key) {
      key(axiom);
    } else {
      list(axiom.arguments);
    }
    text_ += ")\n";
  }

  /// HasKey(class (object properties) (data properties))
  void key(const owl::Axiom& axiom) {
    term(axiom.arguments.front());
    for (const bool is_data : {false, true}) {
      text_ += is_data ? ")(" : " (";
      for (const TermId property : axiom.arguments.subspan(1)) {
        if ((source_.kind(property) == TermKind::data_property) != is_data) continue;
        term(property);
        text_ += ' ';
      }
    }
    text_ += ')';
  }

  void list(std::span<const TermId> terms) {
    for (std::size_t at = 0; at < terms.size(); ++at) {
      if (at != 0) text_ += ' ';
      term(terms[at]);
    }
  }

  // Terms nest at most SourceLimits::nesting deep.
  void term(TermId id) {
    const Term term = source_.term(id);
    const std::string_view name = source_.name(term.name);
    switch (term.kind) {
      case TermKind::literal:
        text_ += quoted(name);
        if (term.arguments.size() > 1) {
          (text_ += '@') += source_.name_of(term.arguments[1]);
        } else {
          (text_ += "^^") += in_brackets(source_.name_of(term.arguments[0]));
        }
        return;
      case TermKind::anonymous_individual:
        text_ += "_:b" + std::to_string(blank_.try_emplace(id, blank_.size()).first->second);
        return;
      case TermKind::facet:
        (text_ += in_brackets(name)) += ' ';
        list(term.arguments);
        return;
      default:
        break;
    }
    if (term.arguments.empty()) {
      text_ += in_brackets(name);
      return;
    }
    (text_ += to_string(term.kind)) += '(';
    if (is_cardinality(term.kind)) text_ += std::to_string(term.number) + ' ';
    list(term.arguments);
    text_ += ')';
  }

  static bool is_cardinality(TermKind kind) {
    return (kind >= TermKind::object_min_cardinality && kind <= TermKind::object_exact_cardinality) ||
           (kind >= TermKind::data_min_cardinality && kind <= TermKind::data_exact_cardinality);
  }

  const owl::Ontology& source_;
  std::string text_;
  std::map<TermId, std::size_t> blank_;
};

}  // namespace

std::string functional_syntax(const owl::Ontology& source) { return Writer(source).document(); }

}  // namespace geminga::compare
