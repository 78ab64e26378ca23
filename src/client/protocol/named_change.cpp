#include "client/protocol/named_change.hpp"

#include <variant>

#include "discovery/gcnp/stated_change.hpp"

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

}  // namespace

void apply(const PublicationChange& change, NamedPublication& publication) {
  if (change.identity) apply_identity(*change.identity, publication.identity);
  gcnp::apply_stated(change, publication);
}

void apply(const SubscriptionChange& change, NamedSubscription& subscription) {
  if (change.identity) apply_identity(*change.identity, subscription.identity);
  gcnp::apply_stated(change, subscription);
}

}  // namespace geminga::client
