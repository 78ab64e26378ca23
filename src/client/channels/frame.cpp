#include "client/channels/frame.hpp"

#include <algorithm>

namespace geminga::client {
namespace {

constexpr std::byte first_octet{'G'};
constexpr std::byte second_octet{'C'};
constexpr std::byte frame_version{1};
/// Read at once from a stream where no longer frame is under way.
constexpr std::size_t read_bytes = 64 * 1024;

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

bool is_header(const std::byte* at) {
  const auto kind = std::to_integer<unsigned>(at[3]);
  const bool has_life = read<std::uint64_t>(at + 8) != 0;
  return at[0] == first_octet && at[1] == second_octet && at[2] == frame_version && kind >= 1 && kind <= 3 && has_life;
}

std::size_t payload_bytes(const std::byte* header) { return read<std::uint32_t>(header + 4); }

Frame frame_at(const std::byte* at) {
  return {static_cast<FrameKind>(at[3]),
          Life{read<std::uint64_t>(at + 8)},
          read<std::uint64_t>(at + 16),
          {at + frame_header_bytes, payload_bytes(at)}};
}

}  // namespace

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
  if (datagram.size() < frame_header_bytes || !is_header(datagram.data())) return std::nullopt;
  const std::size_t payload = payload_bytes(datagram.data());
  if (payload > max_datagram_payload || datagram.size() - frame_header_bytes != payload) return std::nullopt;
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

std::span<std::byte> FrameReader::room() {
  if (begin_ > 0) {
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
    end_ -= begin_;
    begin_ = 0;
  }
  buffer_.resize(std::max(wanted_, end_ + std::min(read_bytes, frame_header_bytes + max_payload_)));
  return std::span(buffer_).subspan(end_);
}

std::optional<Frame> FrameReader::next() {
  const std::size_t there = end_ - begin_;
  if (is_broken_ || there < frame_header_bytes) return std::nullopt;
  const std::byte* at = buffer_.data() + begin_;
  if (!is_header(at) || payload_bytes(at) > max_payload_) {
    is_broken_ = true;
    return std::nullopt;
  }
  wanted_ = frame_header_bytes + payload_bytes(at);
  if (there < wanted_) return std::nullopt;
  const Frame frame = frame_at(at);
  begin_ += wanted_;
  wanted_ = frame_header_bytes;
  return frame;
}

}  // namespace geminga::client
