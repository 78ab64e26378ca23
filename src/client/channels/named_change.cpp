#include "client/channels/named_change.hpp"

#include <variant>

namespace geminga::client {
namespace {

void apply_identity(const IdentityChange& change, NamedIdentity& identity) {
  if (const auto* number = std::get_if<NumericIdentity>(&change)) {
    identity = *number;
  } else if (const auto* text = std::get_if<TextIdentity>(&change)) {
    identity = *text;
  } else {
    const auto& given = std::get<ConceptChange>(change);
    ConceptNames names;
    if (const auto* before = std::get_if<ConceptNames>(&identity)) names = *before;
    names.concept_name = given.concept_name.value_or(names.concept_name);
    names.representation_name = given.representation_name.value_or(names.representation_name);
    identity = names;
  }
}

template <typename Change, typename Service>
void apply_common(const Change& change, Service& service) {
  if (change.identity) apply_identity(*change.identity, service.identity);
  service.mode = change.mode.value_or(service.mode);
  service.address = change.address.value_or(service.address);
  service.port = change.port.value_or(service.port);
  service.priority = change.priority.value_or(service.priority);
  service.scope = change.scope.value_or(service.scope);
  for (const auto& [key, value] : change.attributes) service.attributes.insert_or_assign(key, value);
}

}  // namespace

void apply(const PublicationChange& change, NamedPublication& publication) {
  apply_common(change, publication);
  publication.protocol = change.protocol.value_or(publication.protocol);
  publication.for_whom = change.for_whom.value_or(publication.for_whom);
}

void apply(const SubscriptionChange& change, NamedSubscription& subscription) {
  apply_common(change, subscription);
  subscription.weakest = change.weakest.value_or(subscription.weakest);
  subscription.providers = change.providers.value_or(subscription.providers);
  subscription.where = change.where.value_or(subscription.where);
  if (change.limit) subscription.limit = change.limit;
  subscription.protocols = change.protocols.value_or(subscription.protocols);
  subscription.favoured = change.favoured.value_or(subscription.favoured);
  subscription.prefer = change.prefer.value_or(subscription.prefer);
  subscription.rank = change.rank.value_or(subscription.rank);
  subscription.convert = change.convert.value_or(subscription.convert);
}

}  // namespace geminga::client
