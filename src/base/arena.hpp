// Memory for things that grow in small pieces and are freed all at once: blocks of powers of two, cut from large
// pieces.
#ifndef GEMINGA_BASE_ARENA_HPP
#define GEMINGA_BASE_ARENA_HPP

#include <array>
#include <bit>
#include <cstddef>
#include <memory>
#include <vector>

namespace geminga::base {

/// Freed blocks are kept for reuse, by size. One thread at a time. A block may be released to another arena, if both
/// live until nobody uses it.
class Arena {
 public:
  static constexpr std::size_t min_block_bytes = 16;

  Arena() = default;
  Arena(const Arena&) = delete;
  Arena& operator=(const Arena&) = delete;
  ~Arena();

  /// At least so many bytes, aligned to 16. Requires bytes > 0.
  [[nodiscard]] void* allocate(std::size_t bytes) {
    const std::size_t size_class = class_of(bytes);
    if (free_[size_class] != nullptr) {
      Free* block = free_[size_class];
      free_[size_class] = block->next;
      return block;
    }
    return cut(size_class);
  }
  /// `bytes` is the number that was asked for.
  void release(void* block, std::size_t bytes) {
    const std::size_t size_class = class_of(bytes);
    free_[size_class] = ::new (block) Free{free_[size_class]};
  }

 private:
  struct Free {
    Free* next;
  };
  struct Piece {
    void* begin;
    std::size_t bytes;
  };
  static std::size_t class_of(std::size_t bytes) {
    return bytes <= min_block_bytes ? 0 : static_cast<std::size_t>(std::bit_width(bytes - 1)) - 4;
  }
  [[nodiscard]] void* cut(std::size_t size_class);
  [[nodiscard]] void* new_piece(std::size_t bytes);

  std::array<Free*, 48> free_{};
  std::byte* next_ = nullptr;
  std::byte* end_ = nullptr;
  std::vector<Piece> pieces_;
};

}  // namespace geminga::base

#endif
