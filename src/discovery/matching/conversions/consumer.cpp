#include "discovery/matching/conversions/consumer.hpp"

#include "discovery/matching/conditions/provider.hpp"

namespace geminga::matching {

bool Consumer::takes_part(const Converter& converter) const {
  const Subscription& asked = entry.subscription;
  if (entry.is_local && !converter.entry.is_reachable && asked.reach == RequiredReach::routed) return false;
  if (!is_accepted_protocol(asked, converter.entry) || !is_accepted_provider(asked, converter.entry)) return false;
  const Party consumer = party(entry);
  const Party provider = party(converter.entry);
  const Audience& audience = converter.audience;
  return scope && scope->admits(consumer, provider) && audience.scope && audience.scope->admits(provider, consumer) &&
         audience.condition && audience.condition->accepts(entry, declared);
}

}  // namespace geminga::matching
