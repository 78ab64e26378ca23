// The names of stated services by the ontology in force: when a service is stated, and when the ontology changes.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_STATEMENT_NAMES_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_STATEMENT_NAMES_HPP

#include "discovery/matching/editions.hpp"
#include "discovery/participant/clients/stated_services.hpp"
#include "discovery/participant/knowledge/resolver.hpp"

namespace geminga::participant {

/// Resolves them and checks what the text of a statement cannot say by itself. Each call sets the identity, and whether
/// the statement is in force or waits for an ontology.
class StatementNames {
 public:
  /// Borrows both for its life.
  StatementNames(const matching::Editions& editions, Resolver& resolver) : editions_(editions), resolver_(resolver) {}

  /// For a statement that is new or changed. One that only waits for the first ontology is not refused: it is out of
  /// force until then.
  [[nodiscard]] Refusal resolve(StatedPublication& stated);
  [[nodiscard]] Refusal resolve(StatedSubscription& stated);
  /// For a statement that was taken in by another ontology. Gives why it is not in force, the wait for an ontology or
  /// for its preparation included.
  [[nodiscard]] Refusal resolve_again(StatedPublication& stated);
  [[nodiscard]] Refusal resolve_again(StatedSubscription& stated);

 private:
  template <typename Stated>
  [[nodiscard]] Refusal resolve_and_check(Stated& stated);
  template <typename Stated>
  [[nodiscard]] Refusal resolve_by_another(Stated& stated);

  const matching::Editions& editions_;
  Resolver& resolver_;
};

}  // namespace geminga::participant

#endif
