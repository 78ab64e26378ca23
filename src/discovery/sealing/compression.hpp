// Compression of announcements by a dictionary of their common octets, and the way back into a bounded text.
#ifndef GEMINGA_DISCOVERY_SEALING_COMPRESSION_HPP
#define GEMINGA_DISCOVERY_SEALING_COMPRESSION_HPP

#include <cstddef>
#include <expected>
#include <memory>
#include <span>

#include "discovery/sealing/rejection.hpp"

namespace geminga::sealing {

/// Compresses and expands with the contexts of zstd, some hundred kilobytes. They stay behind a pointer, so that only
/// compression.cpp names zstd.
class Compression {
 public:
  Compression();
  ~Compression();
  Compression(const Compression&) = delete;
  Compression& operator=(const Compression&) = delete;

  /// Compresses the text into `octets`, which has room for the text as it is. Returns the size; 0: it does not pay.
  [[nodiscard]] std::size_t compress(std::span<const std::byte> text, std::span<std::byte> octets);
  /// Expands into `text` and returns the size. Never writes behind `text`: what would not fit there is malformed, and
  /// so is what is no compressed text.
  [[nodiscard]] std::expected<std::size_t, Rejection> expand(std::span<const std::byte> octets,
                                                             std::span<std::byte> text);

 private:
  class Contexts;
  std::unique_ptr<Contexts> contexts_;
};

}  // namespace geminga::sealing

#endif
