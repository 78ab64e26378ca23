// Replaces the global operator new of this test program.
#include "scarce_memory.hpp"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

namespace geminga::reasoner {
namespace {

constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();
std::atomic<std::uint64_t> failing_from = never;
std::atomic<std::uint64_t> asked = 0;
thread_local bool is_test_thread = false;

void* take(std::size_t bytes, std::size_t alignment) {
  return alignment <= alignof(std::max_align_t)
             ? std::malloc(bytes == 0 ? 1 : bytes)
             : std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

void* allocate(std::size_t bytes, std::size_t alignment) {
  if (failing_from.load() != never && !is_test_thread && ++asked >= failing_from.load()) throw std::bad_alloc();
  void* block = take(bytes, alignment);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

}  // namespace

ScarceMemory::ScarceMemory(std::uint64_t first_failure) {
  is_test_thread = true;
  asked = 0;
  failing_from = first_failure;
}
ScarceMemory::~ScarceMemory() { failing_from = never; }
bool ScarceMemory::has_failed() const { return asked >= failing_from; }

}  // namespace geminga::reasoner

void* operator new(std::size_t bytes) { return geminga::reasoner::allocate(bytes, 1); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return geminga::reasoner::allocate(bytes, static_cast<std::size_t>(alignment));
}
// std::stable_sort asks by this one, and does with less where it gets nothing: no failure that anybody is told of.
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept { return geminga::reasoner::take(bytes, 1); }
void operator delete(void* block, const std::nothrow_t&) noexcept { std::free(block); }
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete(void* block, std::align_val_t) noexcept { std::free(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { std::free(block); }
