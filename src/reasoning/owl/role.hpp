// An object property as property axioms and clauses name it: a number, and whether it is inverted.
#ifndef GEMINGA_REASONING_OWL_ROLE_HPP
#define GEMINGA_REASONING_OWL_ROLE_HPP

#include <compare>
#include <cstdint>

namespace geminga::owl {

/// An object property. Dense.
enum class PropertyId : std::uint32_t {};

/// An object property or its inverse.
struct Role {
  PropertyId property{};
  bool is_inverse = false;
  friend auto operator<=>(const Role&, const Role&) = default;
};

[[nodiscard]] constexpr Role inverse(Role role) { return {role.property, !role.is_inverse}; }

}  // namespace geminga::owl

#endif
