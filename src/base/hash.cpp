#include "base/hash.hpp"

#include <xxhash.h>

#include "base/assert.hpp"

namespace geminga::base {

std::uint32_t hash32(std::string_view octets) { return XXH32(octets.data(), octets.size(), 0); }

std::uint64_t hash64(std::string_view octets) { return XXH3_64bits(octets.data(), octets.size()); }

std::uint64_t hash64(std::string_view octets, std::uint64_t seed) {
  return XXH3_64bits_withSeed(octets.data(), octets.size(), seed);
}

void HashOfPieces::Free::operator()(XXH3_state_s* state) const { XXH3_freeState(state); }

HashOfPieces::HashOfPieces() : state_(XXH3_createState()) {
  GEMINGA_ASSERT(state_ != nullptr);
  XXH3_64bits_reset(state_.get());
}

void HashOfPieces::add(std::string_view octets) { XXH3_64bits_update(state_.get(), octets.data(), octets.size()); }

std::uint64_t HashOfPieces::finish() const { return XXH3_64bits_digest(state_.get()); }

std::pair<std::uint64_t, std::uint64_t> hash128(std::string_view octets) {
  const XXH128_hash_t hash = XXH3_128bits(octets.data(), octets.size());
  return {hash.high64, hash.low64};
}

}  // namespace geminga::base
