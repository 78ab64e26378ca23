// Frames of channels: the reader of datagrams and that of streams must agree, however a stream arrives.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/assert.hpp"
#include "client/protocol/frame_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace geminga::client;
  const auto bytes = std::as_bytes(std::span(data, size));
  if (const auto frame = read_frame(bytes)) {
    const auto written = frame_bytes(*frame);
    GEMINGA_ASSERT(std::ranges::equal(written, bytes));
  }
  // A stream that arrives at once and one that arrives octet by octet give the same frames.
  constexpr std::size_t largest = 4096;
  std::vector<std::vector<std::byte>> given[2];
  bool is_broken[2] = {};
  for (const std::size_t way : {0UL, 1UL}) {
    FrameReader reader(largest);
    for (std::size_t at = 0; at < size && !reader.is_broken();) {
      const auto room = reader.room();
      const std::size_t piece = std::min({way == 0 ? size - at : 1UL, room.size(), size - at});
      std::ranges::copy(bytes.subspan(at, piece), room.begin());
      reader.fed(piece);
      at += piece;
      while (const auto frame = reader.next()) given[way].push_back(frame_bytes(*frame));
    }
    is_broken[way] = reader.is_broken();
  }
  GEMINGA_ASSERT(given[0] == given[1] && is_broken[0] == is_broken[1]);
  return 0;
}
