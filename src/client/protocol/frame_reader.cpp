#include "client/protocol/frame_reader.hpp"

#include <algorithm>

namespace geminga::client {
namespace {

/// Octets that are read at once where no longer frame is under way.
constexpr std::size_t read_bytes = 64 * 1024;

}  // namespace

std::span<std::byte> FrameReader::room() {
  if (begin_ > 0) {
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
              buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
    end_ -= begin_;
    begin_ = 0;
  }
  buffer_.resize(std::max(wanted_, end_ + std::min(read_bytes, max_frame_overhead + max_payload_)));
  return std::span(buffer_).subspan(end_);
}

std::optional<ReadFrame> FrameReader::next() {
  const std::size_t there = end_ - begin_;
  if (is_broken_ || there < frame_header_bytes) return std::nullopt;
  const std::byte* at = buffer_.data() + begin_;
  const auto size = frame_size(at, max_payload_);
  if (!size) {
    is_broken_ = true;
    return std::nullopt;
  }
  wanted_ = *size;
  if (there < wanted_) return std::nullopt;
  begin_ += wanted_;
  wanted_ = frame_header_bytes;
  return frame_of({at, *size});
}

}  // namespace geminga::client
