#include "client/protocol/frame.hpp"

#include <algorithm>

namespace geminga::client {
namespace {

constexpr std::byte first_octet{'G'};
constexpr std::byte second_octet{'C'};

}  // namespace

std::optional<std::size_t> frame_size(const std::byte* header, std::size_t max_payload) {
  const auto form = std::to_integer<unsigned>(header[2]);
  const auto kind = std::to_integer<unsigned>(header[3]);
  const bool is_header = header[0] == first_octet && header[1] == second_octet && form >= 1 && form <= 3 && kind >= 1 &&
                         kind <= 5 && read_number<std::uint64_t>(header + 8) != 0;
  if (!is_header) return std::nullopt;
  const bool is_plain = FrameForm{static_cast<std::uint8_t>(form)} == FrameForm::plain;
  const std::size_t tag = is_plain ? 0 : tag_bytes;
  const std::size_t bytes = read_number<std::uint32_t>(header + 4);
  if (bytes < tag || bytes > max_payload + tag) return std::nullopt;
  return (is_plain ? frame_header_bytes : sealed_header_bytes) + bytes;
}

ReadFrame frame_of(std::span<const std::byte> octets) {
  ReadFrame frame;
  frame.form = static_cast<FrameForm>(octets[2]);
  frame.kind = static_cast<FrameKind>(octets[3]);
  frame.life = Life{read_number<std::uint64_t>(octets.data() + 8)};
  frame.sequence = read_number<std::uint64_t>(octets.data() + 16);
  frame.payload = octets.subspan(frame.form == FrameForm::plain ? frame_header_bytes : sealed_header_bytes);
  frame.octets = octets;
  return frame;
}

FrameHeader frame_header(FrameKind kind, Life life, std::uint64_t sequence, std::size_t payload_bytes) {
  FrameHeader header{first_octet, second_octet, static_cast<std::byte>(FrameForm::plain), static_cast<std::byte>(kind)};
  write_number(header.data() + 4, static_cast<std::uint32_t>(payload_bytes));
  write_number(header.data() + 8, static_cast<std::uint64_t>(life));
  write_number(header.data() + 16, sequence);
  return header;
}

std::vector<std::byte> frame_bytes(const Frame& frame) {
  const auto header = frame_header(frame.kind, frame.life, frame.sequence, frame.payload.size());
  std::vector<std::byte> bytes(header.size() + frame.payload.size());
  std::ranges::copy(frame.payload, std::ranges::copy(header, bytes.begin()).out);
  return bytes;
}

std::optional<ReadFrame> read_frame(std::span<const std::byte> datagram) {
  if (datagram.size() < frame_header_bytes) return std::nullopt;
  if (frame_size(datagram.data(), max_datagram_payload) != datagram.size()) return std::nullopt;
  return frame_of(datagram);
}

std::array<std::byte, greeting_bytes> greeting_payload(const Greeting& greeting) {
  std::array<std::byte, greeting_bytes> payload{};
  write_number(payload.data(), static_cast<std::uint64_t>(greeting.life));
  write_number(payload.data() + 8, greeting.challenge);
  write_number(payload.data() + 16, greeting.cookie);
  return payload;
}

std::optional<Greeting> read_greeting(std::span<const std::byte> payload) {
  if (payload.size() != greeting_bytes) return std::nullopt;
  return Greeting{Life{read_number<std::uint64_t>(payload.data())}, read_number<std::uint64_t>(payload.data() + 8),
                  read_number<std::uint64_t>(payload.data() + 16)};
}

}  // namespace geminga::client
