// Pieces: small ones first, so that a small ontology stays small, then ever larger ones on huge pages.
#include "base/arena.hpp"

#include <sys/mman.h>

#include <algorithm>
#include <new>

namespace geminga::base {
namespace {

constexpr std::size_t first_piece_bytes = std::size_t{1} << 15;
constexpr std::size_t max_piece_bytes = std::size_t{1} << 25;
constexpr std::size_t huge_page_bytes = std::size_t{1} << 21;

std::size_t alignment_of(std::size_t bytes) { return bytes >= huge_page_bytes ? huge_page_bytes : 64; }

}  // namespace

Arena::~Arena() {
  for (const Piece& piece : pieces_) ::operator delete(piece.begin, std::align_val_t{alignment_of(piece.bytes)});
}

void* Arena::new_piece(std::size_t bytes) {
  // The entry in the list is made first, so that nothing leaks if memory runs out for either.
  pieces_.push_back({nullptr, 0});
  void* piece = nullptr;
  try {
    piece = ::operator new(bytes, std::align_val_t{alignment_of(bytes)});
  } catch (...) {
    pieces_.pop_back();
    throw;
  }
  // This is only advice. If it cannot be followed, ordinary pages do.
  if (bytes >= huge_page_bytes) (void)::madvise(piece, bytes, MADV_HUGEPAGE);
  pieces_.back() = {piece, bytes};
  return piece;
}

void* Arena::cut(std::size_t size_class) {
  const std::size_t bytes = min_block_bytes << size_class;
  if (static_cast<std::size_t>(end_ - next_) < bytes) {
    if (bytes > max_piece_bytes / 8) return new_piece(bytes);
    // The rest of a piece is lost; it is less than an eighth of the piece.
    const std::size_t last = pieces_.empty() ? first_piece_bytes / 2 : pieces_.back().bytes;
    const std::size_t piece_bytes = std::clamp(last * 2, bytes * 8, max_piece_bytes);
    next_ = static_cast<std::byte*>(new_piece(piece_bytes));
    end_ = next_ + piece_bytes;
  }
  std::byte* block = next_;
  next_ += bytes;
  return block;
}

}  // namespace geminga::base
