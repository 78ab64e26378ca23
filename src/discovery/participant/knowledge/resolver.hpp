// The resolver: what our peers state, by the ontology in force. Identities, and the units of conditions.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_RESOLVER_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_RESOLVER_HPP

#include <expected>
#include <optional>
#include <string>
#include <string_view>

#include "discovery/matching/editions.hpp"
#include "discovery/participant/knowledge/expressions.hpp"
#include "discovery/participant/knowledge/ontology_reading.hpp"
#include "env/env.hpp"
#include "geminga/error.hpp"
#include "geminga/named.hpp"
#include "geminga/service.hpp"

namespace geminga::participant {

/// The error that a peer is answered, or nothing: silence is success.
using Refusal = std::optional<Error>;

/// Whether a statement waits for an ontology that is still being read.
[[nodiscard]] inline bool is_awaited(const Refusal& refusal) {
  return refusal && refusal->code == ErrorCode::not_ready;
}

/// Reads the ontology in force; changes only what is remembered of class expressions.
class Resolver {
 public:
  /// Borrows all four for its life.
  Resolver(const env::Env& env, const matching::Editions& editions, Expressions& expressions,
           const OntologyReading& reading)
      : env_(env), editions_(editions), expressions_(expressions), reading_(reading) {}

  /// The identity of what is offered or asked for, with full IRIs. Numbers and texts need no ontology. 422 where a name
  /// is unknown or ambiguous, or a class can have no instance. Where no ontology is in force, a concept gets 503 while
  /// the first one is being read, and 422 otherwise. The concept may be a class expression
  /// (src/reasoning/syntax/manchester/MANCHESTER.md). An expression that is equivalent to a class becomes that class;
  /// of any other the canonical text is the concept. 503 until the ontology is prepared for expressions.
  [[nodiscard]] std::expected<Identity, Error> resolve(const NamedIdentity& named);
  /// The class or expression that has to describe the provider's participant, as it is announced: `<IRI>` or canonical
  /// text. Errors as resolve().
  [[nodiscard]] std::expected<std::string, Error> resolve_on(const std::string& on);
  /// Why class expressions cannot be compared: 503 until the ontology is prepared for them, which this begins. Requires
  /// an ontology.
  [[nodiscard]] std::expected<void, Error> require_expressions() { return expressions_.require(vocabulary()); }
  /// The place of an expression that resolve() gave for one of our peers.
  [[nodiscard]] Expressions::Place place(const std::string& canonical);
  /// The place of an expression that anybody has stated, where it has been placed, and why it has none.
  [[nodiscard]] Expressions::Place known_place(const std::string& canonical) const {
    return expressions_.known_place(vocabulary(), canonical);
  }
  [[nodiscard]] std::string problem(const std::string& canonical) const {
    return expressions_.problem(vocabulary(), canonical);
  }

  /// Whether an identity is missing only because no ontology is in force yet. Then its statement is kept, and comes
  /// into force with the ontology. (A statement that only waits until the ontology is prepared is handled again
  /// instead.)
  [[nodiscard]] bool is_awaited(const std::expected<Identity, Error>& identity) const {
    return !identity && is_awaited(identity.error());
  }
  [[nodiscard]] bool is_awaited(const Error& error) const {
    return !vocabulary().is_loaded() && error.code == ErrorCode::not_ready;
  }
  /// Whether a class expression has come and the ontology in force is yet to be prepared for it.
  [[nodiscard]] bool is_waiting() const { return expressions_.is_waiting(vocabulary()); }
  /// Why nothing can be said of classes where no ontology is in force.
  [[nodiscard]] Error no_ontology() const;

  /// Why `for` of a publication, or `where`, `prefer`, `favour` and `rank` of a subscription, cannot be read. 503 where
  /// a unit is unknown that the first ontology, which is still being read, may declare.
  [[nodiscard]] Refusal check_conditions(const Publication& publication) const;
  [[nodiscard]] Refusal check_conditions(const Subscription& subscription) const;

 private:
  [[nodiscard]] const vocabulary::Vocabulary& vocabulary() const { return editions_.vocabulary(); }
  /// The IRI of a class or the canonical text of an expression, which stands behind the key.
  [[nodiscard]] std::expected<std::string, Error> resolve_concept(std::string_view key, const std::string& name);
  [[nodiscard]] std::unexpected<Error> without_ontology(std::string_view key, const std::string& name) const;
  [[nodiscard]] Refusal unless_awaited(Refusal refusal) const;
  [[nodiscard]] Refusal check_condition(std::string_view condition, std::string_view key) const;

  const env::Env& env_;
  const matching::Editions& editions_;
  Expressions& expressions_;
  const OntologyReading& reading_;
};

}  // namespace geminga::participant

#endif
