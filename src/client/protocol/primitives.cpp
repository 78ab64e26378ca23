#include "client/protocol/primitives.hpp"

#include <sodium.h>

#include <algorithm>

#include "base/assert.hpp"

namespace geminga::client {
namespace {

static_assert(crypto_aead_chacha20poly1305_ietf_KEYBYTES == secret_bytes);
static_assert(crypto_aead_chacha20poly1305_ietf_ABYTES == tag_bytes);
static_assert(crypto_aead_chacha20poly1305_ietf_NPUBBYTES == nonce_bytes);

/// Chooses the fastest code for this processor, once a process.
void begin_sodium() { GEMINGA_ASSERT(sodium_init() >= 0); }

const unsigned char* raw(std::span<const std::byte> octets) {
  return reinterpret_cast<const unsigned char*>(octets.data());
}

}  // namespace

Secret::Secret(std::span<const std::byte, secret_bytes> octets) {
  begin_sodium();
  std::ranges::copy(octets, octets_.begin());
}

Secret Secret::random() {
  begin_sodium();
  Secret made;
  randombytes_buf(made.octets_.data(), made.octets_.size());
  return made;
}

Secret::~Secret() { sodium_memzero(octets_.data(), octets_.size()); }

void seal(const Secret& key, const Nonce& nonce, std::span<const std::byte> extra, std::span<const std::byte> text,
          std::byte* to) {
  crypto_aead_chacha20poly1305_ietf_encrypt_detached(
      reinterpret_cast<unsigned char*>(to), reinterpret_cast<unsigned char*>(to + text.size()), nullptr, raw(text),
      text.size(), raw(extra), extra.size(), nullptr, raw(nonce), raw(key.octets()));
}

bool open(const Secret& key, const Nonce& nonce, std::span<const std::byte> extra, std::span<const std::byte> sealed,
          std::byte* to) {
  const std::size_t size = sealed.size() - tag_bytes;
  return crypto_aead_chacha20poly1305_ietf_decrypt_detached(reinterpret_cast<unsigned char*>(to), nullptr, raw(sealed),
                                                            size, raw(sealed.subspan(size)), raw(extra), extra.size(),
                                                            raw(nonce), raw(key.octets())) == 0;
}

std::uint64_t keyed_hash(const Secret& key, std::span<const std::byte> text) {
  std::array<unsigned char, crypto_auth_hmacsha256_BYTES> hash{};
  crypto_auth_hmacsha256(hash.data(), raw(text), text.size(), raw(key.octets()));
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < sizeof number; ++i) number = (number << 8) | hash[i];
  return number;
}

std::uint64_t random_number() {
  begin_sodium();
  std::uint64_t number = 0;
  while (number == 0) randombytes_buf(&number, sizeof number);
  return number;
}

}  // namespace geminga::client
