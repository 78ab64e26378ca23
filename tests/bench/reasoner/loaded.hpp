// Measurements of a compiled ontology inside this process: the first answer, subsumption, explanations, expressions.
#ifndef GEMINGA_TESTS_BENCH_REASONER_LOADED_HPP
#define GEMINGA_TESTS_BENCH_REASONER_LOADED_HPP

#include <filesystem>
#include <string>

namespace geminga::bench {

/// Prints its rows. Asks for `queries` random pairs, the same ones each time.
void measure_loaded(const std::filesystem::path& compiled, const std::string& name, const std::string& size,
                    std::size_t queries);

}  // namespace geminga::bench

#endif
