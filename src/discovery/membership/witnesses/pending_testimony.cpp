#include "discovery/membership/witnesses/pending_testimony.hpp"

#include <algorithm>

#include "base/assert.hpp"

namespace geminga::membership {
namespace {

/// The octets as a number, little-endian on every machine. With a static size of eight it is one load.
template <std::size_t size>
std::uint64_t bits_of(std::span<const std::uint8_t, size> octets) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < octets.size(); ++i) bits |= std::uint64_t{octets[i]} << (8 * i);
  return bits;
}

}  // namespace

void PendingTestimony::resize(std::size_t places) {
  size_ = 0;
  blocks_ = (places + places_per_block - 1) / places_per_block;
  words_.resize(blocks_ * capacity);
}

void PendingTestimony::add(std::span<const std::uint8_t> octets, base::Instant at) {
  GEMINGA_ASSERT(!is_full());
  const auto word = std::span(words_).subspan(size_ * blocks_, blocks_);
  std::ranges::fill(word, 0);
  octets = octets.first(std::min(octets.size(), blocks_ * sizeof(std::uint64_t)));
  for (std::size_t block = 0; !octets.empty(); ++block) {
    const auto here = octets.first(std::min(octets.size(), sizeof(std::uint64_t)));
    word[block] = here.size() == sizeof(std::uint64_t) ? bits_of(here.first<sizeof(std::uint64_t)>()) : bits_of(here);
    octets = octets.subspan(here.size());
  }
  said_[size_++] = at;
}

}  // namespace geminga::membership
