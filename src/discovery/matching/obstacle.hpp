// What keeps a publication from meeting a subscription, by words that programs can act on.
#ifndef GEMINGA_DISCOVERY_MATCHING_OBSTACLE_HPP
#define GEMINGA_DISCOVERY_MATCHING_OBSTACLE_HPP

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <tuple>

#include "discovery/matching/request.hpp"

namespace geminga::matching {

/// QUERIES.md lists them ("Codes"). Their words are only ever appended.
enum class Obstacle : std::uint8_t {
  none,
  // Of the identity of a pair.
  kind,                     ///< a number, a text and a concept are of different kinds
  number,                   ///< another number
  text,                     ///< another text
  similar_text,             ///< another text that differs by a slip of the keyboard
  clash,                    ///< the number is that of two different concepts
  no_ontology,              ///< without an ontology names are compared letter by letter
  unknown_concept,          ///< the concept that is asked for is unknown here
  unknown_offer,            ///< the concept that is offered is unknown here
  unsatisfiable,            ///< a concept can have no instance
  unclassified,             ///< the expression is unknown, unsatisfiable, or waits to be classified
  unrelated,                ///< neither concept subsumes the other
  disjoint,                 ///< nothing can be both, where concepts that overlap are accepted
  undecided,                ///< whether something can be both is not decided, where that would be accepted
  representation,           ///< the concept fits, the representation is another one
  representation_unstated,  ///< the concept fits, the offer states no representation
  unknown_representation,   ///< the concept fits, a representation is unknown here
  broader,                  ///< what is offered is broader, and that was not allowed
  degree,                   ///< it fits, less well than what was allowed
  // Of the rest of a pair, in the order in which it is walked.
  mode,
  protocol,
  provider,
  scope,       ///< one of them is not in the scope of the other
  where,       ///< the consumer's condition
  for_whom,    ///< the provider's condition
  signature,   ///< inputs or outputs
  unreadable,  ///< a scope or a condition cannot be read
  // Of a pair that meets, and of a request as a whole.
  outranked,         ///< better ones take the places that the limit leaves
  incumbent,         ///< one that is no better was there first
  nobody,            ///< nothing that is offered comes near
  ontology_differs,  ///< the consumer's host has another ontology, and the name is unknown here
  incomplete,        ///< neither is known to subsume the other, and the place of the expression may miss something
};

/// The word of GCNP. Static storage.
[[nodiscard]] std::string_view to_string(Obstacle obstacle);

/// What was found out about one pair without putting it into words.
struct Finding {
  Obstacle identity = Obstacle::none;
  bool is_mode_met = true;
  bool is_protocol_met = true;
  bool is_provider_met = true;
  bool is_scope_met = true;
  bool is_where_met = true;
  bool is_for_met = true;
  bool is_signature_met = true;
  // Whether these can be read; one that cannot is not met.
  bool is_scope_readable = true;
  bool is_where_readable = true;
  bool is_for_readable = true;
  std::optional<Match> match{};  ///< of identity and signature, also where that is too weak

  [[nodiscard]] bool meets() const { return first() == Obstacle::none; }
  /// The first that is met on the way: identity, mode, protocol, provider, scope, conditions of both, signature.
  [[nodiscard]] Obstacle first() const;
  /// How many of these stand in the way.
  [[nodiscard]] std::size_t count() const;
  /// The lesser the nearer: those whose concept fits by how much is wrong, then the others by how far apart they are.
  [[nodiscard]] std::tuple<unsigned, std::size_t, unsigned, Match> remoteness() const;
  /// Whether the concept fits at least: something about the pair can be mended by one side alone.
  [[nodiscard]] bool is_near() const;
};

/// Goes through the whole pair. As meets(), which it agrees with; `is_kept_apart` says that a clash of numbers keeps
/// the two apart.
[[nodiscard]] Finding examine(const registry::SubscriptionEntry& subscription, const Request& request,
                              const Offer& offer, const vocabulary::Vocabulary& vocabulary, bool is_kept_apart);

}  // namespace geminga::matching

#endif
