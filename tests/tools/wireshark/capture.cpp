#include "tools/wireshark/capture.hpp"

#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <fstream>

#include "discovery/sealing/compression.hpp"
#include "discovery/sealing/envelope.hpp"
#include "discovery/sealing/greeting.hpp"
#include "discovery/sealing/key_file.hpp"
#include "env/env.hpp"

namespace geminga::tools {
namespace {

namespace fs = std::filesystem;

void append(std::string& out, std::uint64_t number, std::size_t octets, bool is_big_endian) {
  for (std::size_t i = 0; i < octets; ++i) {
    out += static_cast<char>(number >> (8 * (is_big_endian ? octets - 1 - i : i)));
  }
}

sealing::Key::Secret secret_of(unsigned char first) {
  sealing::Key::Secret secret;
  for (auto& octet : secret) octet = first++;
  return secret;
}

}  // namespace

void write_capture(const fs::path& file, const std::vector<Datagram>& datagrams) {
  std::string out;
  for (const std::uint64_t number : {0xa1b2c3d4U, 0x00040002U, 0U, 0U, 262'144U, 101U}) append(out, number, 4, false);
  std::uint64_t second = 0;
  for (const Datagram& datagram : datagrams) {
    std::string packet;
    const std::size_t udp = 8 + datagram.size();
    append(packet, 0x4500, 2, true);
    append(packet, 20 + udp, 2, true);
    append(packet, 0, 4, true);
    append(packet, 0x01110000, 4, true);  // one hop, UDP
    append(packet, 0x0a000002, 4, true);
    append(packet, 0xefc02f11, 4, true);
    append(packet, 4717, 2, true);
    append(packet, 4717, 2, true);
    append(packet, udp, 2, true);
    append(packet, 0, 2, true);
    for (const std::byte octet : datagram) packet += static_cast<char>(octet);
    append(out, ++second, 4, false);
    append(out, 0, 4, false);
    append(out, packet.size(), 4, false);
    append(out, packet.size(), 4, false);
    out += packet;
  }
  std::ofstream(file, std::ios::binary) << out;
}

std::string hexadecimal(std::span<const std::byte> octets) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string word;
  for (const std::byte octet : octets) {
    word += digits[std::to_integer<unsigned>(octet) >> 4U];
    word += digits[std::to_integer<unsigned>(octet) & 15U];
  }
  return word;
}

WithKeys::WithKeys() {
  std::string path = fs::temp_directory_path() / "geminga-wireshark-XXXXXX";
  if (::mkdtemp(path.data()) != nullptr) folder_ = path;
  key_file_ = folder_ / "team's.key";
  other_file_ = folder_ / "other.key";
  keys_ = {sealing::Key(secret_of(0)), sealing::Key(secret_of(100))};
  std::ofstream(key_file_) << sealing::write_key(secret_of(0));
  std::ofstream(other_file_) << sealing::write_key(secret_of(100));
}

WithKeys::~WithKeys() { fs::remove_all(folder_); }

Datagram sealed(const sealing::Key& key, std::span<const std::byte> announcement, std::string_view mode,
                std::uint32_t counter) {
  sealing::Header header{
      .protection = mode.contains("open") ? sealing::Protection::authenticated : sealing::Protection::encrypted,
      .has_greeting = mode.contains("greeting"),
      .is_compressed = false,
      .key = key.id(),
      .session = sealing::Session{0x1122334455667788},
      .counter = counter};
  Datagram text(announcement.begin(), announcement.end());
  if (mode.contains("small")) {
    sealing::Compression compression;
    Datagram smaller(announcement.size() + 64);
    const std::size_t size = compression.compress(announcement, smaller);
    header.is_compressed = size > 0;
    if (size > 0) text.assign(smaller.begin(), smaller.begin() + static_cast<std::ptrdiff_t>(size));
  }
  if (header.has_greeting) {
    const sealing::Greeting greeting{.keys = {key.id()},
                                     .calls_everybody = true,
                                     .challenge = sealing::Challenge{7},
                                     .asked = {sealing::SessionTag{8}},
                                     .echoes = {sealing::Challenge{9}, sealing::Challenge{10}}};
    std::array<std::byte, sealing::max_greeting_bytes> octets{};
    const std::size_t size = sealing::write_greeting(greeting, octets);
    text.insert(text.begin(), octets.begin(), octets.begin() + static_cast<std::ptrdiff_t>(size));
  }
  Datagram datagram(text.size() + env::max_envelope_bytes);
  datagram.resize(sealing::seal(key, header, text, datagram));
  return datagram;
}

}  // namespace geminga::tools
