#include "reasoning/dl/clauses/fact_clauses.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "base/sorted.hpp"

namespace geminga::clauses {

using owl::AxiomKind;
using owl::TermId;

FactClauses::FactClauses(Vocabulary& vocabulary, Translator& translator, ClauseSet& set, std::size_t max_equalities,
                         std::span<const OrderedAxiom> axioms)
    : vocabulary_(vocabulary), translator_(translator), set_(set), max_equalities_(max_equalities) {
  for (const OrderedAxiom& axiom : axioms) {
    if (axiom.kind != AxiomKind::different_individuals || axiom.arguments.size() <= max_paired_individuals) continue;
    if (longest_ == nullptr || axiom.arguments.size() > longest_->arguments.size()) longest_ = &axiom;
  }
}

// The longest list alone has no pairs, because a node has one group of siblings (dl/hypertableau).
void FactClauses::add_different(const OrderedAxiom& axiom) {
  std::vector<IndividualId> different;
  for (const TermId argument : axiom.arguments) different.push_back(vocabulary_.individual(argument));
  std::vector<IndividualId> sorted = different;
  base::sort_unique(sorted);
  if (&axiom == longest_ && sorted.size() == different.size()) {
    set_.apart = std::move(sorted);
    return;
  }
  for (std::size_t first = 0; first < different.size(); ++first) {
    for (std::size_t second = first + 1; second < different.size(); ++second) {
      if (set_.equalities.size() > max_equalities_) return;
      set_.equalities.push_back({different[first], different[second], true});
    }
  }
}

void FactClauses::assert_fact(Literal literal, IndividualId individual) {
  const Shape shape = shape_of(vocabulary_.source(), literal);
  if (shape.kind == ShapeKind::all_of) {
    for (const Literal operand : shape.operands) assert_fact(operand, individual);
    return;
  }
  const ConceptId id = translator_.below(literal);
  if (id != thing) set_.concept_facts.push_back({id, individual});
}

void FactClauses::add(const OrderedAxiom& axiom) {
  const auto& arguments = axiom.arguments;
  switch (axiom.kind) {
    case AxiomKind::class_assertion:
      assert_fact(positive(arguments[0]), vocabulary_.individual(arguments[1]));
      return;
    case AxiomKind::object_property_assertion: {
      const Role role = translator_.role(arguments[0]);
      RoleFact fact{role.property, vocabulary_.individual(arguments[1]), vocabulary_.individual(arguments[2])};
      if (role.is_inverse) std::swap(fact.first, fact.second);
      set_.role_facts.push_back(fact);
      return;
    }
    case AxiomKind::negative_object_property_assertion:  // a is not in  some R.{b}
      translator_.add_every(vocabulary_.role(arguments[0]), negative(arguments[2]), negative(arguments[1]));
      return;
    case AxiomKind::data_property_assertion:
      set_.data_facts.push_back(
          {vocabulary_.data_property(arguments[0]), vocabulary_.individual(arguments[1]), arguments[2]});
      return;
    case AxiomKind::negative_data_property_assertion: {  // {a}(x), U(x,v) -> (not {value})(v)
      const DataRangeId others = vocabulary_.data_range({arguments[2], true});
      const std::uint32_t nominal = number(vocabulary_.concept_of(arguments[1]));
      translator_.add_clause({{{AtomKind::concept_of, centre, centre, nominal},
                               {AtomKind::data_role, centre, 1, number(vocabulary_.data_property(arguments[0]))}},
                              {{AtomKind::data_range, 1, centre, number(others)}}});
      return;
    }
    case AxiomKind::same_individual:
      for (const TermId other : std::span(arguments).subspan(1)) {
        set_.equalities.push_back({vocabulary_.individual(arguments[0]), vocabulary_.individual(other), false});
      }
      return;
    case AxiomKind::different_individuals:
      return add_different(axiom);
    default:
      return;
  }
}

}  // namespace geminga::clauses
