#include "client/protocol/frame.hpp"

#include <algorithm>

namespace geminga::client {
namespace {

constexpr std::byte first_octet{'G'};
constexpr std::byte second_octet{'C'};
constexpr std::byte frame_version{1};

template <typename Number>
void write(std::byte* to, Number number) {
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    to[i] = static_cast<std::byte>(number >> (8 * (sizeof(Number) - 1 - i)));
  }
}

template <typename Number>
Number read(const std::byte* from) {
  Number number = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    number = static_cast<Number>((std::uint64_t{number} << 8) | std::to_integer<std::uint64_t>(from[i]));
  }
  return number;
}

}  // namespace

std::optional<std::size_t> payload_bytes(const std::byte* header, std::size_t max_payload) {
  const auto kind = std::to_integer<unsigned>(header[3]);
  const bool is_header = header[0] == first_octet && header[1] == second_octet && header[2] == frame_version &&
                         kind >= 1 && kind <= 3 && read<std::uint64_t>(header + 8) != 0;
  const std::size_t bytes = read<std::uint32_t>(header + 4);
  return is_header && bytes <= max_payload ? std::optional(bytes) : std::nullopt;
}

Frame frame_at(const std::byte* header) {
  return {static_cast<FrameKind>(header[3]),
          Life{read<std::uint64_t>(header + 8)},
          read<std::uint64_t>(header + 16),
          {header + frame_header_bytes, read<std::uint32_t>(header + 4)}};
}

FrameHeader frame_header(FrameKind kind, Life life, std::uint64_t sequence, std::size_t payload_bytes) {
  FrameHeader header{first_octet, second_octet, frame_version, static_cast<std::byte>(kind)};
  write(header.data() + 4, static_cast<std::uint32_t>(payload_bytes));
  write(header.data() + 8, static_cast<std::uint64_t>(life));
  write(header.data() + 16, sequence);
  return header;
}

std::vector<std::byte> frame_bytes(const Frame& frame) {
  const auto header = frame_header(frame.kind, frame.life, frame.sequence, frame.payload.size());
  std::vector<std::byte> bytes(header.size() + frame.payload.size());
  std::ranges::copy(frame.payload, std::ranges::copy(header, bytes.begin()).out);
  return bytes;
}

std::optional<Frame> read_frame(std::span<const std::byte> datagram) {
  if (datagram.size() < frame_header_bytes) return std::nullopt;
  const auto payload = payload_bytes(datagram.data(), max_datagram_payload);
  if (payload != datagram.size() - frame_header_bytes) return std::nullopt;
  return frame_at(datagram.data());
}

std::array<std::byte, 8> life_payload(Life life) {
  std::array<std::byte, 8> payload{};
  write(payload.data(), static_cast<std::uint64_t>(life));
  return payload;
}

std::optional<Life> payload_life(std::span<const std::byte> payload) {
  if (payload.size() != sizeof(std::uint64_t)) return std::nullopt;
  return Life{read<std::uint64_t>(payload.data())};
}

}  // namespace geminga::client
