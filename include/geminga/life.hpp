// Lives, by which the two ends of a channel know each other (src/client/CHANNELS.md, "Life").
#ifndef GEMINGA_LIFE_HPP
#define GEMINGA_LIFE_HPP

#include <cstdint>
#include <string>

namespace geminga {

/// 64 random bits that name one publisher or subscriber. They stay the same while its daemon is restarted. A program
/// that is restarted has other ones.
enum class Life : std::uint64_t {};
/// The life of a publisher or subscriber that states none.
inline constexpr Life no_life{};
/// Sixteen lower-case hexadecimal digits.
[[nodiscard]] std::string to_string(Life life);

}  // namespace geminga

#endif
