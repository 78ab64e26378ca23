// Degrees of match between an offered identity and a requested one.
#ifndef GEMINGA_MATCH_HPP
#define GEMINGA_MATCH_HPP

#include <cstdint>
#include <optional>
#include <string_view>

namespace geminga {

/// The degree of match of an offered concept O and a requested concept R. The degree of an identity is the weaker of
/// the degrees of concept and representation, by is_weaker(): numbers are only appended and say nothing about the
/// order.
enum class Degree : std::uint8_t {
  exact,       ///< the same identifier
  equivalent,  ///< O and R subsume each other
  narrower,    ///< O is subsumed by R: the consumer gets a special case of what it asked for
  broader,     ///< R is subsumed by O: only where the consumer allows it
  /// The representation can be turned into one that is asked for, and the consumer accepts that. Better than broader.
  converted,
  /// Neither subsumes the other, and something can be both: only where the consumer allows it. The weakest.
  overlapping,
};

/// The place of a degree in the order of arbitration: 0 is the best.
[[nodiscard]] constexpr std::uint8_t weakness(Degree degree) {
  if (degree == Degree::converted) return 3;
  if (degree == Degree::broader) return 4;
  return static_cast<std::uint8_t>(degree);
}
[[nodiscard]] constexpr bool is_weaker(Degree a, Degree b) { return weakness(a) > weakness(b); }

/// The largest cost of conversions, as a subscription states it: any cost.
inline constexpr std::uint32_t any_cost = 0xffffffff;

/// The word of GCNP for a degree. Static storage.
[[nodiscard]] std::string_view to_string(Degree degree);
/// The degree of a GCNP word, or nothing.
[[nodiscard]] std::optional<Degree> degree(std::string_view word);

}  // namespace geminga

#endif
