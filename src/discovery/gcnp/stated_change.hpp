// The effect of a `modify` on a publication or subscription, whether its identity is stated by names or resolved.
#ifndef GEMINGA_DISCOVERY_GCNP_STATED_CHANGE_HPP
#define GEMINGA_DISCOVERY_GCNP_STATED_CHANGE_HPP

#include "geminga/named.hpp"

namespace geminga::gcnp {

/// The fields that both kinds have.
template <typename Change, typename Service>
void apply_common(const Change& change, Service& service) {
  service.mode = change.mode.value_or(service.mode);
  service.address = change.address.value_or(service.address);
  service.port = change.port.value_or(service.port);
  service.priority = change.priority.value_or(service.priority);
  service.scope = change.scope.value_or(service.scope);
  for (const auto& [key, value] : change.attributes) service.attributes.insert_or_assign(key, value);
}

/// Drops an empty `converts`, which takes back what was stated.
inline void drop_empty_conversion(Attributes& attributes) {
  const auto conversion = attributes.find("converts");
  if (conversion != attributes.end() && conversion->second.empty()) attributes.erase(conversion);
}

/// Changes all but the identity of a Publication or a NamedPublication; the caller changes that.
template <typename Publication>
void apply_stated(const PublicationChange& change, Publication& publication) {
  apply_common(change, publication);
  publication.protocol = change.protocol.value_or(publication.protocol);
  publication.for_whom = change.for_whom.value_or(publication.for_whom);
  drop_empty_conversion(publication.attributes);
}

/// The same for a Subscription or a NamedSubscription.
template <typename Subscription>
void apply_stated(const SubscriptionChange& change, Subscription& subscription) {
  apply_common(change, subscription);
  subscription.weakest = change.weakest.value_or(subscription.weakest);
  subscription.providers = change.providers.value_or(subscription.providers);
  subscription.where = change.where.value_or(subscription.where);
  if (change.limit) {
    const std::uint32_t limit = *change.limit;  // that of some subscriptions may be missing, too, and of others not
    subscription.limit = limit;
  }
  subscription.protocols = change.protocols.value_or(subscription.protocols);
  subscription.favoured = change.favoured.value_or(subscription.favoured);
  subscription.prefer = change.prefer.value_or(subscription.prefer);
  subscription.rank = change.rank.value_or(subscription.rank);
  subscription.convert = change.convert.value_or(subscription.convert);
  subscription.on = change.on.value_or(subscription.on);
  subscription.reach = change.reach.value_or(subscription.reach);
}

}  // namespace geminga::gcnp

#endif
