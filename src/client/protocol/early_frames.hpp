// Frames over UDP that cannot be delivered yet: the daemon has not named their sender, or there is no floor yet
// (src/client/CHANNELS.md, Early frames).
#ifndef GEMINGA_CLIENT_PROTOCOL_EARLY_FRAMES_HPP
#define GEMINGA_CLIENT_PROTOCOL_EARLY_FRAMES_HPP

#include <cstddef>
#include <deque>
#include <vector>

#include "base/time.hpp"
#include "client/protocol/frame.hpp"
#include "client/protocol/peer_address.hpp"

namespace geminga::client {

/// Keeps at most max_early_frames with max_early_octets of payload, each for early_patience. The eldest goes first.
class EarlyFrames {
 public:
  /// A frame that owns its octets, sealed as they came.
  struct Kept {
    base::Instant until;
    PeerAddress from;
    Life life;
    std::size_t payload_bytes;
    std::vector<std::byte> octets;

    [[nodiscard]] ReadFrame frame() const { return frame_of(octets); }
  };

  void put(const PeerAddress& from, const ReadFrame& frame, base::Instant now);
  /// Removes the frames of this life from this address; the result has them in the order of arrival.
  [[nodiscard]] std::vector<Kept> take(const PeerAddress& from, Life life, base::Instant now);

 private:
  void drop_first();
  void drop_old(base::Instant now);

  std::deque<Kept> kept_;
  std::size_t octets_ = 0;
};

}  // namespace geminga::client

#endif
