// One function a kind of term.
#include "manchester/print.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace geminga::manchester {
namespace {

using el::Term;
using el::TermId;
using el::TermKind;

constexpr std::array<std::pair<std::string_view, std::string_view>, 9> facets{{
    {"http://www.w3.org/2001/XMLSchema#maxInclusive", "<="},
    {"http://www.w3.org/2001/XMLSchema#maxExclusive", "<"},
    {"http://www.w3.org/2001/XMLSchema#minInclusive", ">="},
    {"http://www.w3.org/2001/XMLSchema#minExclusive", ">"},
    {"http://www.w3.org/2001/XMLSchema#length", "length"},
    {"http://www.w3.org/2001/XMLSchema#minLength", "minLength"},
    {"http://www.w3.org/2001/XMLSchema#maxLength", "maxLength"},
    {"http://www.w3.org/2001/XMLSchema#pattern", "pattern"},
    {"http://www.w3.org/1999/02/22-rdf-syntax-ns#langRange", "langRange"},
}};

class Printer {
 public:
  Printer(const el::OntologySource& source, const ShortName& short_name) : source_(source), short_name_(short_name) {}

  std::string term(TermId id) const;

 private:
  std::string nested(TermId id) const;
  std::string members(std::span<const TermId> terms, std::string_view between) const;
  std::string literal(const Term& term) const;
  std::string cardinality(const Term& term, std::string_view word) const;
  std::string datatype_restriction(const Term& term) const;

  const el::OntologySource& source_;
  const ShortName& short_name_;
};

std::string Printer::nested(TermId id) const {
  const TermKind kind = source_.kind(id);
  const bool is_bare = kind <= TermKind::literal || kind == TermKind::object_one_of || kind == TermKind::data_one_of ||
                       kind == TermKind::datatype_restriction || kind == TermKind::object_inverse_of;
  return is_bare ? term(id) : "(" + term(id) + ")";
}

std::string Printer::members(std::span<const TermId> terms, std::string_view between) const {
  std::string text;
  for (const TermId id : terms) {
    if (!text.empty()) text += between;
    text += nested(id);
  }
  return text;
}

std::string Printer::literal(const Term& term) const {
  std::string text = "\"";
  for (const char character : source_.name(term.name)) {
    if (character == '"' || character == '\\') text += '\\';
    text += character;
  }
  text += '"';
  if (term.arguments.size() == 2) return text + "@" + std::string(source_.name_of(term.arguments[1]));
  const std::string_view datatype = source_.name_of(term.arguments[0]);
  if (datatype == "http://www.w3.org/2001/XMLSchema#string") return text;
  return text + "^^" + short_name_(datatype);
}

std::string Printer::cardinality(const Term& term, std::string_view word) const {
  std::string text = nested(term.arguments[0]) + " " + std::string(word) + " " + std::to_string(term.number);
  return term.arguments.size() == 2 ? text + " " + nested(term.arguments[1]) : text;
}

std::string Printer::datatype_restriction(const Term& term) const {
  std::string text = this->term(term.arguments[0]) + "[";
  for (const TermId id : term.arguments.subspan(1)) {
    const Term facet = source_.term(id);
    std::string word = short_name_(source_.name(facet.name));
    for (const auto& [iri, written] : facets) {
      if (iri == source_.name(facet.name)) word = written;
    }
    if (text.back() != '[') text += ", ";
    text += word + " " + this->term(facet.arguments[0]);
  }
  return text + "]";
}

std::string Printer::term(TermId id) const {
  const Term term = source_.term(id);
  const auto arguments = term.arguments;
  const auto restriction = [&](std::string_view word) {
    return nested(arguments[0]) + " " + std::string(word) + " " + nested(arguments[1]);
  };
  switch (term.kind) {
    case TermKind::literal:
      return literal(term);
    case TermKind::object_inverse_of:
      return "inverse " + nested(arguments[0]);
    case TermKind::object_intersection_of:
    case TermKind::data_intersection_of:
      return arguments.empty() ? short_name_(el::owl_thing) : members(arguments, " and ");
    case TermKind::object_union_of:
    case TermKind::data_union_of:
      return arguments.empty() ? short_name_(el::owl_nothing) : members(arguments, " or ");
    case TermKind::object_complement_of:
    case TermKind::data_complement_of:
      return "not " + nested(arguments[0]);
    case TermKind::object_one_of:
    case TermKind::data_one_of:
      return "{" + members(arguments, ", ") + "}";
    case TermKind::object_some_values_from:
    case TermKind::data_some_values_from:
      return restriction("some");
    case TermKind::object_all_values_from:
    case TermKind::data_all_values_from:
      return restriction("only");
    case TermKind::object_has_value:
    case TermKind::data_has_value:
      return restriction("value");
    case TermKind::object_has_self:
      return nested(arguments[0]) + " Self";
    case TermKind::object_min_cardinality:
    case TermKind::data_min_cardinality:
      return cardinality(term, "min");
    case TermKind::object_max_cardinality:
    case TermKind::data_max_cardinality:
      return cardinality(term, "max");
    case TermKind::object_exact_cardinality:
    case TermKind::data_exact_cardinality:
      return cardinality(term, "exactly");
    case TermKind::datatype_restriction:
      return datatype_restriction(term);
    default:
      return short_name_(source_.name(term.name));
  }
}

}  // namespace

std::string print(const el::OntologySource& source, el::TermId term, const ShortName& short_name) {
  return Printer(source, short_name).term(term);
}

}  // namespace geminga::manchester
