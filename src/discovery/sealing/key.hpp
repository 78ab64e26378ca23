// One team key: what is derived from it, and the number by which it is known on the air.
#ifndef GEMINGA_DISCOVERY_SEALING_KEY_HPP
#define GEMINGA_DISCOVERY_SEALING_KEY_HPP

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "discovery/sealing/limits.hpp"

namespace geminga::sealing {

/// The number of the key that a datagram was sealed with. It is derived from the key and says nothing about it.
enum class KeyId : std::uint16_t {};
/// Four hexadecimal digits: "3fa9".
[[nodiscard]] std::string to_string(KeyId id);

/// A value that wipes itself when it ends.
class Key {
 public:
  using Secret = std::array<unsigned char, key_bytes>;

  /// Derives the values for the air from the secret of a key file, and keeps only those.
  explicit Key(const Secret& secret);
  Key(const Key&) = default;
  Key& operator=(const Key&) = default;
  ~Key();

  [[nodiscard]] KeyId id() const { return id_; }
  /// For the envelope only.
  [[nodiscard]] const Secret& sealing() const { return sealing_; }
  /// For channel_keys() only.
  [[nodiscard]] const Secret& channels() const { return channels_; }
  friend bool operator==(const Key& one, const Key& other);

 private:
  Secret sealing_{};
  Secret channels_{};
  KeyId id_{};
};

/// The keys of one participant in the order in which they were given: the first one seals, all of them open.
class Keyring {
 public:
  enum class Added : std::uint8_t {
    yes,
    full,     ///< there are max_keys
    id_taken  ///< another key, or the same one, has this number
  };
  Added add(const Key& key);
  [[nodiscard]] bool is_empty() const { return keys_.empty(); }
  /// The key that seals. Requires that there is one.
  [[nodiscard]] const Key& first() const { return keys_.front(); }
  /// The key of this number, or null.
  [[nodiscard]] const Key* find(KeyId id) const;
  [[nodiscard]] std::span<const Key> keys() const { return keys_; }
  /// Whether each of these keys is in `other`, too.
  [[nodiscard]] bool is_within(const Keyring& other) const;
  friend bool operator==(const Keyring&, const Keyring&) = default;

 private:
  std::vector<Key> keys_;
};

}  // namespace geminga::sealing

#endif
