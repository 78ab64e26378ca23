// Checks a description of a participant without a participant.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_DESCRIPTION_CHECK_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_DESCRIPTION_CHECK_HPP

#include <optional>
#include <string>

#include "env/env.hpp"
#include "geminga/error.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {

/// The error for which Participant::describe() would not bring this class expression into force with this vocabulary.
/// Without an ontology only what is wrong by the grammar is an error, since one may come that knows the names. Prepares
/// the vocabulary for expressions where it is not prepared, which takes seconds for a large ontology.
[[nodiscard]] std::optional<Error> check_description(const env::Env& env, const vocabulary::Vocabulary& vocabulary,
                                                     const std::string& expression);

}  // namespace geminga::participant

#endif
