// Makes announcements smaller by a dictionary of what announcements are made of, and bounded texts of them again.
#ifndef GEMINGA_DISCOVERY_SEALING_COMPRESSION_HPP
#define GEMINGA_DISCOVERY_SEALING_COMPRESSION_HPP

#include <cstddef>
#include <expected>
#include <memory>
#include <span>

#include "discovery/sealing/rejection.hpp"

namespace geminga::sealing {

/// What zstd needs for one direction and the other; some hundred kilobytes.
class Compression {
 public:
  Compression();
  ~Compression();
  Compression(const Compression&) = delete;
  Compression& operator=(const Compression&) = delete;

  /// Writes the text smaller into `octets`, which has room for it as it is, and gives the size; 0: it does not pay.
  [[nodiscard]] std::size_t compress(std::span<const std::byte> text, std::span<std::byte> octets);
  /// Puts the text that was compressed into `text` and gives its size. It never writes behind `text`: what would not
  /// fit there is malformed, and so is what is no compressed text.
  [[nodiscard]] std::expected<std::size_t, Rejection> expand(std::span<const std::byte> octets,
                                                             std::span<std::byte> text);

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace geminga::sealing

#endif
