// `query requests`: every known subscription, or those that nobody serves.
#include <optional>
#include <utility>

#include "discovery/gcnp/event.hpp"
#include "discovery/participant/knowledge/naming.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/queries.hpp"
#include "discovery/participant/queries/reasons.hpp"

namespace geminga::participant {
namespace {

/// `reason` says why nobody serves it, where that was asked for.
Line line_of(const Listed& by, const registry::SubscriptionEntry& entry, const Reason* reason) {
  const Subscription& subscription = entry.subscription;
  Line line;
  append(line, "subscription", to_string(entry.key));
  append(line, "consumer", peer_word(entry.key));
  append_stated(line, "name", entry.peer_name);
  append_stated(line, "participant_name", entry.participant_name);
  gcnp::append_identity(line, named(by.matcher.vocabulary(), subscription.identity));
  append(line, "match", std::string(to_string(subscription.weakest)));
  append(line, "mode", std::string(to_string(subscription.mode)));
  append_stated(line, "provider", gcnp::provider_list(subscription.providers));
  append_stated(line, "where", subscription.where);
  append(line, "limit", subscription.limit);
  append_stated(line, "address", subscription.address);
  if (subscription.port != 0) append(line, "port", subscription.port);
  append(line, "priority", subscription.priority);
  append(line, "age", age(by.neighbours, by.env.now(), entry));
  append_flag(line, "local", entry.is_local);
  append_flag(line, "served", by.matcher.is_served(entry));
  append_stated(line, "protocol", gcnp::protocol_list(subscription.protocols));
  append_stated(line, "favour", gcnp::provider_list(subscription.favoured));
  append_stated(line, "prefer", subscription.prefer);
  append_stated(line, "rank", subscription.rank);
  append_stated(line, "scope", subscription.scope);
  if (subscription.convert != 0) append(line, "convert", gcnp::conversion_word(subscription.convert));
  if (reason != nullptr) append_because(line, *reason);
  gcnp::append_attributes(line, subscription.attributes);
  return line;
}

}  // namespace

std::expected<Answering, Error> begin_list(const Listed& by, const gcnp::QueryRequests& query) {
  if (query.unused) return begin_list(by, gcnp::QueryServices{.filter = query.filter, .unused = true});
  auto sieve = Sieve::make(by.resolver, query.filter);
  if (!sieve) return std::unexpected(sieve.error());
  return Answering{
      .kind = "requests",
      .proceed = [sieve = std::move(*sieve), is_unmatched_only = query.unmatched, last = std::optional<ServiceKey>(),
                  reasons = Reasons(by.matcher, by.neighbours), by](Piece& piece) mutable {
        return by.matcher.walk_subscriptions(last, [&](const registry::SubscriptionEntry& entry) {
          last = entry.key;
          piece.look_at_one();
          const bool passes = sieve.passes(by.matcher.vocabulary(), entry.key, entry.participant_name, entry.peer_name,
                                           entry.subscription.identity, entry.subscription.mode) &&
                              !(is_unmatched_only && by.matcher.is_served(entry));
          Line line = passes ? line_of(by, entry, nullptr) : Line{};
          if (passes && sieve.passes(line)) {
            if (is_unmatched_only) {
              const Reason reason = reasons.likely(piece, entry);
              line = line_of(by, entry, &reason);
            }
            piece.tell(std::move(line));
          }
          return !piece.is_full();
        });
      }};
}

}  // namespace geminga::participant
