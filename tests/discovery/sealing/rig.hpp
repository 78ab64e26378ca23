// The rig of the tests of sealing: keys by number, texts as octets, and members of a team on one link.
#ifndef GEMINGA_TESTS_DISCOVERY_SEALING_RIG_HPP
#define GEMINGA_TESTS_DISCOVERY_SEALING_RIG_HPP

#include <cstddef>
#include <expected>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/random.hpp"
#include "discovery/sealing/seal.hpp"

namespace geminga::sealing {

using Octets = std::vector<std::byte>;

/// A key; the same for the same number.
[[nodiscard]] Key key_of(int number);
[[nodiscard]] Policy policy(Mode mode, std::initializer_list<int> keys);

[[nodiscard]] Octets octets_of(std::string_view text);
[[nodiscard]] std::string text_of(std::span<const std::byte> octets);
[[nodiscard]] Octets copy_of(std::span<const std::byte> octets);
/// A text that cannot be compressed; the same for the same size.
[[nodiscard]] std::string noise(std::size_t size);
/// An octet with other bits.
[[nodiscard]] Octets bent(Octets octets, std::size_t at, std::uint8_t bits = 1);

inline constexpr env::InterfaceIndex wlan{3};
inline constexpr env::InterfaceIndex lan{2};

/// One participant's seal, with a clock that the test moves.
class Member {
 public:
  explicit Member(int seed, const Policy& how, base::Instant start = base::Instant(std::chrono::hours(1)));

  [[nodiscard]] Octets say(std::string_view text, env::InterfaceIndex interface = wlan);
  /// The text, or the word for why it was not heard.
  [[nodiscard]] std::string hear(std::span<const std::byte> datagram, env::InterfaceIndex interface = wlan,
                                 std::string_view source = "10.0.0.1");
  [[nodiscard]] Arrival arrival(env::InterfaceIndex interface = wlan, std::string_view source = "10.0.0.1") const;
  void pass(base::Duration time) { now += time; }

  base::Instant now;
  base::Random random;
  Seal seal;
};

/// Lets two members prove themselves to each other.
void introduce(Member& one, Member& other);

}  // namespace geminga::sealing

#endif
