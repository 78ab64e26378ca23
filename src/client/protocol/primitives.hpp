// The primitives of sealed channels, ChaCha20-Poly1305 and HMAC-SHA-256, by libsodium, which only primitives.cpp names.
#ifndef GEMINGA_CLIENT_PROTOCOL_PRIMITIVES_HPP
#define GEMINGA_CLIENT_PROTOCOL_PRIMITIVES_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace geminga::client {

inline constexpr std::size_t secret_bytes = 32;
inline constexpr std::size_t tag_bytes = 16;
inline constexpr std::size_t nonce_bytes = 12;

/// 32 secret octets, which are overwritten when it ends. Copies, since rings of keys are values.
class Secret {
 public:
  Secret() = default;
  explicit Secret(std::span<const std::byte, secret_bytes> octets);
  /// Octets by chance.
  [[nodiscard]] static Secret random();
  Secret(const Secret&) = default;
  Secret& operator=(const Secret&) = default;
  ~Secret();

  [[nodiscard]] std::span<const std::byte, secret_bytes> octets() const { return octets_; }
  friend bool operator==(const Secret&, const Secret&) = default;

 private:
  std::array<std::byte, secret_bytes> octets_{};
};

using Nonce = std::array<std::byte, nonce_bytes>;

/// Encrypts `text` to `to`, and writes the tag over `extra` and it behind that. `to` has room for the text and its tag.
/// `text` may be empty or lie where `to` begins.
void seal(const Secret& key, const Nonce& nonce, std::span<const std::byte> extra, std::span<const std::byte> text,
          std::byte* to);
/// Decrypts to `to`, which has room for `sealed` without its tag. False if the tag is wrong; `to` is void then.
/// Requires a tag in `sealed`.
[[nodiscard]] bool open(const Secret& key, const Nonce& nonce, std::span<const std::byte> extra,
                        std::span<const std::byte> sealed, std::byte* to);

/// The first eight octets of HMAC-SHA-256, as a number.
[[nodiscard]] std::uint64_t keyed_hash(const Secret& key, std::span<const std::byte> text);
/// 64 bits by chance that are not 0.
[[nodiscard]] std::uint64_t random_number();

}  // namespace geminga::client

#endif
