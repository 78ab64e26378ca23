// The normal form of terms behind the canonical text.
#include "reasoning/syntax/manchester/canonical.hpp"

#include <utility>
#include <vector>

#include "base/sorted.hpp"
#include "reasoning/owl/print.hpp"

namespace geminga::manchester {
namespace {

using owl::Term;
using owl::TermId;
using owl::TermKind;

std::string text_in_full(const owl::Ontology& source, TermId id) {
  const auto full_name = [](std::string_view iri) { return "<" + std::string(iri) + ">"; };
  return owl::print(source, id, full_name, owl::PrintStyle::parsing);
}

bool is_set(TermKind kind) {
  return kind == TermKind::object_intersection_of || kind == TermKind::object_union_of ||
         kind == TermKind::data_intersection_of || kind == TermKind::data_union_of;
}

/// Copies a term into another source, arguments first. The nesting of terms bounds the recursion.
class Normaliser {
 public:
  Normaliser(const owl::Ontology& from, owl::Ontology& to) : from_(from), to_(to) {}

  TermId copy(TermId id) {
    const Term term = from_.term(id);
    std::vector<TermId> arguments;
    for (const TermId argument : term.arguments) {
      const TermId copied = copy(argument);
      // A member of the same kind is replaced by its own members.
      if (is_set(term.kind) && to_.kind(copied) == term.kind) {
        const auto members = to_.term(copied).arguments;
        arguments.insert(arguments.end(), members.begin(), members.end());
      } else {
        arguments.push_back(copied);
      }
    }
    if (is_set(term.kind) || term.kind == TermKind::object_one_of || term.kind == TermKind::data_one_of) {
      sort(arguments, 0);
    }
    if (term.kind == TermKind::datatype_restriction) sort(arguments, 1);
    if (is_set(term.kind) && arguments.size() == 1) return arguments.front();
    const bool is_cardinality =
        term.kind >= TermKind::object_min_cardinality && term.kind <= TermKind::object_exact_cardinality;
    if (is_cardinality && arguments.size() == 2 && arguments[1] == owl::thing_term) arguments.pop_back();
    return to_.copy(term.kind, from_.name(term.name), term.number, arguments);
  }

 private:
  void sort(std::vector<TermId>& terms, std::size_t from) const {
    std::vector<std::pair<std::string, TermId>> texts;
    for (const TermId id : std::span(terms).subspan(from)) texts.emplace_back(text_in_full(to_, id), id);
    base::sort_unique(texts);
    terms.resize(from);
    for (const auto& [text, id] : texts) terms.push_back(id);
  }

  const owl::Ontology& from_;
  owl::Ontology& to_;
};

}  // namespace

std::string canonical(const owl::Ontology& source, owl::TermId term) {
  owl::Ontology normal;
  const TermId id = Normaliser(source, normal).copy(term);
  return text_in_full(normal, id);
}

}  // namespace geminga::manchester
