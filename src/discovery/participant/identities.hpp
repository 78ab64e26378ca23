// The identities of what peers offer and ask for, by way of the ontology that is in force.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_IDENTITIES_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_IDENTITIES_HPP

#include <expected>

#include "discovery/participant/core.hpp"
#include "geminga/error.hpp"
#include "geminga/named.hpp"
#include "geminga/service.hpp"

namespace geminga::participant {

/// resolve() (naming.hpp) of what is offered. Where none is in force a concept has no identity: 503 while the first
/// ontology is being read, 422 where there is none.
[[nodiscard]] std::expected<Identity, Error> resolve_offered(Core& core, const NamedIdentity& named);
/// The same of what is asked for, which may be a class expression: 503 until the ontology is prepared for them.
[[nodiscard]] std::expected<Identity, Error> resolve_asked(Core& core, const NamedIdentity& named);

/// Whether an identity is only not there because no ontology is there yet: a statement with it is kept and comes into
/// force with the ontology. (While one is there and only to be prepared for expressions, the statement waits itself.)
[[nodiscard]] bool is_awaited(const Core& core, const std::expected<Identity, Error>& identity);

/// Why nothing can be said of classes where no ontology is in force.
[[nodiscard]] Error no_ontology(const Core& core);

}  // namespace geminga::participant

#endif
