#include "reasoning/syntax/document/lists.hpp"

#include <string>

namespace geminga::document {
namespace {

using owl::TermKind;

constexpr std::string_view every_value = "http://www.w3.org/2000/01/rdf-schema#Literal";

}  // namespace

owl::TermId term_of_list(owl::Ontology& source, TermKind kind, std::span<const owl::TermId> operands, owl::FileId file,
                         std::uint32_t line) {
  const bool is_enumeration = kind == TermKind::object_one_of || kind == TermKind::data_one_of;
  const bool is_boolean = kind == TermKind::object_intersection_of || kind == TermKind::object_union_of ||
                          kind == TermKind::data_intersection_of || kind == TermKind::data_union_of;
  const bool is_argument = kind == TermKind::object_property_chain || kind == TermKind::datatype_restriction;
  const auto say = [&](std::string_view number, std::string_view meaning) {
    std::string text(owl::to_string(kind));
    source.remark(text.append(" of ").append(number).append(", read as ").append(meaning), file, line);
  };
  if (operands.size() == 1 && (is_boolean || is_argument)) {
    if (is_boolean) say("one operand", "that operand");
    return operands.front();
  }
  if (!operands.empty() || !(is_boolean || is_enumeration)) return source.term(kind, operands);
  const auto no_value = [&] { return source.term(TermKind::data_complement_of, {source.datatype(every_value)}); };
  switch (kind) {
    case TermKind::object_intersection_of:
      say("nothing", "owl:Thing");
      return owl::thing_term;
    case TermKind::data_intersection_of:
      say("nothing", "rdfs:Literal");
      return source.datatype(every_value);
    case TermKind::data_union_of:
    case TermKind::data_one_of:
      say("nothing", "no value");
      return no_value();
    default:
      say("nothing", "owl:Nothing");
      return owl::nothing_term;
  }
}

bool says_nothing(owl::Ontology& source, owl::AxiomKind kind, std::size_t operands, owl::FileId file,
                  std::uint32_t line) {
  constexpr std::size_t needed = 2;
  if (operands >= needed) return false;
  source.remark(std::string(owl::to_string(kind)) + " of fewer than two operands, which says nothing", file, line);
  return true;
}

void add_empty_union(owl::Ontology& source, owl::TermId named, owl::FileId file, std::uint32_t line) {
  source.remark("DisjointUnion of nothing, read as owl:Nothing", file, line);
  source.add(owl::AxiomKind::equivalent_classes, {named, owl::nothing_term}, file, line);
}

}  // namespace geminga::document
