// Lives: 64 random bits of a publisher or subscriber, which stay the same while its daemon is restarted.
#ifndef GEMINGA_CLIENT_PROTOCOL_LIFE_HPP
#define GEMINGA_CLIENT_PROTOCOL_LIFE_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geminga/channel.hpp"
#include "geminga/service.hpp"

namespace geminga::client {

/// The attribute that states a life.
inline constexpr std::string_view channel_attribute = "channel";

/// A new life, by the system's random numbers.
[[nodiscard]] Life new_life();
/// The life of sixteen lower-case hexadecimal digits; nothing if the text is not that, or all digits are 0.
[[nodiscard]] std::optional<Life> read_life(std::string_view text);
/// The life that a service states; no_life if it states none that can be read.
[[nodiscard]] Life stated_life(const Attributes& attributes);

}  // namespace geminga::client

#endif
