// How well an offered identity meets a requested one.
#ifndef GEMINGA_MATCH_HPP
#define GEMINGA_MATCH_HPP

#include <cstdint>
#include <optional>
#include <string_view>

namespace geminga {

/// The degree of match of an offered concept O and a requested concept R, best first. The degree of an identity is the
/// weaker of the degrees of concept and representation.
enum class Degree : std::uint8_t {
  exact,       ///< the same identifier
  equivalent,  ///< O and R subsume each other
  narrower,    ///< O is subsumed by R: the consumer gets a special case of what it asked for
  broader,     ///< R is subsumed by O: only where the consumer allows it
};

/// The word of GCNP for a degree. Static storage.
[[nodiscard]] std::string_view to_string(Degree degree);
/// The degree of a GCNP word, or nothing.
[[nodiscard]] std::optional<Degree> degree(std::string_view word);

}  // namespace geminga

#endif
