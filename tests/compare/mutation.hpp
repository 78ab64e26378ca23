// Variations of ontologies that people wrote: a part of one, or of several that meet in some names, with random edits.
#ifndef GEMINGA_TESTS_COMPARE_MUTATION_HPP
#define GEMINGA_TESTS_COMPARE_MUTATION_HPP

#include <cstdint>
#include <span>
#include <string>

#include "reasoning/owl/source.hpp"

namespace geminga::compare {

struct Mutation {
  owl::Ontology source;  ///< with a declaration of each name, and without rules
  std::string words;     ///< its making in a few words
};

/// Takes of each original all axioms, a random sample, or the module of random names, gives some names of the second
/// and third original to things of the first, and edits a few axioms in a hundred. Mostly what OWL 2 DL forbids is
/// taken out again. With facts, up to so many are added at last. Requires an original. The same for the same arguments.
[[nodiscard]] Mutation mutation(std::span<const owl::Ontology* const> originals, std::uint64_t seed,
                                std::size_t facts = 0);

}  // namespace geminga::compare

#endif
