// The identity of a service: a number, a text, or a concept with a representation (paper section 3.1).
#ifndef GEMINGA_IDENTITY_HPP
#define GEMINGA_IDENTITY_HPP

#include <compare>
#include <cstdint>
#include <string>
#include <variant>

namespace geminga {

/// The 32-bit form of an identity. Equal values are candidates, never proof: a match compares full identities.
using Id32 = std::uint32_t;

/// An identity that is a 32-bit number and nothing else.
struct NumericIdentity {
  Id32 number = 0;
  friend auto operator<=>(const NumericIdentity&, const NumericIdentity&) = default;
};

/// An identity that is a text: UTF-8, compared byte by byte, never normalised.
struct TextIdentity {
  std::string text;
  friend auto operator<=>(const TextIdentity&, const TextIdentity&) = default;
};

/// A concept and a representation, each a full IRI without angle brackets, compared byte by byte (RDF 1.1
/// Concepts, 3.2). An empty representation is unstated. Instead of an IRI the concept of a subscription may be a class
/// expression in canonical form (src/reasoning/syntax/manchester/MANCHESTER.md), in which each IRI has its brackets.
struct SemanticIdentity {
  std::string concept_iri;
  std::string representation_iri;
  friend auto operator<=>(const SemanticIdentity&, const SemanticIdentity&) = default;
};

/// The full identity of a service. Identities of different kinds are never equal, whatever their 32-bit forms.
using Identity = std::variant<NumericIdentity, TextIdentity, SemanticIdentity>;

/// Whether the concept is an expression: no IRI holds an angle bracket, and every expression does.
[[nodiscard]] bool has_expression(const SemanticIdentity& identity);
[[nodiscard]] bool has_expression(const Identity& identity);

/// The octets that are hashed: a text as it is; `<concept>` or `<concept><representation>`, an expression in round
/// brackets instead of angle ones; a number in decimal.
/// Specified, with test vectors, in src/identity/IDENTITY.md.
[[nodiscard]] std::string canonical_form(const Identity& identity);

/// The 32-bit identity: the number itself, or XXH32 with seed 0 over the canonical form.
[[nodiscard]] Id32 id32(const Identity& identity);

}  // namespace geminga

#endif
