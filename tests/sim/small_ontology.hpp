// Small ontologies that are made in memory, for tests that need names and subsumption but no files.
#ifndef GEMINGA_TESTS_SIM_SMALL_ONTOLOGY_HPP
#define GEMINGA_TESTS_SIM_SMALL_ONTOLOGY_HPP

#include <memory>
#include <string_view>

#include "reasoning/compiled/ontology.hpp"

namespace geminga::sim {

/// `soccer` (see small_ontology.cpp for its classes), or `ballless`: the same without soccer:Ball and everything below;
/// `sensors`, for class expressions, or `blind`: the same without soccer:Ball.
/// `damaged` is `sensors` from a compiled form whose axioms are damaged.
/// Each lives as long as the program, so that a participant can borrow it. Null for `none`.
[[nodiscard]] const compiled::Ontology* small_ontology(std::string_view name);

/// As a participant takes it, of one that outlives the participant.
[[nodiscard]] inline std::shared_ptr<const compiled::Ontology> unowned(const compiled::Ontology* ontology) {
  return {std::shared_ptr<void>(), ontology};
}

}  // namespace geminga::sim

#endif
