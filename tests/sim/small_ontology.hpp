// Small ontologies that are made in memory, for tests that need names and subsumption but no files.
#ifndef GEMINGA_TESTS_SIM_SMALL_ONTOLOGY_HPP
#define GEMINGA_TESTS_SIM_SMALL_ONTOLOGY_HPP

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::sim {

/// `soccer` (see small_ontology.cpp for its classes), or `ballless`: the same without soccer:Ball and everything below;
/// `sensors`, for class expressions, `other-sensors` with soccer:Sonar, or `blind`: without soccer:Ball;
/// `misspelt`, with soccer:Bal;
/// `deep`, for long proofs. `tree`: soccer:C0 to soccer:C1110, where Ci is above C(10 i + 1) to C(10 i + 10);
/// `other-tree` has one class more.
/// `frames`, for conversions, or `other-frames`: over another chain of the same cost.
/// `units`, with the unit `pitch` of 105 m, or `other-units`, where it is 50 m.
/// `damaged` is `sensors` from a compiled form whose axioms are damaged.
/// Without an ontology for `none`.
[[nodiscard]] vocabulary::Vocabulary small_ontology(std::string_view name);
/// The same as gemingad maps it from a file.
[[nodiscard]] std::optional<std::vector<std::byte>> compiled_small_ontology(std::string_view name);

}  // namespace geminga::sim

#endif
