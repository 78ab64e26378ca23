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

/// How many classes trees have in this run: as many as a large team's ontologies, or as the largest published ones.
inline constexpr std::uint32_t small_tree = 1365;
inline constexpr std::uint32_t large_tree = 349'525;

/// Class 0 is the root, and what is above a class has a lesser number.
[[nodiscard]] std::string class_iri(std::uint32_t number);
[[nodiscard]] constexpr std::uint32_t class_above(std::uint32_t number) { return (number - 1) / branching; }

/// Classified when it is first asked for.
[[nodiscard]] const vocabulary::Vocabulary& tree(std::uint32_t class_count);

/// The class at the end of a tree, which is at the bottom.
[[nodiscard]] constexpr std::uint32_t rare_class(std::uint32_t class_count) { return class_count - 1; }
/// Any class at the bottom but that one and its three sisters.
[[nodiscard]] std::uint32_t common_class(std::uint32_t class_count, base::Random& random);

}  // namespace geminga::matching

#endif
