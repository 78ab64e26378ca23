#include "discovery/participant/queries/sides.hpp"

#include <utility>

#include "base/text.hpp"
#include "discovery/matching/arbitration/preferences.hpp"
#include "discovery/matching/conditions/scope.hpp"

namespace geminga::participant {
namespace {

Error unknown(const std::string& what, const ServiceKey& key, const std::string& command) {
  return {ErrorCode::unknown_request,
          "there is no " + what + " " + to_string(key) + ": geminga-query " + command + " lists them"};
}

std::expected<Asked, Error> stated(const matching::Matcher& matcher, const ServiceKey& key) {
  const auto* entry = matcher.subscriptions().find_entry(key);
  if (entry == nullptr) return std::unexpected(unknown("subscription", key, "requests"));
  return Asked{.entry = *entry, .request = matcher.examination().prepare(*entry)};
}

/// As if a peer of this participant asked for it.
std::expected<Asked, Error> imagined(const Stating& by, const gcnp::HypotheticalRequest& request) {
  auto identity = by.resolver.resolve(request.subscription.identity);
  if (!identity) return std::unexpected(identity.error());
  Asked asked{.entry = {}, .request = {}, .is_any_mode = request.is_any_mode, .is_living = false};
  NamedSubscription named = request.subscription;
  if (request.is_any_mode && !named.limit) named.limit = 0;
  asked.entry.key.participant = by.self.id;
  asked.entry.participant_name = by.self.name();
  asked.entry.is_local = true;
  asked.entry.updated = by.now;
  asked.entry.subscription = gcnp::with_identity(named, std::move(*identity));
  if (!named.on.empty()) {
    auto on = by.resolver.resolve_on(named.on);
    if (!on) return std::unexpected(on.error());
    asked.entry.subscription.on = std::move(*on);
  }
  if (auto error = matching::check_where(named.where, "where", by.matcher.editions().vocabulary().units()))
    return std::unexpected(std::move(*error));
  if (auto error = matching::check_preferences(asked.entry.subscription, by.matcher.editions().vocabulary().units()))
    return std::unexpected(std::move(*error));
  if (auto error = matching::check_scope(named.scope)) return std::unexpected(std::move(*error));
  asked.request = by.matcher.examination().prepare(asked.entry);
  return asked;
}

/// As if the provider that it names offered it, else a peer of this participant.
std::expected<Offered, Error> imagined(const Stating& by, const gcnp::HypotheticalOffer& offer,
                                       const std::optional<Asked>& asked) {
  auto identity = by.resolver.resolve(offer.publication.identity);
  if (!identity) return std::unexpected(Error{identity.error().code, "offer: " + identity.error().text});
  if (auto error = matching::check_scope(offer.publication.scope)) return std::unexpected(std::move(*error));
  if (auto error = matching::check_where(offer.publication.for_whom, "for", by.matcher.editions().vocabulary().units()))
    return std::unexpected(std::move(*error));
  Offered offered{.entry = {}, .is_living = false};
  auto& entry = offered.entry;
  entry.publication = gcnp::with_identity(offer.publication, std::move(*identity));
  offered.is_any_mode = offer.is_any_mode && !asked;
  if (offer.is_any_mode && asked) entry.publication.mode = asked->entry.subscription.mode;
  const ProviderFilter& provider = offer.provider;
  entry.key.participant = provider.participant.empty() ? by.self.id : ParticipantId{};
  entry.participant_name = provider.participant.empty() ? by.self.name() : provider.participant;
  if (const auto id = participant_id(provider.participant)) entry.key.participant = *id;
  entry.key.peer = PeerId{base::parse_number<std::uint32_t>(provider.peer).value_or(0)};
  entry.peer_name = provider.peer;
  entry.is_local = entry.key.participant == by.self.id;
  entry.updated = by.now;
  return offered;
}

}  // namespace

std::expected<std::optional<Asked>, Error> asked_of(const Stating& by, const gcnp::QueryWhy& query) {
  if (const auto* key = std::get_if<ServiceKey>(&query.request)) return stated(by.matcher, *key);
  if (const auto* request = std::get_if<gcnp::HypotheticalRequest>(&query.request)) return imagined(by, *request);
  return std::nullopt;
}

std::expected<std::optional<Offered>, Error> offered_of(const Stating& by, const gcnp::QueryWhy& query,
                                                        const std::optional<Asked>& asked) {
  if (const auto* key = std::get_if<ServiceKey>(&query.offer)) {
    const auto* entry = by.matcher.publications().find_entry(*key);
    if (entry == nullptr) return std::unexpected(unknown("service", *key, "services"));
    return Offered{.entry = *entry};
  }
  if (const auto* offer = std::get_if<gcnp::HypotheticalOffer>(&query.offer)) {
    auto offered = imagined(by, *offer, asked);
    if (!offered) return std::unexpected(std::move(offered.error()));
    return std::move(*offered);
  }
  return std::nullopt;
}

}  // namespace geminga::participant
