// The smallest part of a random test's steps that still fails.
#ifndef GEMINGA_TESTS_SUPPORT_SHRINK_HPP
#define GEMINGA_TESTS_SUPPORT_SHRINK_HPP

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace geminga::test {

/// Removes every step that is not needed for `fails` to be true of the rest, first many at once and at last one by one
/// (Zeller's delta debugging, without its complements). Requires fails(steps); each step must make sense without any
/// other. `runs` bounds the calls of `fails`.
template <typename Step, typename Fails>
[[nodiscard]] std::vector<Step> shrunk(std::vector<Step> steps, const Fails& fails, std::size_t runs = 2000) {
  std::size_t size = std::max<std::size_t>(steps.size() / 2, 1);
  bool has_shrunk = false;
  while (!steps.empty()) {
    for (std::size_t at = 0; at < steps.size() && runs > 0;) {
      std::vector<Step> fewer = steps;
      const auto begin = fewer.begin() + static_cast<std::ptrdiff_t>(at);
      fewer.erase(begin, begin + static_cast<std::ptrdiff_t>(std::min(size, steps.size() - at)));
      --runs;
      if (fails(std::as_const(fewer))) {
        steps = std::move(fewer);
        has_shrunk = true;
      } else {
        at += size;
      }
    }
    if (runs == 0 || (size == 1 && !has_shrunk)) break;
    size = std::max<std::size_t>(size / 2, 1);
    has_shrunk = size > 1;
  }
  return steps;
}

}  // namespace geminga::test

#endif
