// What a provider may do so that a request takes what it offers.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_MENDING_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_MENDING_HPP

#include <string>

#include "discovery/participant/queries/checks.hpp"

namespace geminga::participant {

/// Of a check that is not well: what its `mend` says to the consumer, said to the provider first.
[[nodiscard]] std::string mend_by_provider(const Core& core, const Asked& asked,
                                           const registry::PublicationEntry& offer, const Check& check);

}  // namespace geminga::participant

#endif
