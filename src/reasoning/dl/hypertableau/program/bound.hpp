// Bounds: at-mosts in the form in which they are looked at.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_BOUND_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_BOUND_HPP

#include <compare>
#include <cstdint>

namespace geminga::hypertableau {

inline constexpr std::uint32_t no_predicate = 0xffffffffU;

/// At most `count` neighbours by a role (or values by a data property) that are in `filler`, or that are not in
/// `unless`; without either, at all.
struct Bound {
  std::uint32_t count = 1;
  bool is_data = false;
  bool is_inverse = false;
  std::uint32_t property = 0;
  std::uint32_t filler = no_predicate;  ///< a concept
  std::uint32_t unless = no_predicate;  ///< a concept or data range
  friend auto operator<=>(const Bound&, const Bound&) = default;
};

}  // namespace geminga::hypertableau

#endif
