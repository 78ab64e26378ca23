#include "discovery/participant/knowledge/naming.hpp"

#include "base/text.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {

NamedIdentity named(const vocabulary::Vocabulary& vocabulary, const Identity& identity) {
  if (const auto* number = std::get_if<NumericIdentity>(&identity)) return *number;
  if (const auto* text = std::get_if<TextIdentity>(&identity)) return *text;
  const auto& iris = std::get<SemanticIdentity>(identity);
  return ConceptNames{.concept_name = has_expression(iris) ? vocabulary.short_expression(iris.concept_iri)
                                                           : vocabulary.short_name(std::string_view(iris.concept_iri)),
                      .representation_name = iris.representation_iri.empty()
                                                 ? ""
                                                 : vocabulary.short_name(std::string_view(iris.representation_iri))};
}

NamedPublication named(const vocabulary::Vocabulary& vocabulary, const Publication& publication) {
  return NamedPublication{.identity = named(vocabulary, publication.identity),
                          .mode = publication.mode,
                          .address = publication.address,
                          .port = publication.port,
                          .protocol = publication.protocol,
                          .priority = publication.priority,
                          .attributes = publication.attributes,
                          .scope = publication.scope,
                          .for_whom = publication.for_whom};
}

NamedSubscription named(const vocabulary::Vocabulary& vocabulary, const Subscription& subscription) {
  return NamedSubscription{.identity = named(vocabulary, subscription.identity),
                           .mode = subscription.mode,
                           .weakest = subscription.weakest,
                           .providers = subscription.providers,
                           .where = subscription.where,
                           .limit = subscription.limit,
                           .priority = subscription.priority,
                           .port = subscription.port,
                           .address = subscription.address,
                           .attributes = subscription.attributes,
                           .protocols = subscription.protocols,
                           .favoured = subscription.favoured,
                           .prefer = subscription.prefer,
                           .rank = subscription.rank,
                           .scope = subscription.scope,
                           .convert = subscription.convert,
                           .on = subscription.on,
                           .reach = subscription.reach};
}

std::string digest_word(std::uint64_t digest) { return digest == 0 ? "-" : base::to_hex(digest, 16); }

}  // namespace geminga::participant
