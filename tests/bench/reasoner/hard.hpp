// Ontologies that branch: published ones beyond OWL 2 EL, and made-up ones of shapes in which deriving by cases takes
// every combination. One thread of ours is measured beside two of Konclude's.
#ifndef GEMINGA_TESTS_BENCH_REASONER_HARD_HPP
#define GEMINGA_TESTS_BENCH_REASONER_HARD_HPP

#include <filesystem>
#include <string>

namespace geminga::bench {

struct HardSettings {
  bool is_smoke = false;         ///< small shapes only, one run each
  std::string program;           ///< geminga-ontology
  std::filesystem::path folder;  ///< the folder to write to
  std::filesystem::path data;    ///< has the published ones in ontologies/tbox-hard; empty: there are none
};

/// Prints three rows for each ontology: elapsed time, which must be within Konclude's; processor time; and peak memory,
/// which must be half of Konclude's. Prints ours alone if Konclude is not installed.
void measure_hard(const HardSettings& settings);

}  // namespace geminga::bench

#endif
