// Obstacles: codes for what keeps a publication from meeting a subscription.
#ifndef GEMINGA_DISCOVERY_MATCHING_MEETING_OBSTACLE_HPP
#define GEMINGA_DISCOVERY_MATCHING_MEETING_OBSTACLE_HPP

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <tuple>

#include "discovery/matching/meeting/request.hpp"

namespace geminga::matching {

/// The codes of QUERIES.md ("Codes"). Their words are only ever appended.
enum class Obstacle : std::uint8_t {
  none,
  // Of the identity of a pair.
  kind,                     ///< the identities are of different kinds: numbers, texts, concepts
  number,                   ///< another number
  text,                     ///< another text
  similar_text,             ///< another text, which differs by a slip of the keyboard
  clash,                    ///< the number is that of two different concepts
  no_ontology,              ///< without an ontology names are compared letter by letter
  unknown_concept,          ///< the concept that is asked for is unknown here
  unknown_offer,            ///< the concept that is offered is unknown here
  unsatisfiable,            ///< a concept can have no instance
  unclassified,             ///< the expression is unknown, unsatisfiable, or waits to be classified
  unrelated,                ///< neither concept subsumes the other
  disjoint,                 ///< nothing can be both, where concepts that overlap are accepted
  undecided,                ///< it is not decided whether something can be both, where that would be accepted
  representation,           ///< the concept fits, the representation is another one
  representation_unstated,  ///< the concept fits, the offer states no representation
  unknown_representation,   ///< the concept fits, a representation is unknown here
  broader,                  ///< the offer is broader, and that is not accepted
  degree,                   ///< it fits, but less well than what is accepted
  // Of the rest of a pair, in the order of Finding::first().
  mode,
  protocol,
  provider,
  scope,       ///< one of them is not in the scope of the other
  where,       ///< the consumer's condition
  for_whom,    ///< the provider's condition
  signature,   ///< inputs or outputs
  unreadable,  ///< a scope or a condition cannot be read
  // Of a pair that meets, or of a request as a whole.
  outranked,           ///< better ones take the places that the limit leaves
  incumbent,           ///< one that is no better was there first
  nobody,              ///< no offer comes near
  ontology_differs,    ///< the consumer's host has another ontology, and the name is unknown here
  incomplete,          ///< neither is known to subsume the other, and the place of an expression may be incomplete
  unclassified_offer,  ///< the same as unclassified, of the offered expression
  on,                  ///< the provider's participant is not known to be what is asked for
  unreachable,         ///< the address of the offer cannot be reached from the consumer's host
};

/// The word of GCNP. Static storage.
[[nodiscard]] std::string_view to_string(Obstacle obstacle);

/// All that is wrong with one pair, as codes.
struct Finding {
  Obstacle identity = Obstacle::none;
  bool is_mode_met = true;
  bool is_protocol_met = true;
  bool is_provider_met = true;
  bool is_scope_met = true;
  bool is_on_met = true;
  bool is_where_met = true;
  bool is_for_met = true;
  bool is_signature_met = true;
  bool is_reach_met = true;
  // Whether these can be read; a condition that cannot be read is not met.
  bool is_scope_readable = true;
  bool is_where_readable = true;
  bool is_for_readable = true;
  // Also where they are too weak.
  std::optional<Match> by_identity{};  ///< of the identity alone
  std::optional<Match> match{};        ///< of identity and signature

  [[nodiscard]] bool meets() const { return first() == Obstacle::none; }
  /// The first obstacle in the order identity, mode, protocol, provider, scope, on, conditions of both, signature,
  /// reach.
  [[nodiscard]] Obstacle first() const;
  /// How many of these are not met.
  [[nodiscard]] std::size_t count() const;
  /// Orders findings, the nearest first: pairs whose concepts fit by how much is wrong, then the others by how far
  /// apart their identities are.
  [[nodiscard]] std::tuple<unsigned, std::size_t, unsigned, Match> remoteness() const;
  /// Whether at least the concepts fit, so that one side alone could make the pair meet.
  [[nodiscard]] bool is_near() const;
};

/// Goes through the whole pair, as meets() does until it has found the first obstacle. `identity` is left at none.
[[nodiscard]] Finding compared(const registry::SubscriptionEntry& subscription, const Request& request,
                               const Offer& offer, const vocabulary::Vocabulary& vocabulary);
/// The same with the obstacle in the identity. Agrees with meets(). `is_kept_apart` says that a clash of numbers keeps
/// the two apart.
[[nodiscard]] Finding examine(const registry::SubscriptionEntry& subscription, const Request& request,
                              const Offer& offer, const vocabulary::Vocabulary& vocabulary, bool is_kept_apart);

}  // namespace geminga::matching

#endif
