// Which pairs this host has to judge, and how many providers each subscription is given.
#ifndef GEMINGA_DISCOVERY_MATCHING_INTEREST_HPP
#define GEMINGA_DISCOVERY_MATCHING_INTEREST_HPP

#include <cstddef>
#include <cstdint>

#include "discovery/registry/entry.hpp"

namespace geminga::matching {

/// A remote consumer that asks for more providers than this and has not announced its choice is treated as one that
/// takes all. Its choice then needs no other candidates than our own publications. The price: a provider may be told of
/// a consumer that has better ones.
inline constexpr std::uint32_t max_counted_providers = 16;

/// A consumer of our own that asks for all is given the best of so many. Each pair costs memory here and in its peer,
/// and more services may be announced than a host has memory for pairs.
inline constexpr std::uint32_t max_given = 1024;

/// The limit that arbitration works with; 0 is none.
[[nodiscard]] std::uint32_t arbitrated_limit(const registry::SubscriptionEntry& subscription);
/// The limit that ranks are compared with; 0 is none.
[[nodiscard]] std::size_t counted_limit(const registry::SubscriptionEntry& subscription);
/// Whether the choice of a subscription is computed here: always of a local one, and of a remote one where its
/// providers here depend on it.
[[nodiscard]] bool is_chosen_here(const registry::SubscriptionEntry& subscription);
/// Whether the pair can cause an event, or decide about another one that can.
[[nodiscard]] bool is_of_interest(const registry::SubscriptionEntry& subscription,
                                  const registry::PublicationEntry& publication);
/// Whether a publication is in the choice that the consumer's host has announced.
[[nodiscard]] bool is_announced_choice(const registry::SubscriptionEntry& subscription,
                                       const registry::PublicationEntry& publication);

}  // namespace geminga::matching

#endif
