// The ontology that the matcher is measured with: a complete tree of classes.
#ifndef GEMINGA_TESTS_BENCH_MATCHING_TREE_HPP
#define GEMINGA_TESTS_BENCH_MATCHING_TREE_HPP

#include <cstdint>
#include <string>

#include "base/random.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::matching {

/// How many classes are right below each class that is not at the bottom.
inline constexpr std::uint32_t branching = 4;

/// How many classes the tree of this run has: as many as the largest published ontologies, or in a small run as the
/// ontology of a team.
[[nodiscard]] std::uint32_t tree_size();

/// The IRI of a class. Class 0 is the root, and a class has a greater number than those above it.
[[nodiscard]] std::string class_iri(std::uint32_t number);
[[nodiscard]] constexpr std::uint32_t class_above(std::uint32_t number) { return (number - 1) / branching; }

/// The tree, classified at the first call.
[[nodiscard]] const vocabulary::Vocabulary& tree();

/// The last class of the tree, which is at the bottom.
[[nodiscard]] std::uint32_t rare_class();
/// A random class at the bottom, but not the rare one or one of its three sisters.
[[nodiscard]] std::uint32_t common_class(base::Random& random);

}  // namespace geminga::matching

#endif
