// The providers and protocols that a subscription accepts.
#ifndef GEMINGA_DISCOVERY_MATCHING_CONDITIONS_PROVIDER_HPP
#define GEMINGA_DISCOVERY_MATCHING_CONDITIONS_PROVIDER_HPP

#include "discovery/registry/entry.hpp"
#include "geminga/service.hpp"

namespace geminga::matching {

/// Whether a publication is of this provider (PARTICIPANT[/PEER], each by id or by name). An empty part stands for any.
[[nodiscard]] bool is_of(const ProviderFilter& provider, const registry::PublicationEntry& publication);

/// Whether the publication is of a provider that the subscription names; always where it names none.
[[nodiscard]] bool is_accepted_provider(const Subscription& subscription,
                                        const registry::PublicationEntry& publication);
/// Whether the publication speaks a protocol that the subscription names; always where it names none.
[[nodiscard]] bool is_accepted_protocol(const Subscription& subscription,
                                        const registry::PublicationEntry& publication);

}  // namespace geminga::matching

#endif
