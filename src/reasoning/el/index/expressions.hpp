// EL expressions as numbers, and the rules that they have.
//
// Legend: A atom, C D E expressions, R S roles, C < D for "C SubClassOf D", T owl:Thing, F owl:Nothing. An expression
// occurs negatively left of <, where it must be recognised, and positively right of <, where it is asserted.
#ifndef GEMINGA_REASONING_EL_INDEX_EXPRESSIONS_HPP
#define GEMINGA_REASONING_EL_INDEX_EXPRESSIONS_HPP

#include <compare>
#include <cstdint>

#include "reasoning/el/index/roles.hpp"

namespace geminga::el {

/// An interned expression. Dense; equal expressions have equal numbers.
enum class ExprId : std::uint32_t {};
inline constexpr ExprId top_expr{0};
inline constexpr ExprId bottom_expr{1};

[[nodiscard]] constexpr std::uint32_t number(ExprId id) { return static_cast<std::uint32_t>(id); }

enum class ExprKind : std::uint8_t {
  atom,         ///< a named class, owl:Thing, owl:Nothing, a data range, or a name for an expression without rules
  nominal,      ///< an atom with one instance
  conjunction,  ///< C and D
  existential,  ///< R some C
  self,         ///< R Self
};

struct Expr {
  ExprKind kind = ExprKind::atom;
  std::uint32_t first = 0;   ///< conjunct; role; for atoms unused
  std::uint32_t second = 0;  ///< conjunct; filler
  friend bool operator==(const Expr&, const Expr&) = default;
};

/// C and partner are recognised as `conjunction`.
struct ConjunctionRule {
  ExprId partner{};
  ExprId conjunction{};
};
/// A link of `role` or a sub-role to something in the filler is recognised as `existential`.
struct ExistentialRule {
  RoleId role{};
  ExprId existential{};
  friend auto operator<=>(const ExistentialRule&, const ExistentialRule&) = default;
};
/// Each instance of the expression has a `role` successor in the atom `target`.
struct LinkRule {
  RoleId role{};
  ExprId target{};
  ExprId root{};  ///< the atom in whose context the link ends, which may be one above the target
  friend auto operator<=>(const LinkRule&, const LinkRule&) = default;
};

/// Each instance of the expression has `role` successors in the atom `target` only.
struct UniversalRule {
  RoleId role{};
  ExprId target{};
  friend auto operator<=>(const UniversalRule&, const UniversalRule&) = default;
};

}  // namespace geminga::el

#endif
