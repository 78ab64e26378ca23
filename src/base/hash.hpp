// The hashes of xxHash 0.8, which are the same in every language and on every host.
#ifndef GEMINGA_BASE_HASH_HPP
#define GEMINGA_BASE_HASH_HPP

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

struct XXH3_state_s;  // of <xxhash.h>

namespace geminga::base {

/// XXH32 without seed.
[[nodiscard]] std::uint32_t hash32(std::string_view octets);

/// XXH3 in 64 bits. Without a seed the seed is 0.
[[nodiscard]] std::uint64_t hash64(std::string_view octets);
[[nodiscard]] std::uint64_t hash64(std::string_view octets, std::uint64_t seed);

/// The hash64() of octets that come in pieces.
class HashOfPieces {
 public:
  HashOfPieces();
  void add(std::string_view octets);
  [[nodiscard]] std::uint64_t finish() const;

 private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };
  std::unique_ptr<XXH3_state_s, Free> state_;
};

/// XXH3 in 128 bits, the upper half first.
[[nodiscard]] std::pair<std::uint64_t, std::uint64_t> hash128(std::string_view octets);

/// The octets of numbers as this host keeps them in memory.
template <typename Number, std::size_t extent>
[[nodiscard]] std::string_view octets_of(std::span<Number, extent> numbers) {
  static_assert(std::has_unique_object_representations_v<Number>);
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()};
}

}  // namespace geminga::base

#endif
