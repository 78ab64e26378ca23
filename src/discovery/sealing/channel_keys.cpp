#include "discovery/sealing/channel_keys.hpp"

#include <sodium.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace geminga::sealing {
namespace {

constexpr std::string_view channel_context = "GemChan";
/// Octets of the derivation. A number never gets another meaning.
constexpr unsigned char version_of_channels = 2;
constexpr unsigned char kind_of_channels = 1;
constexpr unsigned char from_publisher = 1;
constexpr unsigned char to_publisher = 2;

Key::Secret derived(const Key& key, unsigned char direction, std::uint64_t life) {
  std::array<unsigned char, channel_context.size() + 3 + sizeof life> about{};
  auto next = std::ranges::copy(channel_context, about.begin()).out;
  *next++ = version_of_channels;
  *next++ = kind_of_channels;
  *next++ = direction;
  for (int shift = 56; shift >= 0; shift -= 8) *next++ = static_cast<unsigned char>(life >> shift);
  Key::Secret made{};
  crypto_generichash(made.data(), made.size(), about.data(), about.size(), key.channels().data(),
                     key.channels().size());
  return made;
}

}  // namespace

ChannelKeys::~ChannelKeys() {
  sodium_memzero(forward.data(), forward.size());
  sodium_memzero(back.data(), back.size());
}

ChannelKeys channel_keys(const Key& key, std::uint64_t life) {
  ChannelKeys keys;
  keys.id = key.id();
  keys.forward = derived(key, from_publisher, life);
  keys.back = derived(key, to_publisher, life);
  return keys;
}

}  // namespace geminga::sealing
