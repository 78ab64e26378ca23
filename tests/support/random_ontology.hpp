// Random ontologies by seed, in the terms of a profile that one engine can handle and the next can handle better.
#ifndef GEMINGA_TESTS_SUPPORT_RANDOM_ONTOLOGY_HPP
#define GEMINGA_TESTS_SUPPORT_RANDOM_ONTOLOGY_HPP

#include <cstdint>
#include <string_view>

#include "reasoning/owl/source.hpp"

namespace geminga::compare {

/// Each profile except the last includes those before it.
enum class Profile : std::uint8_t {
  horn,      ///< EL, functional and inverse properties, universals on the right, at most one: no choice anywhere
  choices,   ///< and unions, complements, cardinalities: ALCHIQ
  chains,    ///< and transitive, reflexive and symmetric properties, chains, self restrictions: SRIQ
  nominals,  ///< and individuals with facts, in classes too: SROIQ
  values,    ///< and data properties with values and ranges: SROIQ(D)
  ranges,    ///< EL with ranges of chains and universals on the right, and individuals with facts
};
inline constexpr Profile profiles[] = {Profile::horn,     Profile::choices, Profile::chains,
                                       Profile::nominals, Profile::values,  Profile::ranges};

[[nodiscard]] std::string_view to_string(Profile profile);

/// About `axioms` axioms over few names, so that they interact. The same for the same arguments on every machine.
/// Chains are regular, and properties with cardinalities and self restrictions are simple, as OWL 2 DL requires.
[[nodiscard]] owl::Ontology random_ontology(Profile profile, std::uint64_t seed, std::size_t axioms);

}  // namespace geminga::compare

#endif
