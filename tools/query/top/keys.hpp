// The keys of a terminal, from the octets that it sends.
#ifndef GEMINGA_QUERY_TOP_KEYS_HPP
#define GEMINGA_QUERY_TOP_KEYS_HPP

#include <string>
#include <string_view>
#include <vector>

namespace geminga::query::top {

/// A key: a letter, or one that has a name.
enum class Key : unsigned char {
  enter = '\r',
  escape = 0x1b,
  up = 0x80,  ///< behind all letters of ASCII
  down,
  page_up,
  page_down,
  other,  ///< of no meaning here
};

[[nodiscard]] constexpr Key letter(char c) { return static_cast<Key>(c); }

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
