// Lives as services state them: 64 random bits by which a channel is known (src/client/CHANNELS.md, "Life").
#ifndef GEMINGA_DISCOVERY_GCNP_LIFE_HPP
#define GEMINGA_DISCOVERY_GCNP_LIFE_HPP

#include <optional>
#include <string_view>

#include "geminga/life.hpp"
#include "geminga/service.hpp"

namespace geminga::gcnp {

/// The attribute that states a life.
inline constexpr std::string_view channel_attribute = "channel";

/// The life of sixteen lower-case hexadecimal digits; nothing if the text is not that, or all digits are 0.
[[nodiscard]] std::optional<Life> read_life(std::string_view text);
/// The life that a service states; no_life if it states none that can be read.
[[nodiscard]] Life stated_life(const Attributes& attributes);

}  // namespace geminga::gcnp

#endif
