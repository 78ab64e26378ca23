#include "discovery/participant/naming.hpp"

#include <utility>

#include "base/text.hpp"
#include "discovery/participant/expressions.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {
namespace {

std::expected<std::string, Error> resolve_class(const vocabulary::Vocabulary& vocabulary, std::string_view key,
                                                const std::string& name) {
  const auto impossible = [&](const std::string& why) {
    return std::unexpected(Error{ErrorCode::impossible, std::string(key) + "=" + base::printable(name) + ": " + why});
  };
  if (!vocabulary.is_loaded()) return impossible("no ontology is loaded: start gemingad with --ontology");
  if (vocabulary.is_expression(name)) {
    return impossible("a class expression can be asked for, not offered, and is no representation: name a class");
  }
  const auto found = vocabulary.find(name);
  if (!found) return impossible(found.error());
  if (!vocabulary.is_consistent()) {
    return impossible(
        "the ontology contradicts itself, so that no class can have an instance: see geminga-query ontology");
  }
  if (!vocabulary.is_satisfiable(*found)) {
    return impossible("the class is unsatisfiable, nothing can be one: geminga-query explain says why");
  }
  return std::string(vocabulary.iri(*found));
}

/// The identity of a concept whose IRI or canonical expression is known.
std::expected<Identity, Error> with_representation(const vocabulary::Vocabulary& vocabulary, std::string concept_iri,
                                                   const std::string& representation_name) {
  SemanticIdentity identity{.concept_iri = std::move(concept_iri), .representation_iri = {}};
  if (!representation_name.empty()) {
    auto representation_iri = resolve_class(vocabulary, "representation", representation_name);
    if (!representation_iri) return std::unexpected(representation_iri.error());
    identity.representation_iri = std::move(*representation_iri);
  }
  return identity;
}

}  // namespace

std::expected<Identity, Error> resolve(const vocabulary::Vocabulary& vocabulary, const NamedIdentity& named) {
  if (const auto* number = std::get_if<NumericIdentity>(&named)) return *number;
  if (const auto* text = std::get_if<TextIdentity>(&named)) return *text;
  const auto& names = std::get<ConceptNames>(named);
  auto concept_iri = resolve_class(vocabulary, "concept", names.concept_name);
  if (!concept_iri) return std::unexpected(concept_iri.error());
  return with_representation(vocabulary, std::move(*concept_iri), names.representation_name);
}

std::expected<Identity, Error> resolve(Expressions& expressions, const vocabulary::Vocabulary& vocabulary,
                                       const NamedIdentity& named) {
  const auto* names = std::get_if<ConceptNames>(&named);
  if (names == nullptr || !vocabulary.is_expression(names->concept_name)) return resolve(vocabulary, named);
  auto resolved = expressions.resolve(vocabulary, names->concept_name);
  if (!resolved) {
    return std::unexpected(
        Error{resolved.error().code, "concept=" + base::printable(names->concept_name) + ": " + resolved.error().text});
  }
  return with_representation(vocabulary, std::move(*resolved), names->representation_name);
}

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
                           .convert = subscription.convert};
}

std::string digest_word(std::uint64_t digest) { return digest == 0 ? "-" : base::to_hex(digest, 16); }

}  // namespace geminga::participant
