// The frames of one publisher that a consumer believes, by the mode and the keys of this host.
#ifndef GEMINGA_CLIENT_PROTOCOL_INTAKE_HPP
#define GEMINGA_CLIENT_PROTOCOL_INTAKE_HPP

#include <optional>
#include <utility>
#include <vector>

#include "client/protocol/channel_keys.hpp"
#include "client/protocol/sealed_frame.hpp"

namespace geminga::client {

/// Opens sealed frames, and takes plain ones where the mode does. A host that takes all forms takes no plain frame of a
/// life of which it has taken a sealed one.
class Intake {
 public:
  struct Opened {
    Frame frame;
    bool is_proved = false;  ///< opened with a key
  };

  explicit Intake(ChannelKeys keys) : keys_(std::move(keys)) {}

  [[nodiscard]] const ChannelKeys& keys() const { return keys_; }
  void set_keys(ChannelKeys keys) {
    keys_ = std::move(keys);
    if (!keys_.has_ring()) has_taken_sealed_ = false;
  }
  /// The frame with its payload, which is borrowed from it or from `room`. Nothing if it is not to be believed.
  [[nodiscard]] std::optional<Opened> open(const ReadFrame& frame, std::vector<std::byte>& room) {
    if (frame.form == FrameForm::plain) {
      if (!keys_.takes_plain() || has_taken_sealed_) return std::nullopt;
      return Opened{frame, false};
    }
    const auto opened = open_frame(frame, keys_, Direction::forward, room);
    if (!opened) return std::nullopt;
    has_taken_sealed_ = true;
    return Opened{*opened, true};
  }

 private:
  ChannelKeys keys_;
  bool has_taken_sealed_ = false;
};

}  // namespace geminga::client

#endif
