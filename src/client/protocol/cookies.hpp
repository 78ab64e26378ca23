// Cookies, by which a publisher knows that somebody receives at the address of a hello (src/client/CHANNELS.md, The
// handshake).
#ifndef GEMINGA_CLIENT_PROTOCOL_COOKIES_HPP
#define GEMINGA_CLIENT_PROTOCOL_COOKIES_HPP

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/time.hpp"
#include "client/protocol/limits.hpp"
#include "client/protocol/octets.hpp"
#include "client/protocol/peer_address.hpp"
#include "client/protocol/primitives.hpp"
#include "geminga/channel.hpp"

namespace geminga::client {

/// Makes cookies and keeps none of them. A cookie is good in the cookie_interval in which it was made and in the next.
class Cookies {
 public:
  /// The cookie of a consumer with this address, life and challenge; never 0.
  [[nodiscard]] std::uint64_t make(const PeerAddress& address, Life life, std::uint64_t challenge,
                                   base::Instant now) const {
    return cookie(address, life, challenge, interval_of(now));
  }
  [[nodiscard]] bool accepts(std::uint64_t given, const PeerAddress& address, Life life, std::uint64_t challenge,
                             base::Instant now) const {
    const std::uint64_t present = interval_of(now);
    return given == cookie(address, life, challenge, present) || given == cookie(address, life, challenge, present - 1);
  }

 private:
  static std::uint64_t interval_of(base::Instant now) {
    return static_cast<std::uint64_t>(now.time_since_epoch() / base::Duration(cookie_interval));
  }
  [[nodiscard]] std::uint64_t cookie(const PeerAddress& address, Life life, std::uint64_t challenge,
                                     std::uint64_t interval) const {
    std::array<std::byte, 16 + 4 + 2 + 3 * 8> text{};
    std::byte* at =
        std::ranges::transform(address.octets, text.begin(), [](auto octet) { return std::byte{octet}; }).out;
    write_number(at, address.zone);
    write_number(at + 4, address.port);
    write_number(at + 6, static_cast<std::uint64_t>(life));
    write_number(at + 14, challenge);
    write_number(at + 22, interval);
    const std::uint64_t made = keyed_hash(secret_, text);
    return made == 0 ? 1 : made;
  }

  Secret secret_ = Secret::random();
};

}  // namespace geminga::client

#endif
