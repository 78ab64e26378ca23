#include "discovery/participant/knowledge/resolver.hpp"

#include <utility>

#include "base/text.hpp"
#include "discovery/matching/arbitration/preferences.hpp"
#include "discovery/matching/conditions/where.hpp"

namespace geminga::participant {
namespace {

/// A key and its value as an error shows them.
std::string stated(std::string_view key, const std::string& name) {
  return std::string(key) + '=' + base::printable(name);
}

std::expected<std::string, Error> resolve_class(const vocabulary::Vocabulary& vocabulary, std::string_view key,
                                                const std::string& name) {
  const auto impossible = [&](const std::string& why) {
    return std::unexpected(Error{ErrorCode::impossible, stated(key, name) + ": " + why});
  };
  if (vocabulary.is_expression(name)) return impossible("a class expression is no representation: name a class");
  const auto found = vocabulary.find(name);
  if (!found) return impossible(found.error());
  if (!vocabulary.is_consistent()) {
    return impossible(
        "the ontology contradicts itself, so that no class can have an instance: see geminga-query ontology");
  }
  if (!vocabulary.is_satisfiable(*found)) {
    return impossible("the class is unsatisfiable and can have no instance: geminga-query explain says why");
  }
  return std::string(vocabulary.iri(*found));
}

constexpr std::string_view concept_class = "https://geminga.example/core#Concept";
constexpr std::string_view representation_class = "https://geminga.example/core#Representation";

/// Whether the core vocabulary (ontology/core.ttl) says that a class is below this one of its classes.
bool is_below(const vocabulary::Vocabulary& vocabulary, std::string_view iri, std::string_view core_class) {
  const auto number = vocabulary.find_iri(iri);
  const auto above = vocabulary.find_iri(core_class);
  return number && above && vocabulary.is_subsumed(*number, *above);
}

/// The class of a name, unless the core vocabulary says that it belongs behind the other key.
std::expected<std::string, Error> resolve_as(const vocabulary::Vocabulary& vocabulary, std::string_view key,
                                             const std::string& name) {
  auto iri = resolve_class(vocabulary, key, name);
  const bool is_concept = key != "representation";
  if (!iri || !is_below(vocabulary, *iri, is_concept ? representation_class : concept_class)) return iri;
  return std::unexpected(Error{
      ErrorCode::impossible,
      stated(key, name) + (is_concept
                               ? ": this is a representation: name what the information is about as the concept, and "
                                 "this one as its representation"
                               : ": this is a concept: name how the information is written down, a class below "
                                 "geminga:Representation, or leave the representation out")});
}

/// The identity of a concept whose IRI or canonical expression is known.
std::expected<Identity, Error> with_representation(const vocabulary::Vocabulary& vocabulary, std::string concept_iri,
                                                   const std::string& representation_name) {
  SemanticIdentity identity{.concept_iri = std::move(concept_iri), .representation_iri = {}};
  if (!representation_name.empty()) {
    auto representation_iri = resolve_as(vocabulary, "representation", representation_name);
    if (!representation_iri) return std::unexpected(representation_iri.error());
    identity.representation_iri = std::move(*representation_iri);
  }
  return identity;
}

}  // namespace

std::unexpected<Error> Resolver::without_ontology(std::string_view key, const std::string& name) const {
  Error error = no_ontology();
  if (error.code == ErrorCode::impossible) error.text = stated(key, name) + ": " + error.text;
  return std::unexpected(std::move(error));
}

std::expected<std::string, Error> Resolver::resolve_concept(std::string_view key, const std::string& name) {
  if (!vocabulary().is_loaded()) return without_ontology(key, name);
  if (!vocabulary().is_expression(name)) return resolve_as(vocabulary(), key, name);
  auto resolved = expressions_.resolve(vocabulary(), name);
  if (resolved) return resolved;
  return std::unexpected(Error{resolved.error().code, stated(key, name) + ": " + resolved.error().text});
}

std::expected<Identity, Error> Resolver::resolve(const NamedIdentity& named) {
  if (const auto* number = std::get_if<NumericIdentity>(&named)) return *number;
  if (const auto* text = std::get_if<TextIdentity>(&named)) return *text;
  const auto& names = std::get<ConceptNames>(named);
  auto concept_iri = resolve_concept("concept", names.concept_name);
  if (!concept_iri) return std::unexpected(concept_iri.error());
  return with_representation(vocabulary(), std::move(*concept_iri), names.representation_name);
}

std::expected<std::string, Error> Resolver::resolve_on(const std::string& on) {
  auto resolved = resolve_concept("on", on);
  if (!resolved || has_expression(SemanticIdentity{*resolved, {}})) return resolved;
  return '<' + *resolved + '>';
}

Expressions::Place Resolver::place(const std::string& canonical) {
  return expressions_.place(vocabulary(), canonical, std::nullopt, env_.now());
}

Error Resolver::no_ontology() const {
  if (reading_.is_loading) {
    const auto since = std::chrono::duration_cast<std::chrono::seconds>(env_.now() - reading_.begun_at);
    return {ErrorCode::not_ready,
            "not ready: the ontology is being loaded (" + std::to_string(since.count()) + " s): ask again"};
  }
  if (!reading_.failure.empty()) return {ErrorCode::impossible, "no ontology is loaded: " + reading_.failure.front()};
  return {ErrorCode::impossible, "no ontology is loaded: start gemingad with --ontology"};
}

/// The error, unless an ontology that is to come may mend it.
Refusal Resolver::unless_awaited(Refusal refusal) const {
  if (!refusal || vocabulary().is_loaded()) return refusal;
  Error missing = no_ontology();
  return missing.code == ErrorCode::not_ready ? Refusal(std::move(missing)) : refusal;
}

Refusal Resolver::check_condition(std::string_view condition, std::string_view key) const {
  auto refusal = matching::check_where(condition, key, vocabulary().units());
  const bool is_of_unit = refusal && !matching::unit_problem(condition, vocabulary().units()).empty();
  return is_of_unit ? unless_awaited(std::move(refusal)) : refusal;
}

Refusal Resolver::check_conditions(const Publication& publication) const {
  return check_condition(publication.for_whom, "for");
}

Refusal Resolver::check_conditions(const Subscription& subscription) const {
  if (auto refusal = check_condition(subscription.where, "where")) return refusal;
  auto refusal = matching::check_preferences(subscription, vocabulary().units());
  return subscription.prefer.empty() ? refusal : unless_awaited(std::move(refusal));
}

}  // namespace geminga::participant
