#include "client/protocol/sealed_frame.hpp"

#include <cstring>
#include <limits>

namespace geminga::client {
namespace {

constexpr std::size_t key_at = 24;
constexpr std::size_t hello_port_at = 26;
constexpr std::size_t counter_at = 28;

std::uint64_t largest_counter(Direction direction) {
  return direction == Direction::forward ? std::numeric_limits<std::uint64_t>::max()
                                         : std::numeric_limits<std::uint32_t>::max();
}

/// Forward: four octets 0, then the counter. Back: the consumer's life, then the lower half of the counter.
Nonce nonce_of(Direction direction, Life life, std::uint64_t counter) {
  Nonce nonce{};
  if (direction == Direction::forward) {
    write_number(nonce.data() + 4, counter);
  } else {
    write_number(nonce.data(), static_cast<std::uint64_t>(life));
    write_number(nonce.data() + 8, static_cast<std::uint32_t>(counter));
  }
  return nonce;
}

}  // namespace

SealFields seal_fields(const ReadFrame& frame) {
  const std::byte* const header = frame.octets.data();
  return {read_number<KeyId>(header + key_at), read_number<std::uint16_t>(header + hello_port_at),
          read_number<std::uint64_t>(header + counter_at)};
}

bool Sealer::seal(const ChannelKeys& keys, FrameKind kind, std::uint64_t sequence, std::span<const std::byte> payload,
                  std::uint16_t hello_port, std::byte* to) {
  if (counter_ == largest_counter(direction_)) return false;
  ++counter_;
  const ChannelKeys::Key& key = keys.ring().front();
  const auto plain = frame_header(kind, own_, sequence, payload.size() + tag_bytes);
  std::memcpy(to, plain.data(), plain.size());
  to[2] = static_cast<std::byte>(keys.form());
  write_number(to + key_at, key.id);
  write_number(to + hello_port_at, hello_port);
  write_number(to + counter_at, counter_);
  const Secret& secret = direction_ == Direction::forward ? key.forward : key.back;
  const Nonce nonce = nonce_of(direction_, own_, counter_);
  std::byte* const text = to + sealed_header_bytes;
  if (keys.form() == FrameForm::encrypted) {
    client::seal(secret, nonce, {to, sealed_header_bytes}, payload, text);
  } else {
    if (!payload.empty()) std::memcpy(text, payload.data(), payload.size());
    client::seal(secret, nonce, {to, sealed_header_bytes + payload.size()}, {}, text + payload.size());
  }
  return true;
}

std::optional<std::vector<std::byte>> Sealer::frame(const ChannelKeys& keys, FrameKind kind, std::uint64_t sequence,
                                                    std::span<const std::byte> payload, std::uint16_t hello_port) {
  if (!keys.sends_sealed()) return frame_bytes({kind, own_, sequence, payload});
  std::vector<std::byte> octets(sealed_size(payload.size()));
  if (!seal(keys, kind, sequence, payload, hello_port, octets.data())) return std::nullopt;
  return octets;
}

std::optional<Frame> open_frame(const ReadFrame& frame, const ChannelKeys& keys, Direction direction,
                                std::vector<std::byte>& room) {
  if (frame.form == FrameForm::plain) return std::nullopt;
  const SealFields fields = seal_fields(frame);
  if (fields.counter == 0 || fields.counter > largest_counter(direction)) return std::nullopt;
  const Nonce nonce = nonce_of(direction, frame.life, fields.counter);
  const std::size_t size = frame.payload.size() - tag_bytes;
  for (const ChannelKeys::Key& key : keys.ring()) {
    if (key.id != fields.key) continue;
    const Secret& secret = direction == Direction::forward ? key.forward : key.back;
    Frame opened = frame;
    if (frame.form == FrameForm::authenticated) {
      opened.payload = frame.payload.first(size);
      if (open(secret, nonce, frame.octets.first(sealed_header_bytes + size), frame.payload.subspan(size), room.data()))
        return opened;
    } else {
      if (room.size() < size) room.resize(size);
      opened.payload = std::span(room).first(size);
      if (open(secret, nonce, frame.octets.first(sealed_header_bytes), frame.payload, room.data())) return opened;
    }
  }
  return std::nullopt;
}

}  // namespace geminga::client
