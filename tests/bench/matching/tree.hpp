// The ontology that the matcher is measured with: a complete tree of classes.
#ifndef GEMINGA_TESTS_BENCH_MATCHING_TREE_HPP
#define GEMINGA_TESTS_BENCH_MATCHING_TREE_HPP

#include <cstdint>
#include <string>

#include "base/random.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// Every class has so many right below it, but for those at the bottom.
inline constexpr std::uint32_t branching = 4;

/// How many classes the tree of this run has: as many as the largest published ontologies, or in a small run as a
/// team's.
[[nodiscard]] std::uint32_t tree_size();

/// Class 0 is the root, and what is above a class has a lesser number.
[[nodiscard]] std::string class_iri(std::uint32_t number);
[[nodiscard]] constexpr std::uint32_t class_above(std::uint32_t number) { return (number - 1) / branching; }

/// Classified when it is first asked for.
[[nodiscard]] const vocabulary::Vocabulary& tree();

/// The class at the end of the tree, which is at the bottom.
[[nodiscard]] std::uint32_t rare_class();
/// Any class at the bottom but that one and its three sisters.
[[nodiscard]] std::uint32_t common_class(base::Random& random);

}  // namespace geminga::matching

#endif
