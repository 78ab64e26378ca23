// `query requests`: every known subscription, or those that nobody serves.
#include "gcnp/event.hpp"
#include "participant/naming.hpp"
#include "participant/queries/lines.hpp"

namespace geminga::participant {
namespace {

Line line_of(const Core& core, const registry::SubscriptionEntry& entry) {
  const Subscription& subscription = entry.subscription;
  Line line;
  append(line, "subscription", to_string(entry.key));
  append(line, "consumer", gcnp::peer_word(entry.key));
  append_known(line, "name", entry.peer_name);
  append_known(line, "participant_name", entry.participant_name);
  gcnp::append_identity(line, named(core.ontology, subscription.identity));
  append(line, "match", std::string(to_string(subscription.weakest)));
  append(line, "mode", std::string(to_string(subscription.mode)));
  append_known(line, "provider", joined(subscription.providers));
  append_known(line, "where", subscription.where);
  append(line, "limit", subscription.limit);
  append_known(line, "address", subscription.address);
  if (subscription.port != 0) append(line, "port", subscription.port);
  append(line, "priority", subscription.priority);
  append(line, "age", age(core, entry));
  append_flag(line, "local", entry.is_local);
  append_flag(line, "served", core.matcher.is_served(entry));
  append_known(line, "protocol", joined(subscription.protocols));
  gcnp::append_attributes(line, subscription.attributes);
  return line;
}

}  // namespace

Answered answer(Core& core, const gcnp::QueryRequests& query) {
  if (query.unused) return answer(core, gcnp::QueryServices{.filter = query.filter, .unused = true});
  const auto sieve = Sieve::make(core, query.filter);
  if (!sieve) return std::unexpected(sieve.error());
  Answer answer{.kind = "requests", .lines = {}, .end = {}};
  core.matcher.for_each_subscription([&](const registry::SubscriptionEntry& entry) {
    ++answer.looked_through;
    if (query.unmatched && core.matcher.is_served(entry)) return;
    if (!sieve->passes(entry.key, entry.participant_name, entry.peer_name, entry.subscription.identity,
                       entry.subscription.mode)) {
      return;
    }
    Line line = line_of(core, entry);
    if (sieve->passes(line)) answer.lines.push_back(std::move(line));
  });
  return answer;
}

}  // namespace geminga::participant
