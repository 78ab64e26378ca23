// Any octets as a datagram, and any octets sealed with the key: neither does harm, and only the second is accepted.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "discovery/announcement/codec.hpp"
#include "discovery/sealing/seal.hpp"

namespace {

using namespace geminga;
using namespace geminga::sealing;

constexpr env::InterfaceIndex interface{1};
constexpr base::Instant now{std::chrono::hours(1)};
constexpr Arrival arrival{.interface = interface, .interface_name = "eth0", .source = "10.0.0.1", .now = now};

void require(bool condition) {
  if (!condition) std::abort();
}

/// The key of the worked examples.
Key example_key() {
  Key::Secret secret{};
  for (std::size_t i = 0; i < secret.size(); ++i) secret[i] = static_cast<unsigned char>(i);
  return Key(secret);
}

struct Member {
  explicit Member(std::uint64_t seed) : random(seed), seal([this] { return random.next(); }) {
    Policy policy{.mode = Mode::encrypted};
    (void)policy.keys.add(example_key());
    seal.adopt(policy, now);
  }

  std::vector<std::byte> say() {
    const auto datagram = seal.seal(std::array{std::byte{1}, std::byte{2}}, interface, now);
    require(datagram.size() <= env::max_datagram_bytes);
    return {datagram.begin(), datagram.end()};
  }
  bool hears(std::span<const std::byte> datagram) { return seal.open(datagram, arrival).has_value(); }

  base::Random random;
  Seal seal;
};

/// Whatever was received, both sides can still prove themselves to each other.
void check_team(Member& one, Member& other) {
  for (int i = 0; i < 3; ++i) {
    (void)one.hears(other.say());
    (void)other.hears(one.say());
  }
  require(one.hears(other.say()) && other.hears(one.say()));
}

/// Without the key no datagram is accepted. The datagrams of the seeds are sealed, and of a session without proof.
void check_datagram(std::span<const std::byte> datagram) {
  Member one(1);
  Member other(2);
  check_team(one, other);
  require(!one.hears(datagram));
  check_team(one, other);
}

/// Any octets as a compressed announcement: they are expanded within the bound or not at all.
void check_compression(std::span<const std::byte> octets) {
  static Compression compression;
  std::array<std::byte, max_text_bytes> text{};
  const auto size = compression.expand(octets, text);
  require(!size || *size <= text.size());
  std::array<std::byte, max_text_bytes> smaller{};
  const auto whole = octets.first(std::min(octets.size(), max_text_bytes));
  if (const std::size_t compressed = compression.compress(whole, smaller); compressed > 0) {
    require(compressed + min_saved_bytes <= whole.size());
    const auto again = compression.expand(std::span(smaller).first(compressed), text);
    require(again && std::ranges::equal(std::span(text).first(*again), whole));
  }
}

/// The content of sealed datagrams is read strictly. The first octet says whether it begins with a greeting.
void check_text(std::span<const std::byte> octets) {
  const bool has_greeting = !octets.empty() && (octets[0] & std::byte{1}) != std::byte{};
  auto text = octets.subspan(octets.empty() ? 0 : 1);
  text = text.first(std::min(text.size(), max_text_bytes));
  std::array<std::byte, env::max_datagram_bytes> datagram{};
  const Key key = example_key();
  const Header header{.has_greeting = has_greeting, .key = key.id(), .session = Session(7), .counter = 9};
  const std::size_t size = seal(key, header, text, datagram);
  Member one(1);
  Member other(2);
  const auto opened = one.seal.open(std::span(datagram).first(size), arrival);
  // Its challenge is random, so that nothing in the text proves anything.
  require(!opened && (opened.error() == Rejection::unproved || opened.error() == Rejection::malformed));
  require(has_greeting || opened.error() == Rejection::unproved);
  if (opened.error() == Rejection::unproved) require(one.seal.asks(now));
  check_team(one, other);
  if (const auto read = read_greeting(text)) {
    std::array<std::byte, max_greeting_bytes> again{};
    require(read->size <= text.size() && write_greeting(read->greeting, again) == read->size);
    require(std::ranges::equal(std::span(again).first(read->size), text.first(read->size)));
    (void)announcement::decode(text.subspan(read->size));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(octets, size));
  check_datagram(bytes);
  check_text(bytes);
  check_compression(bytes);
  return 0;
}
