// A calloc over malloc for small blocks: glibc has both in one heap, so that any free() takes the blocks back.
#include "reasoning/syntax/rdf/triples/zeroed_blocks.hpp"

#include <dlfcn.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)

namespace geminga::rdf {

bool has_zeroed_blocks() { return false; }

}  // namespace geminga::rdf

#else

extern "C" {

/// The calloc of glibc under its other name.
void* __libc_calloc(std::size_t count, std::size_t size) noexcept;  // NOLINT(bugprone-reserved-identifier): glibc's own

// Visible to libraptor2 even where a program hides its names.
[[gnu::visibility("default")]] void* calloc(std::size_t count, std::size_t size) noexcept {
  std::size_t octets = 0;
  if (__builtin_mul_overflow(count, size, &octets)) {
    errno = ENOMEM;
    return nullptr;
  }
  // No cache has larger ones, and of these the kernel gives many as zeroes already, which need not be written.
  constexpr std::size_t largest_of_cache = 1032;
  if (octets > largest_of_cache) return __libc_calloc(count, size);
  void* const block = std::malloc(octets);
  // A plain memset would make the compiler write this as a call of calloc.
  if (block != nullptr) explicit_bzero(block, octets);
  return block;
}
}

namespace geminga::rdf {

bool has_zeroed_blocks() { return dlsym(RTLD_DEFAULT, "calloc") == reinterpret_cast<void*>(&::calloc); }

}  // namespace geminga::rdf

#endif
