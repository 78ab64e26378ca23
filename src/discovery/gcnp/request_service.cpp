// The service that a request states, once its names are resolved, and what a later request changes of it.
#include <utility>

#include "discovery/gcnp/request.hpp"
#include "discovery/gcnp/stated_change.hpp"

namespace geminga::gcnp {

Publication with_identity(const NamedPublication& named, Identity identity) {
  return {.mode = named.mode,
          .identity = std::move(identity),
          .address = named.address,
          .port = named.port,
          .protocol = named.protocol,
          .priority = named.priority,
          .attributes = named.attributes,
          .scope = named.scope,
          .for_whom = named.for_whom};
}

Subscription with_identity(const NamedSubscription& named, Identity identity) {
  const std::uint32_t usual = named.mode == ChannelMode::one_to_one ? 1 : 0;
  return {.mode = named.mode,
          .identity = std::move(identity),
          .weakest = named.weakest,
          .providers = named.providers,
          .where = named.where,
          .limit = named.limit.value_or(usual),
          .priority = named.priority,
          .port = named.port,
          .address = named.address,
          .attributes = named.attributes,
          .protocols = named.protocols,
          .favoured = named.favoured,
          .prefer = named.prefer,
          .rank = named.rank,
          .scope = named.scope,
          .convert = named.convert,
          .on = named.on,
          .reach = named.reach};
}

void apply(const PubModify& change, Publication& publication) { apply_stated(change, publication); }

void apply(const SubModify& change, Subscription& subscription) { apply_stated(change, subscription); }

}  // namespace geminga::gcnp
