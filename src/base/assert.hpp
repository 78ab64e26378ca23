// Assertions for what cannot happen. They stay on in release; bytes from outside must never reach one.
#ifndef GEMINGA_BASE_ASSERT_HPP
#define GEMINGA_BASE_ASSERT_HPP

namespace geminga::base {

/// Prints the failed condition and its place to standard error, and aborts.
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line) noexcept;

}  // namespace geminga::base

/// Aborts with file and line if `condition` does not hold, in every build.
#define GEMINGA_ASSERT(condition) \
  ((condition) ? void(0) : ::geminga::base::assertion_failed(#condition, __FILE__, __LINE__))

#endif
