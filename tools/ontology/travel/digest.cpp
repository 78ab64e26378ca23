#include "ontology/travel/digest.hpp"

#include <sodium.h>

#include <algorithm>
#include <array>

#include "base/assert.hpp"

namespace geminga::ontology {
namespace {

constexpr std::size_t digest_octets = 32;

}  // namespace

std::string blake2b(std::string_view octets) {
  GEMINGA_ASSERT(sodium_init() >= 0);
  std::array<unsigned char, digest_octets> digest{};
  crypto_generichash(digest.data(), digest.size(), reinterpret_cast<const unsigned char*>(octets.data()), octets.size(),
                     nullptr, 0);
  std::string text(2 * digest_octets + 1, '\0');
  sodium_bin2hex(text.data(), text.size(), digest.data(), digest.size());
  text.pop_back();
  return text;
}

bool is_blake2b(std::string_view text) {
  return text.size() == 2 * digest_octets && std::ranges::all_of(text, [](char digit) {
           return (digit >= '0' && digit <= '9') || (digit >= 'a' && digit <= 'f');
         });
}

}  // namespace geminga::ontology
