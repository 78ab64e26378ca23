#include "discovery/sealing/key.hpp"

#include <sodium.h>

#include <algorithm>

#include "base/assert.hpp"
#include "base/text.hpp"

namespace geminga::sealing {
namespace {

/// The values that are derived from a secret (libsodium's crypto_kdf: BLAKE2b). A number never gets another meaning.
constexpr std::uint64_t subkey_of_sealing = 1;
constexpr std::uint64_t subkey_of_id = 2;
constexpr std::uint64_t subkey_of_channels = 3;
constexpr const char* context = "GemSeal1";
static_assert(crypto_kdf_KEYBYTES == key_bytes);

/// Chooses the code for this processor; safe at any time and as often as wanted.
void begin_sodium() { GEMINGA_ASSERT(sodium_init() >= 0); }

}  // namespace

std::string to_string(KeyId id) { return base::to_hex(static_cast<std::uint16_t>(id), 4); }

Key::Key(const Secret& secret) {
  begin_sodium();
  std::array<unsigned char, crypto_kdf_BYTES_MIN> id{};
  crypto_kdf_derive_from_key(sealing_.data(), sealing_.size(), subkey_of_sealing, context, secret.data());
  crypto_kdf_derive_from_key(channels_.data(), channels_.size(), subkey_of_channels, context, secret.data());
  crypto_kdf_derive_from_key(id.data(), id.size(), subkey_of_id, context, secret.data());
  id_ = KeyId(id[0] << 8 | id[1]);
}

Key::~Key() {
  sodium_memzero(sealing_.data(), sealing_.size());
  sodium_memzero(channels_.data(), channels_.size());
}

bool operator==(const Key& one, const Key& other) {
  return sodium_memcmp(one.sealing_.data(), other.sealing_.data(), one.sealing_.size()) == 0;
}

Keyring::Added Keyring::add(const Key& key) {
  if (find(key.id()) != nullptr) return Added::id_taken;
  if (keys_.size() == max_keys) return Added::full;
  keys_.push_back(key);
  return Added::yes;
}

const Key* Keyring::find(KeyId id) const {
  const auto found = std::ranges::find(keys_, id, &Key::id);
  return found == keys_.end() ? nullptr : &*found;
}

bool Keyring::is_within(const Keyring& other) const {
  return std::ranges::all_of(keys_, [&](const Key& key) {
    const Key* same = other.find(key.id());
    return same != nullptr && *same == key;
  });
}

}  // namespace geminga::sealing
