// `query services` and `query requests`: every known publication or subscription, or those that nobody answers.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "discovery/gcnp/event.hpp"
#include "discovery/participant/knowledge/naming.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/queries.hpp"
#include "discovery/participant/queries/reasons.hpp"
#include "discovery/participant/queries/use.hpp"
#include "discovery/participant/queries/ways.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {
namespace {

/// The most classes that are named right above one.
constexpr std::size_t max_parents = 8;

/// The names in which a line tells an identity: a vocabulary without an ontology gives full IRIs.
vocabulary::Vocabulary names_of(const Listed& by, Names names) {
  return names == Names::full ? vocabulary::Vocabulary() : by.matcher.editions().vocabulary();
}

/// The class that an expression is equivalent to, else the classes right above it, or why it has no place. Below
/// owl:Thing alone there is none to name.
void append_place(Line& line, const Listed& by, const std::string& canonical) {
  const auto place = by.resolver.known_place(canonical);
  if (!place) {
    append_stated(line, "unplaced", base::printable(by.resolver.problem(canonical), max_problem_bytes));
    return;
  }
  const vocabulary::Vocabulary& vocabulary = by.matcher.editions().vocabulary();
  std::vector<std::string> above;
  for (const vocabulary::ClassNumber parent : place->equivalent ? std::vector{*place->equivalent} : place->parents) {
    if (parent != vocabulary.thing() && above.size() < max_parents) above.push_back(vocabulary.short_name(parent));
  }
  append_stated(line, "placed", base::joined(above, ","));
}

const Publication& service_of(const registry::PublicationEntry& entry) { return entry.publication; }
const Subscription& service_of(const registry::SubscriptionEntry& entry) { return entry.subscription; }

/// `reason` says why nobody asks for it, where that was asked for.
Line line_of(const Listed& by, const registry::PublicationEntry& entry, Names names, bool is_used,
             const Reason* reason) {
  Line line;
  append_party(line, entry);
  gcnp::append_identity(line, named(names_of(by, names), entry.publication.identity));
  append_channel(line, entry.publication);
  append(line, "age", age(by.matcher.publications(), by.neighbours, by.env.now(), entry));
  append_flag(line, "local", entry.is_local);
  append_flag(line, "used", is_used);
  append_stated(line, "scope", entry.publication.scope);
  append_stated(line, "for", entry.publication.for_whom);
  if (reason != nullptr) append_because(line, *reason);
  const auto* semantic = std::get_if<SemanticIdentity>(&entry.publication.identity);
  if (semantic != nullptr && has_expression(*semantic)) append_place(line, by, semantic->concept_iri);
  gcnp::append_attributes(line, entry.publication.attributes);
  append_way(line, entry, by.neighbours);
  return line;
}

/// `reason` says why nobody serves it, where that was asked for.
Line line_of(const Listed& by, const registry::SubscriptionEntry& entry, Names names, bool is_served,
             const Reason* reason) {
  const Subscription& subscription = entry.subscription;
  Line line;
  append_party(line, entry);
  gcnp::append_identity(line, named(names_of(by, names), subscription.identity));
  append(line, "match", std::string(to_string(subscription.weakest)));
  append(line, "mode", std::string(to_string(subscription.mode)));
  append_stated(line, "provider", gcnp::provider_list(subscription.providers));
  append_stated(line, "where", subscription.where);
  append(line, "limit", subscription.limit);
  append_stated(line, "address", subscription.address);
  if (subscription.port != 0) append(line, "port", subscription.port);
  append(line, "priority", subscription.priority);
  append(line, "age", age(by.matcher.subscriptions(), by.neighbours, by.env.now(), entry));
  append_flag(line, "local", entry.is_local);
  append_flag(line, "served", is_served);
  append_stated(line, "protocol", gcnp::protocol_list(subscription.protocols));
  append_stated(line, "favour", gcnp::provider_list(subscription.favoured));
  append_stated(line, "prefer", subscription.prefer);
  append_stated(line, "rank", subscription.rank);
  append_stated(line, "scope", subscription.scope);
  if (!subscription.on.empty()) append(line, "on", names_of(by, names).short_expression(subscription.on));
  if (subscription.convert != 0) append(line, "convert", gcnp::conversion_word(subscription.convert));
  if (subscription.reach == RequiredReach::any) append(line, "reach", std::string(to_string(subscription.reach)));
  if (reason != nullptr) append_because(line, *reason);
  gcnp::append_attributes(line, subscription.attributes);
  append_way(line, entry, by.neighbours);
  return line;
}

/// Tells of the entries that pass the filter, of those without an answer only where `is_unanswered_only`. `is_answered`
/// says whether somebody takes a service, or serves a request.
template <typename Entry, typename IsAnswered>
auto listing(const Listed& by, Sieve sieve, bool is_unanswered_only, IsAnswered is_answered) {
  return [by, sieve = std::move(sieve), is_unanswered_only, is_answered = std::move(is_answered),
          reasons = Reasons(by.matcher, by.neighbours)](std::optional<ServiceKey>& last, Piece& piece,
                                                        const Entry& entry) mutable {
    last = entry.key;
    piece.look_at_one();
    if (const std::size_t cost = sieve.cost_of(service_of(entry).identity); cost > 0) piece.look_at(cost);
    if (sieve.passes(by.matcher.editions().vocabulary(), entry.key, entry.participant_name, entry.peer_name,
                     service_of(entry).identity, service_of(entry).mode)) {
      const bool is_answered_here = is_answered(entry);
      Line line;
      if (!is_unanswered_only || !is_answered_here) line = line_of(by, entry, sieve.names(), is_answered_here, nullptr);
      if (!line.empty() && sieve.passes(line)) {
        if (is_unanswered_only) {
          const Reason reason = reasons.likely(piece, entry);
          line = line_of(by, entry, sieve.names(), is_answered_here, &reason);
        }
        piece.tell(std::move(line));
      }
    }
    return !piece.is_full();
  };
}

}  // namespace

std::expected<Answering, Error> begin_list(const Listed& by, const gcnp::QueryServices& query) {
  auto sieve = Sieve::make(by.resolver, query.filter);
  if (!sieve) return std::unexpected(sieve.error());
  using Entry = registry::PublicationEntry;
  auto tell = listing<Entry>(by, std::move(*sieve), query.unused, [by, use = Use()](const Entry& entry) mutable {
    return use.is_of(by.matcher.search(), entry);
  });
  return Answering{.kind = "services",
                   .proceed = [by, tell = std::move(tell), last = std::optional<ServiceKey>()](Piece& piece) mutable {
                     return by.matcher.publications().visit_after(
                         last, [&](const registry::StoredPublication& one) { return tell(last, piece, one.entry); });
                   }};
}

std::expected<Answering, Error> begin_list(const Listed& by, const gcnp::QueryRequests& query) {
  if (query.unused) return begin_list(by, gcnp::QueryServices{.filter = query.filter, .unused = true});
  auto sieve = Sieve::make(by.resolver, query.filter);
  if (!sieve) return std::unexpected(sieve.error());
  using Entry = registry::SubscriptionEntry;
  auto tell = listing<Entry>(by, std::move(*sieve), query.unmatched,
                             [by](const Entry& entry) { return by.matcher.search().is_served(entry); });
  return Answering{.kind = "requests",
                   .proceed = [by, tell = std::move(tell), last = std::optional<ServiceKey>()](Piece& piece) mutable {
                     return by.matcher.subscriptions().visit_after(
                         last, [&](const registry::StoredSubscription& one) { return tell(last, piece, one.entry); });
                   }};
}

}  // namespace geminga::participant
