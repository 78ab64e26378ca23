// The reasons for which a relayed word is not believed or not passed on.
#ifndef GEMINGA_DISCOVERY_RELAYING_REFUSAL_HPP
#define GEMINGA_DISCOVERY_RELAYING_REFUSAL_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace geminga::relaying {

/// Words are only ever appended.
enum class Refusal : std::uint8_t {
  unvouched,   ///< by a sender that proves nothing and is not named: without a key only named peers are believed
  looped,      ///< it has passed us before, by the relays that it names
  own,         ///< our own word comes back
  repeated,    ///< this word was heard, on another way
  unreadable,  ///< not sealed with a key of ours, or no announcement
  other_kind,  ///< an announcement of a kind that is not passed on
  near,        ///< we hear its sender ourselves
  too_far,     ///< not passed on: it has passed max_hops relays
  too_large,   ///< not passed on: over max_word_bytes
  too_many,    ///< not passed on: more than words_capacity at once
};
inline constexpr std::size_t refusal_count = 10;

/// "unvouched", "looped", ... Static storage.
[[nodiscard]] constexpr std::string_view to_string(Refusal refusal) {
  constexpr std::array<std::string_view, refusal_count> words{
      "unvouched", "looped", "own", "repeated", "unreadable", "other_kind", "near", "too_far", "too_large", "too_many"};
  return words.at(static_cast<std::size_t>(refusal));
}

}  // namespace geminga::relaying

#endif
