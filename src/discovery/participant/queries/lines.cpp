#include "discovery/participant/queries/lines.hpp"

#include <algorithm>
#include <cstdio>

#include "base/text.hpp"
#include "discovery/gcnp/event.hpp"
#include "discovery/matching/degrees/comparison.hpp"
#include "discovery/participant/knowledge/naming.hpp"

namespace geminga::participant {
namespace {

bool is_accepted(const ProviderFilter& filter, const ServiceKey& key, const std::string& participant_name,
                 const std::string& peer_name) {
  const bool is_participant =
      filter.participant == to_string(key.participant) || filter.participant == participant_name;
  const std::string number = std::to_string(static_cast<std::uint32_t>(key.peer));
  return is_participant && (filter.peer.empty() || filter.peer == number || filter.peer == peer_name);
}

bool is_same_or_narrower(const vocabulary::Vocabulary& vocabulary, const std::string& sub, const std::string& super) {
  if (sub == super) return true;
  const auto sub_class = vocabulary.find_iri(sub);
  const auto super_class = vocabulary.find_iri(super);
  return sub_class && super_class && vocabulary.is_subsumed(*sub_class, *super_class);
}

/// Whether a concept is the same as a wanted one or narrower. The places are those of expressions.
bool is_same_or_narrower(const vocabulary::Vocabulary& vocabulary, const SemanticIdentity& sub,
                         const Expressions::Place& place_of_sub, const SemanticIdentity& super,
                         const Expressions::Place& place) {
  if (sub.concept_iri == super.concept_iri || (!place && !place_of_sub)) {
    return is_same_or_narrower(vocabulary, sub.concept_iri, super.concept_iri);
  }
  if (place && place_of_sub) {
    const auto found =
        matching::compared_at_once(vocabulary, {sub, {.place = place_of_sub}}, {super, {.place = place}});
    const auto match = matching::degree_of_comparison(*found);
    return match && !is_weaker(match->degree, Degree::narrower);
  }
  const auto named = vocabulary.find_iri(place ? sub.concept_iri : super.concept_iri);
  if (!named) return false;
  return place ? vocabulary.is_above(*place, *named) : vocabulary.distance_up(*place_of_sub, *named).has_value();
}

template <typename Entry>
void append_owned(Line& line, std::string_view key, std::string_view owner, const Entry& entry) {
  append(line, key, to_string(entry.key));
  append(line, owner, peer_word(entry.key));
  append_stated(line, "name", entry.peer_name);
  append_stated(line, "participant_name", entry.participant_name);
}

}  // namespace

std::string words(const vocabulary::Vocabulary& vocabulary, const Identity& identity) {
  Line line;
  gcnp::append_identity(line, named(vocabulary, identity));
  std::string text;
  for (const gcnp::Parameter& one : line) text += (text.empty() ? "" : " ") + one.key + "=" + one.value.value_or("");
  return text;
}

std::string seconds(base::Duration duration) {
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(std::max(duration, base::Duration(0))).count();
  const std::string fraction = std::to_string(ms % 1000);
  return std::to_string(ms / 1000) + "." + std::string(3 - fraction.size(), '0') + fraction;
}

std::string decimal(double number) {
  return seconds(std::chrono::duration_cast<base::Duration>(std::chrono::duration<double>(number)) +
                 std::chrono::microseconds(500));
}

void append_party(Line& line, const registry::PublicationEntry& entry) {
  append_owned(line, "service", "provider", entry);
}

void append_party(Line& line, const registry::SubscriptionEntry& entry) {
  append_owned(line, "subscription", "consumer", entry);
}

void append_channel(Line& line, const Publication& publication) {
  append(line, "mode", std::string(to_string(publication.mode)));
  append_stated(line, "address", publication.address);
  append(line, "port", publication.port);
  append(line, "protocol", publication.protocol);
  append(line, "priority", publication.priority);
}

std::expected<Sieve, Error> Sieve::make(Resolver& resolver, const gcnp::ListFilter& filter) {
  Sieve sieve(resolver, filter);
  if (filter.identity) {
    auto identity = resolver.resolve(*filter.identity);
    if (!identity) return std::unexpected(identity.error());
    sieve.identity_ = std::move(*identity);
    if (has_expression(*sieve.identity_)) {
      sieve.place_ = resolver.place(std::get<SemanticIdentity>(*sieve.identity_).concept_iri);
    }
  }
  return sieve;
}

bool Sieve::is_wanted(const vocabulary::Vocabulary& vocabulary, const Identity& identity) const {
  const auto* sub = std::get_if<SemanticIdentity>(&identity);
  const auto* super = std::get_if<SemanticIdentity>(&*identity_);
  if (sub == nullptr || super == nullptr) return identity == *identity_;
  const auto place = has_expression(*sub) ? resolver_->known_place(sub->concept_iri) : nullptr;
  return is_same_or_narrower(vocabulary, *sub, place, *super, place_) &&
         (super->representation_iri.empty() ||
          is_same_or_narrower(vocabulary, sub->representation_iri, super->representation_iri));
}

bool Sieve::passes(const vocabulary::Vocabulary& vocabulary, const ServiceKey& key, const std::string& participant_name,
                   const std::string& peer_name, const Identity& identity, ChannelMode mode) const {
  if (filter_.mode ? *filter_.mode != mode : mode == ChannelMode::participant) return false;
  if (identity_ && !is_wanted(vocabulary, identity)) return false;
  return filter_.providers.empty() || std::ranges::any_of(filter_.providers, [&](const ProviderFilter& one) {
           return is_accepted(one, key, participant_name, peer_name);
         });
}

bool Sieve::passes(const Line& line) const {
  if (filter_.text.empty()) return true;
  gcnp::Statement statement;
  statement.parameters = line;
  return gcnp::matches_text(statement, filter_.text);
}

}  // namespace geminga::participant
