#include "discovery/participant/queries/lines.hpp"

#include <algorithm>
#include <cstdio>

#include "base/text.hpp"

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

/// `place` is that of the wanted concept where it is an expression.
bool is_same_or_narrower(const vocabulary::Vocabulary& vocabulary, const std::string& sub, const std::string& super,
                         const vocabulary::Place* place) {
  if (sub == super || place == nullptr) return is_same_or_narrower(vocabulary, sub, super);
  const auto sub_class = vocabulary.find_iri(sub);
  return sub_class && vocabulary.is_above(*place, *sub_class);
}

bool is_same_or_narrower(const vocabulary::Vocabulary& vocabulary, const Identity& identity, const Identity& wanted,
                         const vocabulary::Place* place) {
  const auto* sub = std::get_if<SemanticIdentity>(&identity);
  const auto* super = std::get_if<SemanticIdentity>(&wanted);
  if (sub == nullptr || super == nullptr) return identity == wanted;
  return is_same_or_narrower(vocabulary, sub->concept_iri, super->concept_iri, place) &&
         (super->representation_iri.empty() ||
          is_same_or_narrower(vocabulary, sub->representation_iri, super->representation_iri));
}

template <typename Entry>
void append_owned(Line& line, std::string_view key, std::string_view owner, const Entry& entry) {
  append(line, key, to_string(entry.key));
  append(line, owner, peer_word(entry.key));
  append_stated(line, "name", entry.peer_name);
  append_stated(line, "participant_name", entry.participant_name);
}

}  // namespace

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
  Sieve sieve(filter);
  if (filter.identity) {
    auto identity = resolver.resolve_asked(*filter.identity);
    if (!identity) return std::unexpected(identity.error());
    sieve.identity_ = std::move(*identity);
    if (has_expression(*sieve.identity_)) {
      sieve.place_ = resolver.place(std::get<SemanticIdentity>(*sieve.identity_).concept_iri);
    }
  }
  return sieve;
}

bool Sieve::passes(const vocabulary::Vocabulary& vocabulary, const ServiceKey& key, const std::string& participant_name,
                   const std::string& peer_name, const Identity& identity, ChannelMode mode) const {
  if (filter_.mode && *filter_.mode != mode) return false;
  if (identity_ && !is_same_or_narrower(vocabulary, identity, *identity_, place_.get())) return false;
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
