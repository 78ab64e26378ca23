// Frames of the forms 2 and 3, sealed with the keys of a publisher's life (src/client/CHANNELS.md, Sealed channels).
#ifndef GEMINGA_CLIENT_PROTOCOL_SEALED_FRAME_HPP
#define GEMINGA_CLIENT_PROTOCOL_SEALED_FRAME_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "client/protocol/channel_keys.hpp"
#include "client/protocol/frame.hpp"

namespace geminga::client {

enum class Direction : std::uint8_t {
  forward,  ///< from the publisher
  back,     ///< from a consumer
};

/// The fields of a sealed header that the plain one has not.
struct SealFields {
  KeyId key = 0;
  std::uint16_t hello_port = 0;
  std::uint64_t counter = 0;
};
/// Requires a frame that is not plain.
[[nodiscard]] SealFields seal_fields(const ReadFrame& frame);

/// The octets of a frame with a payload of this size, sealed.
[[nodiscard]] constexpr std::size_t sealed_size(std::size_t payload_bytes) {
  return max_frame_overhead + payload_bytes;
}

/// Seals the frames of one life and counts them, so that no nonce is used twice. The counter goes on while keys change,
/// and with the keys of all publishers that a subscriber says hello to. Neither copies nor moves.
class Sealer {
 public:
  Sealer(Life own, Direction direction) : own_(own), direction_(direction) {}
  Sealer(const Sealer&) = delete;
  Sealer& operator=(const Sealer&) = delete;

  [[nodiscard]] Life life() const { return own_; }
  /// Writes a frame of the own life with the first key of the ring to `to`, which has sealed_size() octets. False if
  /// the counter is used up. Requires keys that send sealed.
  [[nodiscard]] bool seal(const ChannelKeys& keys, FrameKind kind, std::uint64_t sequence,
                          std::span<const std::byte> payload, std::uint16_t hello_port, std::byte* to);
  /// The octets of a frame of the own life in the form in which this host sends. Nothing if the counter is used up.
  [[nodiscard]] std::optional<std::vector<std::byte>> frame(const ChannelKeys& keys, FrameKind kind,
                                                            std::uint64_t sequence,
                                                            std::span<const std::byte> payload = {},
                                                            std::uint16_t hello_port = 0);
  /// Begins behind this counter, for tests.
  void count_from(std::uint64_t counter) { counter_ = counter; }

 private:
  Life own_;
  Direction direction_;
  std::uint64_t counter_ = 0;
};

/// The payload of a sealed frame, opened with the keys that have its id. Nothing if none of them fits, or it is plain.
/// Borrowed from the frame or from `room`, which grows as needed.
[[nodiscard]] std::optional<Frame> open_frame(const ReadFrame& frame, const ChannelKeys& keys, Direction direction,
                                              std::vector<std::byte>& room);

}  // namespace geminga::client

#endif
