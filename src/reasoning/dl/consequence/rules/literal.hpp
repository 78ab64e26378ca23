// Terms and literals of context clauses, as numbers whose order is the context order.
//
// A context is about one thing x, its predecessor y and its successors f(x). The order of Bate et al. (section 4,
// definition 3) requires: f(x) > x > y; a literal is above the one in which a term is replaced by a smaller term; and
// what may be passed to the predecessor, the literals over y and x alone, is below everything else. The order here is
// total, so that a head has one maximal literal, except for the query literals of contexts that answer questions; see
// is_query() in rules.hpp.
//
// Legend: x y f(x) g(x) as above, s t any of them, A B concepts (numbers of predicates), R S roles.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_RULES_LITERAL_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_RULES_LITERAL_HPP

#include <compare>
#include <cstdint>

namespace geminga::consequence {

/// y, x or f(x); ascending in the term order.
enum class Term : std::uint32_t {};
inline constexpr Term y_term{0};
inline constexpr Term x_term{1};
/// Function symbols are numbered from 0.
inline constexpr std::uint32_t max_functions = (1U << 24) - 4;
[[nodiscard]] constexpr Term successor(std::uint32_t function) { return Term{function + 2}; }
[[nodiscard]] constexpr bool is_successor(Term term) { return term > x_term; }
[[nodiscard]] constexpr std::uint32_t function_of(Term term) { return static_cast<std::uint32_t>(term) - 2; }

/// In the order of literals about the same term.
enum class LiteralKind : std::uint8_t {
  equal,      ///< s = t; the payload is the smaller term
  different,  ///< s and t are different; the same
  unary,      ///< A(t)
  outgoing,   ///< R(x, t), t is not x
  incoming,   ///< R(t, x), t is not x
  reflexive,  ///< R(t, t)
};

/// Bits 40 to 63 hold the greatest term, or y's number if the literal has no term beyond x and y, except for A(x) and
/// R(x, x). Bits 36 to 39 hold the kind, bits 0 to 31 the predicate or the smaller term.
struct Literal {
  std::uint64_t bits = 0;
  friend auto operator<=>(const Literal&, const Literal&) = default;

  [[nodiscard]] constexpr Term term() const { return Term{static_cast<std::uint32_t>(bits >> 40)}; }
  [[nodiscard]] constexpr LiteralKind kind() const { return static_cast<LiteralKind>((bits >> 36) & 7); }
  [[nodiscard]] constexpr std::uint32_t predicate() const { return static_cast<std::uint32_t>(bits); }
  /// The smaller term of an equality or inequality.
  [[nodiscard]] constexpr Term other() const { return Term{static_cast<std::uint32_t>(bits)}; }
};

[[nodiscard]] constexpr Literal make_key(std::uint64_t kind, Term term, std::uint32_t payload) {
  return {(static_cast<std::uint64_t>(term) << 40) | (kind << 36) | payload};
}
[[nodiscard]] constexpr Literal make_literal(LiteralKind kind, Term term, std::uint32_t payload) {
  return make_key(static_cast<std::uint64_t>(kind), term, payload);
}
[[nodiscard]] constexpr Literal unary(std::uint32_t predicate, Term term) {
  return make_literal(LiteralKind::unary, term, predicate);
}
/// R(x, t) or, where `is_incoming`, R(t, x).
[[nodiscard]] constexpr Literal binary(std::uint32_t role, Term term, bool is_incoming) {
  if (term == x_term) return make_literal(LiteralKind::reflexive, x_term, role);
  return make_literal(is_incoming ? LiteralKind::incoming : LiteralKind::outgoing, term, role);
}
/// s = t or, where `is_different`, its opposite. s and t must not be the same.
[[nodiscard]] constexpr Literal equality(Term s, Term t, bool is_different) {
  if (s < t) return equality(t, s, is_different);
  const LiteralKind kind = is_different ? LiteralKind::different : LiteralKind::equal;
  // x = y may be passed to the predecessor and is the least of all literals.
  return make_literal(kind, s == x_term ? y_term : s, static_cast<std::uint32_t>(s == x_term ? x_term : t));
}

/// Whether a literal is over x and y alone, and matters to the predecessor (Pr(O) in the paper).
[[nodiscard]] constexpr bool is_of_predecessor(Literal literal) { return literal.term() == y_term; }

/// Keys of the store that are no literals. No literal has their kinds or bit 39.
inline constexpr Literal no_literal{~std::uint64_t{0}};
inline constexpr std::uint64_t edge_kind = 6;
inline constexpr std::uint64_t nominal_kind = 7;
/// A literal as it stands in a body.
[[nodiscard]] constexpr Literal in_body(Literal literal) { return {literal.bits | (std::uint64_t{1} << 39)}; }
/// The successor f(x), and the edge by which f(x) of a context comes.
[[nodiscard]] constexpr Literal successor_key(Term f) { return in_body(make_literal(LiteralKind::different, f, 0)); }
[[nodiscard]] constexpr Literal edge_key(Term f, std::uint32_t context) {
  return in_body(make_key(edge_kind, f, context));
}
/// The key under which the one term that is known to be in a nominal is kept.
[[nodiscard]] constexpr Literal nominal_key(std::uint32_t predicate) {
  return in_body(make_key(nominal_kind, x_term, predicate));
}
/// All t with R(x, t) or, where `is_incoming`, R(t, x).
[[nodiscard]] constexpr Literal neighbours(std::uint32_t role, bool is_incoming) {
  const auto kind = is_incoming ? LiteralKind::incoming : LiteralKind::outgoing;
  return in_body(make_literal(kind, Term{(1U << 24) - 1}, role));
}

/// Renames a literal about f(x) and x for the context of that successor, where they are x and y.
[[nodiscard]] constexpr Literal seen_by_successor(Literal literal) {
  switch (literal.kind()) {
    case LiteralKind::outgoing:
      return binary(literal.predicate(), y_term, true);
    case LiteralKind::incoming:
      return binary(literal.predicate(), y_term, false);
    default:
      return make_literal(literal.kind(), x_term, literal.predicate());
  }
}
/// Renames a literal of a successor's context for the context of which it is f(x).
[[nodiscard]] constexpr Literal seen_by_predecessor(Literal literal, Term f) {
  switch (literal.kind()) {
    case LiteralKind::equal:
      return equality(f, x_term, false);
    case LiteralKind::unary:
      return unary(literal.predicate(), literal.term() == y_term ? x_term : f);
    case LiteralKind::outgoing:
      return binary(literal.predicate(), f, true);
    case LiteralKind::incoming:
      return binary(literal.predicate(), f, false);
    default:
      return make_literal(LiteralKind::reflexive, literal.term() == y_term ? x_term : f, literal.predicate());
  }
}

[[nodiscard]] constexpr std::uint64_t hash_of(Literal literal) {
  const std::uint64_t mixed = (literal.bits ^ (literal.bits >> 32)) * 0x9e3779b97f4a7c15ULL;
  return mixed ^ (mixed >> 29);
}

}  // namespace geminga::consequence

#endif
