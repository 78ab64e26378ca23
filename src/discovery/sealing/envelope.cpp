#include "discovery/sealing/envelope.hpp"

#include <sodium.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "base/assert.hpp"
#include "discovery/sealing/version.hpp"

namespace geminga::sealing {
namespace {

constexpr std::byte magic{0x47};  // G; as the beginning of a protobuf message it is no valid one
constexpr std::uint8_t version = envelope_version << 4;
constexpr std::uint8_t encrypted_bit = 0x01;
constexpr std::uint8_t greeting_bit = 0x02;
constexpr std::uint8_t compressed_bit = 0x04;

static_assert(crypto_aead_xchacha20poly1305_ietf_KEYBYTES == key_bytes);
static_assert(crypto_aead_xchacha20poly1305_ietf_ABYTES == tag_bytes);
static_assert(crypto_aead_xchacha20poly1305_ietf_NPUBBYTES >= header_bytes);

using Nonce = std::array<unsigned char, crypto_aead_xchacha20poly1305_ietf_NPUBBYTES>;

void write_number(std::span<std::byte> octets, std::uint64_t number) {
  for (std::size_t i = octets.size(); i-- > 0; number >>= 8) octets[i] = static_cast<std::byte>(number & 0xff);
}

std::uint64_t read_number(std::span<const std::byte> octets) {
  std::uint64_t number = 0;
  for (const std::byte octet : octets) number = number << 8 | static_cast<std::uint8_t>(octet);
  return number;
}

void write_header(const Header& header, std::span<std::byte> octets) {
  const std::uint8_t mode = version | (header.protection == Protection::encrypted ? encrypted_bit : 0) |
                            (header.has_greeting ? greeting_bit : 0) | (header.is_compressed ? compressed_bit : 0);
  octets[0] = magic;
  octets[1] = std::byte{mode};
  write_number(octets.subspan(2, 2), static_cast<std::uint16_t>(header.key));
  write_number(octets.subspan(4, 8), static_cast<std::uint64_t>(header.session));
  write_number(octets.subspan(12, 4), header.counter);
}

/// The header and eight zeros: each of its octets is authenticated as part of the nonce.
Nonce nonce_of(std::span<const std::byte> datagram) {
  Nonce nonce{};
  std::memcpy(nonce.data(), datagram.data(), header_bytes);
  return nonce;
}

unsigned char* sodium(std::byte* octets) { return reinterpret_cast<unsigned char*>(octets); }
const unsigned char* sodium(const std::byte* octets) { return reinterpret_cast<const unsigned char*>(octets); }

}  // namespace

std::string_view to_string(Protection protection) {
  switch (protection) {
    case Protection::plain:
      return "plain";
    case Protection::authenticated:
      return "authenticated";
    case Protection::encrypted:
      return "encrypted";
  }
  return "plain";
}

bool is_sealed(std::span<const std::byte> datagram) { return !datagram.empty() && datagram[0] == magic; }

std::expected<Header, Rejection> read_header(std::span<const std::byte> datagram) {
  if (datagram.size() < env::max_envelope_bytes) return std::unexpected(Rejection::too_short);
  const auto mode = static_cast<std::uint8_t>(datagram[1]);
  if ((mode & ~(encrypted_bit | greeting_bit | compressed_bit)) != version)
    return std::unexpected(Rejection::other_version);
  return Header{.protection = (mode & encrypted_bit) != 0 ? Protection::encrypted : Protection::authenticated,
                .has_greeting = (mode & greeting_bit) != 0,
                .is_compressed = (mode & compressed_bit) != 0,
                .key = KeyId(read_number(datagram.subspan(2, 2))),
                .session = Session(read_number(datagram.subspan(4, 8))),
                .counter = static_cast<std::uint32_t>(read_number(datagram.subspan(12, 4)))};
}

std::size_t seal(const Key& key, const Header& header, std::span<const std::byte> text, std::span<std::byte> datagram) {
  GEMINGA_ASSERT(header.protection != Protection::plain);
  GEMINGA_ASSERT(datagram.size() >= text.size() + env::max_envelope_bytes);
  write_header(header, datagram);
  const Nonce nonce = nonce_of(datagram);
  const auto body = datagram.subspan(header_bytes, text.size());
  const auto tag = datagram.subspan(header_bytes + text.size(), tag_bytes);
  // Only authenticated: the text is the additional data of an empty message.
  const bool is_encrypted = header.protection == Protection::encrypted;
  if (!is_encrypted) std::copy_n(text.data(), text.size(), body.data());
  crypto_aead_xchacha20poly1305_ietf_encrypt_detached(
      sodium(body.data()), sodium(tag.data()), nullptr, sodium(text.data()), is_encrypted ? text.size() : 0,
      sodium(text.data()), is_encrypted ? 0 : text.size(), nullptr, nonce.data(), key.sealing().data());
  return text.size() + env::max_envelope_bytes;
}

std::expected<std::size_t, Rejection> open(const Key& key, const Header& header, std::span<const std::byte> datagram,
                                           std::span<std::byte> text) {
  const std::size_t size = datagram.size() - env::max_envelope_bytes;
  GEMINGA_ASSERT(text.size() >= size);
  const Nonce nonce = nonce_of(datagram);
  const auto body = datagram.subspan(header_bytes, size);
  const auto tag = datagram.subspan(header_bytes + size, tag_bytes);
  const bool is_encrypted = header.protection == Protection::encrypted;
  const int opened = crypto_aead_xchacha20poly1305_ietf_decrypt_detached(
      sodium(text.data()), nullptr, sodium(body.data()), is_encrypted ? size : 0, sodium(tag.data()),
      sodium(body.data()), is_encrypted ? 0 : size, nonce.data(), key.sealing().data());
  if (opened != 0) return std::unexpected(Rejection::forged);
  if (!is_encrypted) std::copy_n(body.data(), body.size(), text.data());
  return size;
}

}  // namespace geminga::sealing
