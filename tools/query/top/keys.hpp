// The keys of a terminal, from the octets that it sends.
#ifndef GEMINGA_QUERY_TOP_KEYS_HPP
#define GEMINGA_QUERY_TOP_KEYS_HPP

#include <string>
#include <string_view>
#include <vector>

namespace geminga::query::top {

/// A key: a character of ASCII, or one of the names below.
using Key = unsigned;

namespace key {
inline constexpr Key enter = '\r';
inline constexpr Key escape = 0x1b;
inline constexpr Key up = 0x100;  ///< behind all octets
inline constexpr Key down = 0x101;
inline constexpr Key page_up = 0x102;
inline constexpr Key page_down = 0x103;
inline constexpr Key other = 0x104;  ///< of no meaning here
}  // namespace key

/// Reads keys in whatever pieces their octets come (ECMA-48, section 5.4: control sequences). An escape at the end of a
/// piece is the key of that name.
class Keys {
 public:
  [[nodiscard]] std::vector<Key> read(std::string_view octets);

 private:
  std::string begun_;  ///< a control sequence without its end; at most max_sequence_bytes
};

/// The longest control sequence that is waited for.
inline constexpr std::size_t max_sequence_bytes = 16;

}  // namespace geminga::query::top

#endif
