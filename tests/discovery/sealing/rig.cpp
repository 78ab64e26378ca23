#include "discovery/sealing/rig.hpp"

#include <algorithm>

namespace geminga::sealing {

Key key_of(int number) {
  Key::Secret secret{};
  secret.fill(static_cast<unsigned char>(number));
  return Key(secret);
}

Policy policy(Mode mode, std::initializer_list<int> keys) {
  Policy policy{.mode = mode};
  for (const int number : keys) (void)policy.keys.add(key_of(number));
  return policy;
}

Octets octets_of(std::string_view text) {
  Octets octets(text.size());
  std::ranges::transform(text, octets.begin(), [](char c) { return static_cast<std::byte>(c); });
  return octets;
}

std::string text_of(std::span<const std::byte> octets) {
  std::string text(octets.size(), ' ');
  std::ranges::transform(octets, text.begin(), [](std::byte octet) { return static_cast<char>(octet); });
  return text;
}

Octets copy_of(std::span<const std::byte> octets) { return {octets.begin(), octets.end()}; }

std::string noise(std::size_t size) {
  base::Random random(size);
  std::string text(size, ' ');
  for (char& c : text) c = static_cast<char>(random.next());
  return text;
}

Octets bent(Octets octets, std::size_t at, std::uint8_t bits) {
  octets.at(at) ^= std::byte{bits};
  return octets;
}

Member::Member(int seed, const Policy& how, base::Instant start)
    : now(start), random(static_cast<std::uint64_t>(seed)), seal([this] { return random.next(); }) {
  seal.adopt(how, now);
}

Octets Member::say(std::string_view text, env::InterfaceIndex interface) {
  return copy_of(seal.seal(octets_of(text), interface, now));
}

Arrival Member::arrival(env::InterfaceIndex interface, std::string_view source) const {
  return {.interface = interface, .interface_name = interface == wlan ? "wlan0" : "eth0", .source = source, .now = now};
}

std::string Member::hear(std::span<const std::byte> datagram, env::InterfaceIndex interface, std::string_view source) {
  const auto opened = seal.open(datagram, arrival(interface, source));
  return opened ? text_of(opened->text) : std::string(to_string(opened.error()));
}

void introduce(Member& one, Member& other) {
  (void)other.hear(one.say("a"));
  (void)one.hear(other.say("b"));
  (void)other.hear(one.say("c"));
}

}  // namespace geminga::sealing
