// A saturated ontology with its index, and a validator that fires every rule again.
#ifndef GEMINGA_TESTS_REASONING_EL_SATURATED_HPP
#define GEMINGA_TESTS_REASONING_EL_SATURATED_HPP

#include <memory>
#include <string>

#include "reasoning/el/closure/saturation.hpp"
#include "reasoning/el/index/indexed_ontology.hpp"
#include "reasoning/el/normaliser/rule_normaliser.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::el {

/// The contexts of all named classes and individuals of a source, saturated by a number of threads.
struct Saturated {
  Saturated(const owl::Ontology& source, unsigned threads, const SaturationLimits& limits = {});
  IndexedOntology index;
  std::unique_ptr<Saturation> saturation;
};

/// Describes a premise whose conclusion is missing; empty if no rule is left to fire. It is slow and simple, and shares
/// no code with the rules.
std::string rule_left_to_fire(const IndexedOntology& index, const Saturation& saturation);

}  // namespace geminga::el

#endif
