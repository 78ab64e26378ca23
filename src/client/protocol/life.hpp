// The life of a publisher or subscriber: 64 random bits that stay while its daemon comes and goes.
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

/// A new one, from the system's chance.
[[nodiscard]] Life new_life();
/// The life of sixteen lower-case hexadecimal digits that are not all 0, or nothing.
[[nodiscard]] std::optional<Life> read_life(std::string_view text);
/// The life that a service states; no_life where it states none that can be read.
[[nodiscard]] Life stated_life(const Attributes& attributes);

}  // namespace geminga::client

#endif
