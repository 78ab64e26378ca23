// The contexts of a saturation, found by their keys.
#ifndef GEMINGA_REASONING_DL_CONSEQUENCE_CONTEXT_TABLE_HPP
#define GEMINGA_REASONING_DL_CONSEQUENCE_CONTEXT_TABLE_HPP

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "reasoning/dl/consequence/context.hpp"
#include "reasoning/dl/consequence/rules/rules.hpp"

namespace geminga::consequence {

/// A table in parts, each with its lock. The arenas of the threads must outlive it.
class ContextTable {
 public:
  /// The contexts of `wanted` (predicates) answer queries.
  ContextTable(const Rules& rules, std::span<const std::uint32_t> wanted);

  /// The context with this key, which is made if there is none.
  struct Entry {
    Context& context;
    bool is_new = false;
  };
  /// Any thread may call it.
  [[nodiscard]] Entry find_or_make(ContextKey&& key);
  /// nullptr if there is none. Not while threads work.
  [[nodiscard]] const Context* find(const ContextKey& key) const;
  /// Calls `use` with each context, in any order. Not while threads work.
  template <typename Use>
  void for_each(Use&& use) const {
    for (const Part& part : parts_) {
      for (const auto& context : part.contexts) use(std::as_const(*context));
    }
  }
  [[nodiscard]] std::size_t size() const { return size_.load(std::memory_order_relaxed); }

 private:
  static constexpr std::size_t parts = 64;
  struct Part {
    mutable SpinLock lock;
    std::vector<std::unique_ptr<Context>> contexts;
    std::vector<std::uint32_t> slots;  ///< positions from 1, by hash of the key; 0: free

    void grow();
    /// The slot that holds the key's context, or the free slot where it belongs.
    [[nodiscard]] std::size_t slot_of(const ContextKey& key, std::uint64_t hash) const;
  };

  [[nodiscard]] static std::uint64_t hash_of(const ContextKey& key);
  [[nodiscard]] bool answers_queries(const ContextKey& key) const;

  std::vector<bool> is_wanted_;  ///< by predicate
  std::array<Part, parts> parts_;
  std::atomic<std::size_t> size_{0};
};

}  // namespace geminga::consequence

#endif
