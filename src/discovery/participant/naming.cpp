#include "discovery/participant/naming.hpp"

#include "base/text.hpp"
#include "discovery/participant/expressions.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/compiled/similar.hpp"
#include "reasoning/syntax/manchester/parse.hpp"

namespace geminga::participant {
namespace {

std::expected<std::string, Error> resolve_class(const compiled::Ontology* ontology, std::string_view key,
                                                const std::string& name) {
  const auto impossible = [&](const std::string& why) {
    return std::unexpected(Error{ErrorCode::impossible, std::string(key) + "=" + base::printable(name) + ": " + why});
  };
  if (ontology == nullptr) return impossible("no ontology is loaded: start gemingad with --ontology");
  const auto found = ontology->find(name);
  if (!found && manchester::is_compound(name)) {
    return impossible("a class expression can be asked for, not offered, and is no representation: name a class");
  }
  if (!found) return impossible(describe(*ontology, name, found.error()));
  if (!ontology->is_satisfiable(*found)) {
    return impossible("the class is unsatisfiable, nothing can be one: geminga-query explain says why");
  }
  return std::string(ontology->iri(*found));
}

}  // namespace

std::string describe(const compiled::Ontology& ontology, std::string_view name, const compiled::NameError& error) {
  if (error.kind != compiled::NameError::Kind::unknown) return error.text;
  return error.text +
         compiled::did_you_mean(compiled::find_similar(ontology, name, {.classes = compiled::max_compared_classes}));
}

std::expected<Identity, Error> resolve(const compiled::Ontology* ontology, const NamedIdentity& named) {
  if (const auto* number = std::get_if<NumericIdentity>(&named)) return *number;
  if (const auto* text = std::get_if<TextIdentity>(&named)) return *text;
  const auto& names = std::get<ConceptNames>(named);
  SemanticIdentity identity;
  auto concept_iri = resolve_class(ontology, "concept", names.concept_name);
  if (!concept_iri) return std::unexpected(concept_iri.error());
  identity.concept_iri = std::move(*concept_iri);
  if (!names.representation_name.empty()) {
    auto representation_iri = resolve_class(ontology, "representation", names.representation_name);
    if (!representation_iri) return std::unexpected(representation_iri.error());
    identity.representation_iri = std::move(*representation_iri);
  }
  return identity;
}

std::expected<Identity, Error> resolve(Expressions& expressions, const compiled::Ontology* ontology,
                                       const NamedIdentity& named) {
  const auto* names = std::get_if<ConceptNames>(&named);
  const bool is_expression = names != nullptr && ontology != nullptr && !ontology->find(names->concept_name) &&
                             manchester::is_compound(names->concept_name);
  if (!is_expression) return resolve(ontology, named);
  auto resolved = expressions.resolve(names->concept_name);
  if (!resolved) {
    return std::unexpected(
        Error{resolved.error().code, "concept=" + base::printable(names->concept_name) + ": " + resolved.error().text});
  }
  SemanticIdentity identity{.concept_iri = std::move(*resolved), .representation_iri = {}};
  if (!names->representation_name.empty()) {
    auto representation_iri = resolve_class(ontology, "representation", names->representation_name);
    if (!representation_iri) return std::unexpected(representation_iri.error());
    identity.representation_iri = std::move(*representation_iri);
  }
  return identity;
}

// The canonical text has angle brackets around IRIs, in comparisons behind a blank, and within quotes, of which a
// backslash takes away the meaning.
std::string short_expression(const compiled::Ontology* ontology, std::string_view canonical) {
  std::string text;
  bool is_quoted = false;
  for (std::size_t at = 0; at < canonical.size(); ++at) {
    const std::size_t end = canonical.find('>', at);
    const bool is_iri = !is_quoted && canonical[at] == '<' && end != std::string_view::npos &&
                        canonical.substr(at, end - at).find(' ') == std::string_view::npos;
    if (is_iri) {
      text += short_name(ontology, canonical.substr(at + 1, end - at - 1));
      at = end;
      continue;
    }
    if (canonical[at] == '"') is_quoted = !is_quoted;
    text += canonical[at];
    if (is_quoted && canonical[at] == '\\' && at + 1 < canonical.size()) text += canonical[++at];
  }
  return text;
}

std::string short_name(const compiled::Ontology* ontology, std::string_view iri) {
  return ontology == nullptr ? "<" + std::string(iri) + ">" : ontology->short_name(iri);
}

NamedIdentity named(const compiled::Ontology* ontology, const Identity& identity) {
  if (const auto* number = std::get_if<NumericIdentity>(&identity)) return *number;
  if (const auto* text = std::get_if<TextIdentity>(&identity)) return *text;
  const auto& iris = std::get<SemanticIdentity>(identity);
  return ConceptNames{
      .concept_name =
          has_expression(iris) ? short_expression(ontology, iris.concept_iri) : short_name(ontology, iris.concept_iri),
      .representation_name = iris.representation_iri.empty() ? "" : short_name(ontology, iris.representation_iri)};
}

NamedPublication named(const compiled::Ontology* ontology, const Publication& publication) {
  return NamedPublication{.identity = named(ontology, publication.identity),
                          .mode = publication.mode,
                          .address = publication.address,
                          .port = publication.port,
                          .protocol = publication.protocol,
                          .priority = publication.priority,
                          .attributes = publication.attributes};
}

NamedSubscription named(const compiled::Ontology* ontology, const Subscription& subscription) {
  return NamedSubscription{.identity = named(ontology, subscription.identity),
                           .mode = subscription.mode,
                           .weakest = subscription.weakest,
                           .providers = subscription.providers,
                           .where = subscription.where,
                           .limit = subscription.limit,
                           .priority = subscription.priority,
                           .port = subscription.port,
                           .address = subscription.address,
                           .attributes = subscription.attributes,
                           .protocols = subscription.protocols};
}

std::string digest_word(std::uint64_t digest) { return digest == 0 ? "-" : base::to_hex(digest, 16); }

}  // namespace geminga::participant
