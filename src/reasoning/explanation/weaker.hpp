// Axioms with less in them: the parts that one axiom consists of, and axioms that say less.
#ifndef GEMINGA_REASONING_EXPLANATION_WEAKER_HPP
#define GEMINGA_REASONING_EXPLANATION_WEAKER_HPP

#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::explanation {

/// An axiom that is not in a source yet.
struct Part {
  owl::AxiomKind kind = owl::AxiomKind::sub_class_of;
  std::vector<owl::TermId> arguments;
  friend bool operator==(const Part&, const Part&) = default;
};

/// Axioms that say together what this one says, as many as there are: `A EquivalentTo B and C` are `A SubClassOf B`,
/// `A SubClassOf C` and `B and C SubClassOf A`. One that has no parts is its own. Terms may be added to the source.
[[nodiscard]] std::vector<Part> parts_of(owl::Ontology& source, const owl::Axiom& axiom);

/// Axioms that follow from this one and say less, those that say least first: a class in it is left out, or replaced by
/// owl:Thing where more makes the axiom weaker, and a number of successors becomes 1. None follows from nothing. Terms
/// may be added to the source.
[[nodiscard]] std::vector<Part> weaker_forms(owl::Ontology& source, const Part& part);

}  // namespace geminga::explanation

#endif
