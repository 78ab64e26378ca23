// Ontologies of the shapes that published ones have and that take every combination where cases are derived.
#ifndef GEMINGA_TESTS_COMPARE_SHAPES_HPP
#define GEMINGA_TESTS_COMPARE_SHAPES_HPP

#include <cstdint>

#include "reasoning/owl/source.hpp"

namespace geminga::compare {

/// How a covering axiom is written.
enum class Covering : std::uint8_t { disjoint_union, all_disjoint, pairwise_disjoint };

/// A tree of `classes` classes C0, C1, ..., each the union of its children, which are `width` and disjoint. A child
/// that is alone is a subclass.
[[nodiscard]] owl::Ontology covering_tree(Covering covering, std::size_t classes, std::size_t width);

/// A is empty, as `holes` holes are one too few for what is in it; B, with one hole more, is not.
[[nodiscard]] owl::Ontology pigeonhole(std::size_t holes);

/// The class Unit of typed individuals, of which each kind is a class of its own; the same for the same seed.
[[nodiscard]] owl::Ontology enumeration(std::uint64_t seed, std::size_t individuals);

/// Qualified numbers of the same neighbours over a small tree with covering axioms; the same for the same seed.
[[nodiscard]] owl::Ontology qualified_numbers(std::uint64_t seed);

/// Numbers of up to `greatest` of a few properties, which have sub-properties and maybe inverses, and classes defined
/// by such numbers, over kinds of which some are disjoint or cover each other; the same for the same seed.
[[nodiscard]] owl::Ontology large_numbers(std::uint64_t seed, std::uint32_t greatest);

/// A family of so many individuals: persons of disjoint generations, each person a man or a woman, with parents and
/// children and classes defined by how many there are; the same for the same seed.
[[nodiscard]] owl::Ontology family(std::uint64_t seed, std::size_t individuals);

/// Disjoint kinds that are told apart by the values of five functional properties, as amino acids are, and as many
/// classes defined by such values; a thing is of one of the kinds. The same for the same seed.
[[nodiscard]] owl::Ontology features(std::uint64_t seed, std::size_t kinds);

/// Organs as anatomies are written: each part is part of some whole, and many wholes say that they have it; the two
/// properties are transitive and inverse to each other, with ranges, sub-properties, a chain and classes defined by
/// parts and wholes. Some say that parts are disjoint. The same for the same seed.
[[nodiscard]] owl::Ontology anatomy(std::uint64_t seed, std::size_t organs);

/// Wholes that are defined by what all their parts are paired with, so that a thing outside of a definition has a part
/// outside of its filler. Pairings have a hierarchy; some are functional, symmetric, disjoint or inverse to each other,
/// and some fillers speak of the whole or of an individual. The same for the same seed.
[[nodiscard]] owl::Ontology pairings(std::uint64_t seed, std::size_t definitions);

}  // namespace geminga::compare

#endif
