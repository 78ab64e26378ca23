// What branches: published ontologies beyond OWL 2 EL, and made-up ones of the shapes that take every combination where
// cases are derived; one thread of ours beside two of Konclude's.
#ifndef GEMINGA_TESTS_BENCH_REASONER_HARD_HPP
#define GEMINGA_TESTS_BENCH_REASONER_HARD_HPP

#include <filesystem>
#include <string>

namespace geminga::bench {

struct HardSettings {
  bool is_smoke = false;         ///< small shapes only, one run each
  std::string program;           ///< geminga-ontology
  std::filesystem::path folder;  ///< to write to
  std::filesystem::path data;    ///< whose folder ontologies/tbox-hard has the published ones; empty: there are none
};

/// Prints three rows for each ontology: elapsed time, which must be within Konclude's, processor time, and peak memory,
/// which must be half of Konclude's. Where Konclude is not installed, ours alone.
void measure_hard(const HardSettings& settings);

}  // namespace geminga::bench

#endif
