// The smallest sets of members for which something holds that holds for every larger set, too.
//
// Each set that fails is enlarged until no member can be added without success. Every solution that contains the
// failed set has one of the members outside, so that these are the ways to go on: Reiter's hitting set tree (A Theory
// of Diagnosis from First Principles, 1987) with conflicts found by halves as in QuickXplain (Junker 2004).
#ifndef GEMINGA_REASONING_EXPLANATION_ABDUCTION_MINIMAL_SETS_HPP
#define GEMINGA_REASONING_EXPLANATION_ABDUCTION_MINIMAL_SETS_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace geminga::abduction {

/// A set of the numbers 0 to 63.
using Members = std::uint64_t;

/// The set of one number.
[[nodiscard]] constexpr Members only(std::size_t member) { return Members{1} << member; }
/// The numbers of a set, ascending.
[[nodiscard]] std::vector<std::size_t> numbers_of(Members members);

/// The sets that are searched. `with[m]` are the members without which m cannot be in a set, m itself among them.
struct SearchSpace {
  Members all = 0;
  Members begin = 0;  ///< members that every solution is known to have
  std::span<const Members> with;
  /// Orders solutions, the least first. A larger set must not count less.
  std::function<std::size_t(Members)> size;
};

/// At most `most` minimal sets for which `holds`, the smallest first; if it holds for none, there are none. What
/// `holds` says of a set must be right for every larger one. Each set is asked about once.
[[nodiscard]] std::vector<Members> minimal_sets(const SearchSpace& space, const std::function<bool(Members)>& holds,
                                                std::size_t most);

}  // namespace geminga::abduction

#endif
