// `query why`: what fits and what does not between one subscription and one service.
#include <algorithm>

#include "base/text.hpp"
#include "discovery/gcnp/event.hpp"
#include "discovery/matching/request.hpp"
#include "discovery/matching/signature.hpp"
#include "discovery/participant/naming.hpp"
#include "discovery/participant/queries/lines.hpp"

namespace geminga::participant {
namespace {

/// Octets of the words that say what is missing.
constexpr std::size_t max_nearest_bytes = 2000;

Line check(std::string_view what, bool is_ok, std::string text) {
  Line line;
  append(line, "check", std::string(what));
  append_flag(line, "ok", is_ok);
  append(line, "text", std::move(text));
  return line;
}

/// The identity as a user would write it.
std::string words(const Core& core, const Identity& identity) {
  Line line;
  gcnp::append_identity(line, named(core.vocabulary(), identity));
  std::string text;
  for (const gcnp::Parameter& one : line) text += (text.empty() ? "" : " ") + one.key + "=" + one.value.value_or("");
  return text;
}

Line check_mode(const Subscription& asked, const Publication& offered) {
  const std::string offers(to_string(offered.mode));
  const std::string asks(to_string(asked.mode));
  if (asked.mode == offered.mode) return check("mode", true, "both are " + offers);
  return check("mode", false, "offered is " + offers + ", asked for is " + asks);
}

/// The request with everything taken away but one aspect, so that each can be judged by itself.
registry::SubscriptionEntry only(const registry::SubscriptionEntry& request, const registry::PublicationEntry& offer) {
  registry::SubscriptionEntry one = request;
  one.subscription.mode = offer.publication.mode;
  one.subscription.identity = offer.publication.identity;
  one.subscription.weakest = Degree::broader;
  one.subscription.providers.clear();
  one.subscription.where.clear();
  one.subscription.protocols.clear();
  one.subscription.scope.clear();
  for (const std::string_view key : {matching::inputs_attribute, matching::outputs_attribute}) {
    if (const auto stated = one.subscription.attributes.find(key); stated != one.subscription.attributes.end())
      one.subscription.attributes.erase(stated);
  }
  return one;
}

/// The offer to everybody.
registry::PublicationEntry for_all(const registry::PublicationEntry& offer) {
  registry::PublicationEntry one = offer;
  one.publication.scope.clear();
  one.publication.for_whom.clear();
  return one;
}

/// What is missing where two known concepts do not match; empty where that is not what is wrong.
std::string nearest(const Core& core, const registry::SubscriptionEntry& request,
                    const registry::PublicationEntry& offer) {
  const auto* asked = std::get_if<SemanticIdentity>(&request.subscription.identity);
  const auto* offered = std::get_if<SemanticIdentity>(&offer.publication.identity);
  if (asked == nullptr || offered == nullptr) return "";
  const auto& vocabulary = core.vocabulary();
  const auto sub = vocabulary.find_iri(offered->concept_iri);
  const auto super = vocabulary.find_iri(asked->concept_iri);
  if (!sub || !super || vocabulary.is_subsumed(*sub, *super)) return "";
  const auto why_not = vocabulary.why_not(*sub, *super);
  return "; " + (why_not ? base::printable(*why_not, max_nearest_bytes) : why_not.error().text);
}

Line check_identity(const Core& core, const registry::SubscriptionEntry& request,
                    const registry::PublicationEntry& offer) {
  registry::SubscriptionEntry one = only(request, offer);
  one.subscription.identity = request.subscription.identity;
  one.subscription.weakest = request.subscription.weakest;
  const auto match = core.matcher.why(one, for_all(offer));
  const std::string pair = "offered is " + words(core, offer.publication.identity) + ", asked for is " +
                           words(core, request.subscription.identity) + ": ";
  if (!match) return check("identity", false, pair + match.error() + nearest(core, request, offer));
  return check("identity", true,
               pair + std::string(to_string(match->degree)) + ", distance " + std::to_string(match->distance));
}

Line check_provider(const Core& core, const registry::SubscriptionEntry& request,
                    const registry::PublicationEntry& offer) {
  if (request.subscription.providers.empty()) return check("provider", true, "any provider is accepted");
  registry::SubscriptionEntry one = only(request, offer);
  one.subscription.providers = request.subscription.providers;
  const bool is_ok = core.matcher.why(one, for_all(offer)).has_value();
  return check("provider", is_ok,
               peer_word(offer.key) + (is_ok ? " is accepted by " : " is none of ") +
                   gcnp::provider_list(request.subscription.providers));
}

Line check_protocol(const Subscription& asked, const Publication& offered) {
  if (asked.protocols.empty()) return check("protocol", true, "any protocol is accepted");
  const bool is_ok = std::ranges::find(asked.protocols, offered.protocol) != asked.protocols.end();
  return check("protocol", is_ok,
               offered.protocol + (is_ok ? " is accepted by " : " is none of ") + gcnp::protocol_list(asked.protocols));
}

Line check_where(const Core& core, const registry::SubscriptionEntry& request,
                 const registry::PublicationEntry& offer) {
  if (request.subscription.where.empty()) return check("where", true, "there is no filter");
  registry::SubscriptionEntry one = only(request, offer);
  one.subscription.where = request.subscription.where;
  const auto match = core.matcher.why(one, for_all(offer));
  return check("where", match.has_value(), match ? "the attributes meet " + request.subscription.where : match.error());
}

/// The scopes of both.
Line check_scope(const Core& core, const registry::SubscriptionEntry& request,
                 const registry::PublicationEntry& offer) {
  registry::SubscriptionEntry one = only(request, offer);
  one.subscription.scope = request.subscription.scope;
  registry::PublicationEntry other = offer;
  other.publication.for_whom.clear();
  const auto match = core.matcher.why(one, other);
  return check("scope", match.has_value(), match ? "each is in the scope of the other" : match.error());
}

/// The provider's condition.
Line check_for(const Core& core, const registry::SubscriptionEntry& request, const registry::PublicationEntry& offer) {
  registry::PublicationEntry other = offer;
  other.publication.scope.clear();
  const auto match = core.matcher.why(only(request, offer), other);
  return check("for", match.has_value(), match ? "the consumer meets " + offer.publication.for_whom : match.error());
}

/// Only where the subscription states what it gives or needs.
Line check_signature(const Core& core, const registry::SubscriptionEntry& request,
                     const registry::PublicationEntry& offer) {
  registry::SubscriptionEntry one = only(request, offer);
  one.subscription.attributes = request.subscription.attributes;
  one.subscription.weakest = request.subscription.weakest;
  const auto match = core.matcher.why(one, for_all(offer));
  if (!match) return check("signature", false, match.error());
  return check("signature", true,
               "inputs and outputs are " + std::string(to_string(match->degree)) + ", distance " +
                   std::to_string(match->distance));
}

/// By what the rival is ahead; empty where it is by its key alone.
std::string lead_of(const Core& core, const registry::SubscriptionEntry& request,
                    const registry::PublicationEntry& rival, const registry::PublicationEntry& offer) {
  const auto better = core.matcher.why(request, rival);
  const auto worse = core.matcher.why(request, offer);
  if (!better || !worse) return "";
  return core.matcher.prepare(request.subscription)->preferences.lead(rival, *better, offer, *worse);
}

std::string outranked_words(const Core& core, const registry::SubscriptionEntry& request,
                            const registry::PublicationEntry& offer, const matching::Standing& standing) {
  if (standing.rival == nullptr) {
    return standing.decided == matching::Standing::Decided::by_consumer ? ": the consumer's host has chosen another"
                                                                        : ": it is not used";
  }
  std::string text = ": outranked by " + to_string(standing.rival->key);
  if (standing.decided == matching::Standing::Decided::by_consumer) {
    return text + ", which the consumer's host has chosen";
  }
  if (standing.decided == matching::Standing::Decided::by_incumbent && !request.subscription.prefer.empty()) {
    return text + ", which was there first, and it is not better by as much as prefer asks for";
  }
  if (const std::string lead = lead_of(core, request, *standing.rival, offer); !lead.empty()) {
    return text.append(", ").append(lead);
  }
  if (standing.decided == matching::Standing::Decided::elsewhere) {
    return text + ", which is no better: the consumer's host keeps whichever was there first";
  }
  return text + (standing.decided == matching::Standing::Decided::by_incumbent || standing.rival->key > offer.key
                     ? ", which was there first and is no worse"
                     : ", which is as good and was there first or has the smaller key");
}

/// Whether the pair came to nothing although it fits, because others took the places.
Line check_arbitration(const Core& core, const registry::SubscriptionEntry& request,
                       const registry::PublicationEntry& offer, const matching::Standing& standing) {
  const std::uint32_t limit = request.subscription.limit;
  std::string text = "it ranks " + std::to_string(standing.rank) + " of " + std::to_string(standing.candidates);
  if (limit == 0) return check("arbitration", true, text + ", and there is no limit");
  text += ", the limit is " + std::to_string(limit);
  if (!standing.is_chosen) return check("arbitration", false, text + outranked_words(core, request, offer, standing));
  if (standing.decided == matching::Standing::Decided::by_incumbent) {
    text += ": it was there first, and none of those ahead of it is better ";
    text += request.subscription.prefer.empty() ? "but for its key" : "by as much as prefer asks for";
  }
  return check("arbitration", true, std::move(text));
}

}  // namespace

Answered answer(Core& core, const gcnp::QueryWhy& query) {
  const auto* request = core.matcher.find_subscription(query.subscription);
  const auto* offer = core.matcher.find_publication(query.service);
  if (request == nullptr || offer == nullptr) {
    return std::unexpected(
        Error{ErrorCode::unknown_request,
              request == nullptr
                  ? "there is no subscription " + to_string(query.subscription) + ": geminga-query requests lists them"
                  : "there is no service " + to_string(query.service) + ": geminga-query services lists them"});
  }
  const auto match = core.matcher.why(*request, *offer);
  Answer answer{
      .kind = "why",
      .lines = {check_mode(request->subscription, offer->publication), check_identity(core, *request, *offer),
                check_provider(core, *request, *offer), check_protocol(request->subscription, offer->publication),
                check_where(core, *request, *offer)},
      .end = {}};
  if (!request->subscription.scope.empty() || !offer->publication.scope.empty()) {
    answer.lines.push_back(check_scope(core, *request, *offer));
  }
  if (!offer->publication.for_whom.empty()) answer.lines.push_back(check_for(core, *request, *offer));
  if (matching::has_signature(request->subscription.attributes))
    answer.lines.push_back(check_signature(core, *request, *offer));
  const auto standing = match ? core.matcher.standing(request->key, offer->key) : std::nullopt;
  if (standing) {
    answer.looked_through = standing->candidates;
    answer.lines.push_back(check_arbitration(core, *request, *offer, *standing));
  }
  const bool is_outranked = standing && !standing->is_chosen;
  append_flag(answer.end, "matches", match.has_value() && !is_outranked);
  if (match) {
    append(answer.end, "degree", std::string(to_string(match->degree)));
    append(answer.end, "distance", match->distance);
  }
  if (is_outranked) append_flag(answer.end, "outranked", true);
  return answer;
}

}  // namespace geminga::participant
