// Ontologies of the shape of published family histories.
#ifndef GEMINGA_TESTS_COMPARE_GENEALOGIES_HPP
#define GEMINGA_TESTS_COMPARE_GENEALOGIES_HPP

#include <cstddef>
#include <cstdint>

#include "reasoning/owl/source.hpp"

namespace geminga::compare {

/// So many persons in generations, with fathers, mothers, siblings and spouses. Each person has parents, also those of
/// whom nothing is told. Relatives are chains of other properties, with domains and ranges; classes are defined by
/// relatives, by how many children there are, and by relatives of one person. With the seed it changes whether siblings
/// and relatives are transitive, whether sex is a class or a value, and whether all persons are known to differ. The
/// same for the same seed.
[[nodiscard]] owl::Ontology genealogy(std::uint64_t seed, std::size_t persons);

}  // namespace geminga::compare

#endif
