// The keys of one life, as the daemon gives them to its own programs (src/client/CHANNELS.md, Sealed channels).
#ifndef GEMINGA_CLIENT_PROTOCOL_CHANNEL_KEYS_HPP
#define GEMINGA_CLIENT_PROTOCOL_CHANNEL_KEYS_HPP

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "client/protocol/frame.hpp"
#include "client/protocol/primitives.hpp"
#include "discovery/gcnp/statement.hpp"
#include "geminga/channel.hpp"

namespace geminga::client {

/// The mode of a host (src/discovery/sealing/SEALING.md, Modes).
enum class SealingMode : std::uint8_t { plain, prepared, mixed, authenticated, encrypted };

/// The mode of its word; nothing for another word.
[[nodiscard]] std::optional<SealingMode> sealing_mode(std::string_view word);

using KeyId = std::uint16_t;

/// The mode of this host, and the ring of the keys of one publisher's life. Has no form for texts: keys are never
/// shown.
class ChannelKeys {
 public:
  struct Key {
    KeyId id = 0;
    Secret forward;  ///< seals what the publisher says
    Secret back;     ///< seals what its consumers say
    friend bool operator==(const Key&, const Key&) = default;
  };

  /// A host without keys.
  ChannelKeys() = default;
  /// Requires a ring that is empty exactly where the mode is plain. The first key seals, all of them open.
  ChannelKeys(SealingMode mode, std::vector<Key> ring) : mode_(mode), ring_(std::move(ring)) {}

  [[nodiscard]] SealingMode mode() const { return mode_; }
  [[nodiscard]] const std::vector<Key>& ring() const { return ring_; }
  [[nodiscard]] bool has_ring() const { return !ring_.empty(); }
  /// The form in which this host sends.
  [[nodiscard]] FrameForm form() const;
  [[nodiscard]] bool sends_sealed() const { return form() != FrameForm::plain; }
  [[nodiscard]] bool takes_plain() const { return mode_ <= SealingMode::mixed; }
  friend bool operator==(const ChannelKeys&, const ChannelKeys&) = default;

 private:
  SealingMode mode_ = SealingMode::plain;
  std::vector<Key> ring_;
};

/// The content of a line `N pub keys life=L mode=M ring=ID:FORWARD:BACK,...`.
struct StatedKeys {
  Life life = no_life;
  ChannelKeys keys;
};
/// Nothing if the line cannot be read.
[[nodiscard]] std::optional<StatedKeys> read_keys(const gcnp::Statement& statement);

}  // namespace geminga::client

#endif
