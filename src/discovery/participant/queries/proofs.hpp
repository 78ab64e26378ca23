// Axioms that prove how an offer relates to a request, as they are told.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_PROOFS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_PROOFS_HPP

#include <optional>
#include <string>

#include "discovery/matching/degrees/degree.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {

/// Adds an axiom as a line, where there is room for it.
void append_axiom(const std::string& axiom, std::string& proof);

/// Adds the axioms by which the first of two is below the second, each the IRI of a class or a canonical expression.
/// None where the texts are equal, it is not below, or one is an expression and the ontology is not prepared for these.
void add_proof_of_concepts(const vocabulary::Vocabulary& vocabulary, const std::string& sub, const std::string& super,
                           std::string& proof);

/// The axioms that prove the degree: that the offer is below the request, or above it where the degree is broader.
[[nodiscard]] std::string proof_of(const vocabulary::Vocabulary& vocabulary, const Identity& offered,
                                   const Identity& requested, const std::optional<matching::Match>& match);

}  // namespace geminga::participant

#endif
