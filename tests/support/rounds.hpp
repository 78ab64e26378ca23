// The number of rounds of a test that repeats itself with another seed each time.
#ifndef GEMINGA_TESTS_SUPPORT_ROUNDS_HPP
#define GEMINGA_TESTS_SUPPORT_ROUNDS_HPP

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <cstdlib>

#include "base/text.hpp"

namespace geminga::test {

/// The percentage of its rounds that a random test runs: a tenth under a sanitizer, which looks at the accesses of each
/// path that is taken, and ten seeds take the paths that a hundred take. Wrong results are looked for by the other
/// builds. GEMINGA_ROUNDS says another percentage, such as 1000 for a night.
[[nodiscard]] inline std::uint64_t percent_of_rounds() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  constexpr std::uint64_t usual = 10;
#else
  constexpr std::uint64_t usual = 100;
#endif
  const char* said = std::getenv("GEMINGA_ROUNDS");
  return said == nullptr ? usual : base::parse_number<std::uint64_t>(said).value_or(usual);
}

/// Returns how many of `all` rounds are run, at least one; or how often something must happen in them that happens at
/// least `all` times in all of them.
template <std::integral Number>
[[nodiscard]] Number rounds(Number all) {
  return std::max<Number>(1, static_cast<Number>(static_cast<std::uint64_t>(all) * percent_of_rounds() / 100));
}

}  // namespace geminga::test

#endif
