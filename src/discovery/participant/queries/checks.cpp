#include "discovery/participant/queries/checks.hpp"

#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "discovery/gcnp/event.hpp"
#include "discovery/matching/conditions/provider.hpp"
#include "discovery/matching/degrees/representation.hpp"
#include "discovery/participant/knowledge/naming.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/mending.hpp"
#include "discovery/participant/queries/missing.hpp"
#include "discovery/participant/queries/proofs.hpp"
#include "discovery/participant/queries/reach_check.hpp"
#include "reasoning/vocabulary/explanation.hpp"
#include "reasoning/vocabulary/expression.hpp"

namespace geminga::participant {
namespace {

using matching::Obstacle;
using registry::PublicationEntry;
using registry::SubscriptionEntry;

/// The longest sentence about what is missing, in octets.
constexpr std::size_t max_nearest_bytes = 2000;

/// The attribute by which a publisher says that the places for consumers are taken (src/client/CHANNELS.md, "Places"),
/// and the octets of its value that are shown.
constexpr std::string_view channel_full_attribute = "channel.full";
constexpr std::size_t max_places_bytes = 10;

constexpr const char* newer_elsewhere = "another host knows more of scopes and conditions: update a whole team";

/// The request without its restrictions, so that each aspect can be judged by itself.
SubscriptionEntry only(const SubscriptionEntry& request, const PublicationEntry& offer) {
  SubscriptionEntry one = request;
  one.subscription.mode = offer.publication.mode;
  one.subscription.identity = offer.publication.identity;
  one.subscription.weakest = Degree::broader;
  one.subscription.providers.clear();
  one.subscription.where.clear();
  one.subscription.protocols.clear();
  one.subscription.scope.clear();
  one.subscription.on.clear();
  one.subscription.reach = RequiredReach::any;
  for (const std::string_view key : {matching::inputs_attribute, matching::outputs_attribute}) {
    if (const auto at = one.subscription.attributes.find(key); at != one.subscription.attributes.end()) {
      one.subscription.attributes.erase(at);
    }
  }
  return one;
}

/// The offer without restrictions on who may take it.
PublicationEntry for_all(const PublicationEntry& offer) {
  PublicationEntry one = offer;
  one.publication.scope.clear();
  one.publication.for_whom.clear();
  return one;
}

const SemanticIdentity* semantic(const Identity& identity) { return std::get_if<SemanticIdentity>(&identity); }

Check check_mode(const Asked& asked, const PublicationEntry& offer) {
  const std::string offers(to_string(offer.publication.mode));
  if (asked.is_any_mode) return {"mode", Obstacle::none, "any mode is accepted, " + offers + " is offered"};
  const ChannelMode wanted = asked.entry.subscription.mode;
  if (wanted == offer.publication.mode) return {"mode", Obstacle::none, "both are " + offers};
  return {"mode", Obstacle::mode, "offered is " + offers + ", asked for is " + std::string(to_string(wanted)),
          "ask with mode=" + offers + ", or offer it with mode=" + std::string(to_string(wanted))};
}

/// The axioms that are missing for two known concepts to match; empty where the concepts are not the obstacle.
std::string nearest(const matching::Examination& examination, const SubscriptionEntry& request,
                    const PublicationEntry& offer) {
  const auto* asked = semantic(request.subscription.identity);
  const auto* offered = semantic(offer.publication.identity);
  if (asked == nullptr || offered == nullptr) return "";
  const auto& vocabulary = examination.vocabulary();
  const auto sub = vocabulary.find_iri(offered->concept_iri);
  const auto super = vocabulary.find_iri(asked->concept_iri);
  if (!sub || !super || vocabulary.is_subsumed(*sub, *super)) return "";
  const auto why_not = vocabulary.why_not(*sub, *super);
  return "; " + (why_not ? base::printable(*why_not, max_nearest_bytes) : why_not.error().text);
}

/// The axioms that prove that nothing can be both.
std::string exclusion_of(const matching::Examination& examination, const PublicationEntry& offered,
                         const Identity& requested, const matching::Request& request) {
  const auto& vocabulary = examination.vocabulary();
  const matching::Classes offer = examination.classes(offered);
  const auto read = [&](const Identity& identity) {
    return vocabulary.read(semantic(identity)->concept_iri, vocabulary::max_expression_bytes);
  };
  std::vector<std::string> axioms;
  if (offer.concept_class && request.classes.concept_class) {
    axioms = vocabulary.exclusion(*offer.concept_class, *request.classes.concept_class);
  } else if (has_meaning(offer) && has_meaning(request.classes) && vocabulary.check_expressions()) {
    const bool is_offered = offer.place != nullptr;
    const auto named = is_offered ? request.classes.concept_class : offer.concept_class;
    const auto one = read(is_offered ? offered.publication.identity : requested);
    const auto other = named ? one : read(requested);
    if (one && other) axioms = named ? vocabulary.exclusion(*named, *one) : vocabulary.exclusion(*one, *other);
  }
  std::string proof;
  for (const std::string& axiom : axioms) append_axiom(axiom, proof);
  return proof;
}

/// Whether a request that does not ask for overlapping concepts would be met if it did.
bool may_overlap(const matching::Examination& examination, const PublicationEntry& offered, const Identity& requested,
                 const matching::Request& request) {
  const matching::Classes offer = examination.classes(offered);
  if (!has_meaning(offer) || !has_meaning(request.classes)) return false;
  const auto answer =
      examination.overlap({*semantic(offered.publication.identity), offer}, {*semantic(requested), request.classes});
  return answer && answer->verdict == vocabulary::Overlap::Verdict::possible;
}

/// ", by A>B, cost 1", and the converters, where the representation is converted.
std::string conversion_of(const matching::Examination& examination, const vocabulary::Chain* chain,
                          const matching::Match& match) {
  if (match.cost == 0) return "";
  return ", by " + matching::chain_words(chain, examination.vocabulary()) + ", cost " + std::to_string(match.cost) +
         (chain == nullptr || chain->via.empty() ? "" : ", via " + chain->via);
}

/// The degree with inputs and outputs, where the request states any and they suit.
std::string with_signature(const matching::Examination& examination, const Asked& asked,
                           const PublicationEntry& offer) {
  if (!asked.request->signature) return "";
  const auto finding = examination.examine(asked.entry, *asked.request, offer);
  if (!finding.match || !finding.is_signature_met) return "";
  return "; with inputs and outputs " + std::string(to_string(finding.match->degree)) + ", distance " +
         std::to_string(finding.match->distance);
}

Check check_identity(const matching::Examination& examination, const Asked& asked, const PublicationEntry& offer,
                     Depth depth) {
  const Identity& offered = offer.publication.identity;
  const Identity& requested = asked.entry.subscription.identity;
  SubscriptionEntry one = only(asked.entry, offer);
  one.subscription.identity = requested;
  one.subscription.weakest = asked.entry.subscription.weakest;
  const auto match = examination.why(one, for_all(offer), asked.request->asks.chains);
  const auto chain = chain_of(examination, asked, offer);
  const std::string pair = "offered is " + words(examination.vocabulary(), offered) + ", asked for is " +
                           words(examination.vocabulary(), requested) + ": ";
  if (match) {
    return {"identity", Obstacle::none,
            pair + std::string(to_string(match->degree)) + ", distance " + std::to_string(match->distance) +
                conversion_of(examination, chain.get(), *match) + with_signature(examination, asked, offer),
            "", depth == Depth::search ? proof_of(examination.vocabulary(), offered, requested, *match) : ""};
  }
  const auto finding = examination.examine(one, *asked.request, offer);
  // An expression may have found its place since.
  const Obstacle obstacle = finding.identity == Obstacle::none ? Obstacle::unclassified : finding.identity;
  Check check{"identity", obstacle, match.error(),
              mend_of_identity(examination, asked, offer, obstacle, finding.match, chain.get())};
  const bool is_weak = obstacle == Obstacle::broader || obstacle == Obstacle::degree;
  if (depth == Depth::words && !is_weak) return check;
  if (depth == Depth::words) {
    const std::string degree(to_string(finding.match ? finding.match->degree : Degree::broader));
    check.text = words(examination.vocabulary(), offered) + " is " + degree + ", but at least " +
                 std::string(to_string(one.subscription.weakest)) + " is asked for";
    return check;
  }
  check.text.insert(0, pair);
  const bool is_disjoint = obstacle == Obstacle::disjoint;
  if (!is_disjoint && obstacle != Obstacle::undecided) check.text += nearest(examination, asked.entry, offer);
  check.proof = is_disjoint ? exclusion_of(examination, offer, requested, *asked.request)
                            : proof_of(examination.vocabulary(), offered, requested, finding.match);
  const bool is_apart = obstacle == Obstacle::unrelated || obstacle == Obstacle::incomplete;
  if (is_apart && may_overlap(examination, offer, requested, *asked.request)) {
    check.mend += ", or ask with match=overlapping: something can be both";
  }
  if (is_apart || is_disjoint || is_weak) check.missing = missing_between(examination.vocabulary(), requested, offered);
  return check;
}

Check check_provider(const Asked& asked, const PublicationEntry& offer) {
  const auto& providers = asked.entry.subscription.providers;
  if (providers.empty()) return {"provider", Obstacle::none, "any provider is accepted"};
  const bool is_ok = matching::is_accepted_provider(asked.entry.subscription, offer);
  Check check{"provider", is_ok ? Obstacle::none : Obstacle::provider,
              peer_word(offer.key) + (is_ok ? " is accepted by " : " is none of ") + gcnp::provider_list(providers)};
  if (!is_ok) {
    const std::string& by_name = offer.participant_name;
    check.mend = "ask with provider=" + (by_name.empty() ? peer_word(offer.key) : by_name) +
                 " too, or with favour= instead, which shuts nobody out";
  }
  return check;
}

Check check_protocol(const Subscription& asked, const PublicationEntry& offer) {
  if (asked.protocols.empty()) return {"protocol", Obstacle::none, "any protocol is accepted"};
  const std::string& offered = offer.publication.protocol;
  const bool is_ok = matching::is_accepted_protocol(asked, offer);
  return {"protocol", is_ok ? Obstacle::none : Obstacle::protocol,
          offered + (is_ok ? " is accepted by " : " is none of ") + gcnp::protocol_list(asked.protocols),
          is_ok ? "" : "ask with protocol=" + offered + " too, or without protocol"};
}

Check check_where(const matching::Examination& examination, const Asked& asked, const PublicationEntry& offer) {
  const std::string& where = asked.entry.subscription.where;
  if (where.empty()) return {"where", Obstacle::none, "there is no filter"};
  SubscriptionEntry one = only(asked.entry, offer);
  one.subscription.where = where;
  const auto match = examination.why(one, for_all(offer));
  if (match) return {"where", Obstacle::none, "the attributes meet " + where};
  const bool is_readable = asked.request->where.has_value();
  return {"where", is_readable ? Obstacle::where : Obstacle::unreadable, match.error(),
          is_readable ? "ask for less in where, or offer what it asks for" : newer_elsewhere};
}

/// Checks the scopes of both.
Check check_scope(const matching::Examination& examination, const Asked& asked, const PublicationEntry& offer) {
  SubscriptionEntry one = only(asked.entry, offer);
  one.subscription.scope = asked.entry.subscription.scope;
  PublicationEntry other = offer;
  other.publication.for_whom.clear();
  const auto match = examination.why(one, other);
  if (match) return {"scope", Obstacle::none, "each is in the scope of the other"};
  const bool is_readable = asked.request->scope && matching::Scope::parse(offer.publication.scope);
  return {"scope", is_readable ? Obstacle::scope : Obstacle::unreadable, match.error(),
          is_readable ? "widen that scope, or leave it out" : newer_elsewhere};
}

/// Checks whether the provider's participant is known to be what is asked for.
Check check_on(const matching::Matcher& matcher, const Asked& asked, const PublicationEntry& offer) {
  const auto shown = [&](const std::string& text) {
    const auto& vocabulary = matcher.editions().vocabulary();
    return base::printable(text.contains('<') ? vocabulary.short_expression(text)
                                              : vocabulary.short_name(std::string_view(text)));
  };
  const std::string& on = asked.request->on->identity.concept_iri;
  const std::string name = offer.participant_name.empty() ? to_string(offer.key.participant) : offer.participant_name;
  const PublicationEntry* description = matcher.publications().find_entry(description_key(offer.key.participant));
  const auto* said =
      description == nullptr ? nullptr : std::get_if<SemanticIdentity>(&description->publication.identity);
  if (said == nullptr) {
    return {"on", Obstacle::on, name + " does not say what it is, asked for is " + shown(on),
            "describe " + name + " (gemingad --describe, or geminga-query describe there), or ask without on"};
  }
  const bool is_met = matcher.examination().examine(asked.entry, *asked.request, offer).is_on_met;
  Check check{
      "on", is_met ? Obstacle::none : Obstacle::on,
      name + " is " + shown(said->concept_iri) + (is_met ? ", so it is " : ", which is not known to be ") + shown(on)};
  if (is_met) {
    add_proof_of_concepts(matcher.editions().vocabulary(), said->concept_iri, on, check.proof);
  } else {
    check.mend = "ask on what " + name + " is, or describe it by more";
  }
  return check;
}

/// Checks the provider's condition.
Check check_for(const matching::Examination& examination, const Asked& asked, const PublicationEntry& offer) {
  PublicationEntry other = offer;
  other.publication.scope.clear();
  const auto match = examination.why(only(asked.entry, offer), other);
  if (match) return {"for", Obstacle::none, "the consumer meets " + offer.publication.for_whom};
  const bool is_readable =
      matching::Where::parse(offer.publication.for_whom, examination.vocabulary().units()).has_value();
  return {
      "for", is_readable ? Obstacle::for_whom : Obstacle::unreadable, match.error(),
      is_readable ? "state in the request what the provider asks for, or ask for less in its for" : newer_elsewhere};
}

/// Checks inputs and outputs; only for a request that states any.
Check check_signature(const matching::Examination& examination, const Asked& asked, const PublicationEntry& offer) {
  SubscriptionEntry one = only(asked.entry, offer);
  one.subscription.attributes = asked.entry.subscription.attributes;
  one.subscription.weakest = asked.entry.subscription.weakest;
  const auto match = examination.why(one, for_all(offer));
  if (!match) {
    return {"signature", Obstacle::signature, match.error(),
            "state in inputs all that the service needs, and in outputs no more than it produces"};
  }
  return {"signature", Obstacle::none,
          "inputs and outputs are " + std::string(to_string(match->degree)) + ", distance " +
              std::to_string(match->distance)};
}

/// The pair matches; whether messages reach the consumer is the publisher's to say.
Check note_full_channel(const std::string& places) {
  return {.what = "channel",
          .text = "channel: all " + base::printable(places, max_places_bytes) +
                  " places of the publisher are taken: another consumer hears nothing",
          .mend = "end consumers that are not needed, or offer the service with a multicast address"};
}

}  // namespace

std::shared_ptr<const vocabulary::Chain> chain_of(const matching::Examination& examination, const Asked& asked,
                                                  const PublicationEntry& offer) {
  const auto offered = matching::classes_of(offer.publication.identity, examination.vocabulary());
  return matching::chain_between(offered.representation_class, asked.request->classes.representation_class,
                                 examination.vocabulary(), asked.request->asks.chains);
}

std::vector<Check> checks_of(const matching::Matcher& matcher, const membership::Neighbours& neighbours,
                             const Asked& asked, const PublicationEntry& offer, Depth depth) {
  std::vector<Check> checks{check_mode(asked, offer), check_identity(matcher.examination(), asked, offer, depth),
                            check_provider(asked, offer), check_protocol(asked.entry.subscription, offer),
                            check_where(matcher.examination(), asked, offer)};
  const Publication& offered = offer.publication;
  if (!asked.entry.subscription.scope.empty() || !offered.scope.empty()) {
    checks.push_back(check_scope(matcher.examination(), asked, offer));
  }
  if (!asked.entry.subscription.on.empty()) checks.push_back(check_on(matcher, asked, offer));
  if (!offered.for_whom.empty()) checks.push_back(check_for(matcher.examination(), asked, offer));
  if (matching::has_signature(asked.entry.subscription.attributes)) {
    checks.push_back(check_signature(matcher.examination(), asked, offer));
  }
  if (asked.entry.is_local && !offer.is_reachable) checks.push_back(check_reach(neighbours, asked, offer));
  const auto full = offered.attributes.find(channel_full_attribute);
  if (full != offered.attributes.end() && full->second != "0") checks.push_back(note_full_channel(full->second));
  return checks;
}

const Check* first_obstacle(const std::vector<Check>& checks) {
  for (const std::string_view what : {"identity", "mode", "protocol", "provider", "scope", "on", "where", "for",
                                      "signature", "reach", "arbitration"}) {
    const auto at = std::ranges::find(checks, what, &Check::what);
    if (at != checks.end() && !at->is_ok()) return &*at;
  }
  return nullptr;
}

Check misfit_of(const matching::Matcher& matcher, const membership::Neighbours& neighbours, const Asked& asked,
                const PublicationEntry& offer, Obstacle obstacle) {
  switch (obstacle) {
    case Obstacle::mode:
      return check_mode(asked, offer);
    case Obstacle::protocol:
      return check_protocol(asked.entry.subscription, offer);
    case Obstacle::provider:
      return check_provider(asked, offer);
    case Obstacle::scope:
      return check_scope(matcher.examination(), asked, offer);
    case Obstacle::on:
      return check_on(matcher, asked, offer);
    case Obstacle::where:
      return check_where(matcher.examination(), asked, offer);
    case Obstacle::for_whom:
      return check_for(matcher.examination(), asked, offer);
    case Obstacle::signature:
      return check_signature(matcher.examination(), asked, offer);
    case Obstacle::unreachable:
      return check_reach(neighbours, asked, offer);
    case Obstacle::unreadable: {
      for (Check check :
           {check_scope(matcher.examination(), asked, offer), check_where(matcher.examination(), asked, offer),
            check_for(matcher.examination(), asked, offer)}) {
        if (check.obstacle == Obstacle::unreadable) return check;
      }
      return check_where(matcher.examination(), asked, offer);
    }
    default:
      return check_identity(matcher.examination(), asked, offer, Depth::words);
  }
}

void append_check(Line& line, const Check& check) {
  append(line, "check", std::string(check.what));
  append_flag(line, "ok", check.is_ok());
  append(line, "text", check.text);
  if (!check.is_ok()) append(line, "code", std::string(to_string(check.obstacle)));
  append_stated(line, "mend", check.mend);
  append_stated(line, "proof", check.proof);
  if (check.missing) append_missing(line, *check.missing);
}

}  // namespace geminga::participant
