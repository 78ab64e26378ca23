#include "sim/word_watch.hpp"

#include <array>
#include <string>

#include "base/hash.hpp"
#include "discovery/announcement/codec.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/sealing/greeting.hpp"
#include "sim/host.hpp"

namespace geminga::sim {

WordWatch::WordWatch(World& world, sealing::Key key) : world_(world), key_(std::move(key)) {
  world_.on_transmit = [this](const Host& sender, std::string_view datagram) { see(sender, datagram); };
}

void WordWatch::see(const Host& sender, std::string_view datagram) {
  const auto octets = std::as_bytes(std::span(datagram));
  if (!sealing::is_sealed(octets)) return;
  const auto header = sealing::read_header(octets);
  // A relayed word is sealed itself, so that no relay's datagram can be compressed.
  if (!header || header->is_compressed || header->key != key_.id()) return;
  std::array<std::byte, env::max_datagram_bytes> room{};
  const auto size = sealing::open(key_, *header, octets, room);
  if (!size) return;
  std::span<const std::byte> text = std::span(room).first(*size);
  if (header->has_greeting) {
    const auto greeting = sealing::read_greeting(text);
    if (!greeting) return;
    text = text.subspan(greeting->size);
  }
  const auto relayed = announcement::decode(text);
  if (!relayed || relayed->kind != announcement::Kind::relayed) return;
  ++words_;
  const std::uint64_t word = base::hash64(base::octets_of(std::span<const std::byte>(relayed->relayed.word)), 0);
  const std::size_t most = 2 * (sender.ports().size() - 1);
  if (++said_[{sender.number(), word}] > most)
    world_.complain("words: " + sender.name() + " says one more than " + std::to_string(most) + " times,");
}

}  // namespace geminga::sim
