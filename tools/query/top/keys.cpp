#include "query/top/keys.hpp"

#include <algorithm>
#include <utility>

namespace geminga::query::top {
namespace {

Key key_of(std::string_view sequence) {
  if (sequence == "A") return key::up;
  if (sequence == "B") return key::down;
  if (sequence == "5~") return key::page_up;
  if (sequence == "6~") return key::page_down;
  return key::other;
}

bool is_final(char c) { return c >= 0x40 && c <= 0x7e; }

}  // namespace

std::vector<Key> Keys::read(std::string_view octets) {
  const std::string text = std::exchange(begun_, "") + std::string(octets);
  std::vector<Key> keys;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto octet = static_cast<unsigned char>(text[at]);
    const bool is_sequence = octet == 0x1b && at + 1 < text.size() && (text[at + 1] == '[' || text[at + 1] == 'O');
    if (!is_sequence) {
      keys.push_back(octet == '\n' ? key::enter : octet < 0x80 ? Key{octet} : key::other);
      continue;
    }
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(at) + 2;
    const auto end = std::find_if(begin, text.end(), is_final);
    if (end == text.end()) {
      begun_ = text.substr(at);
      if (begun_.size() > max_sequence_bytes) begun_.clear();
      return keys;
    }
    keys.push_back(key_of(std::string_view(begin, end + 1)));
    at = static_cast<std::size_t>(end - text.begin());
  }
  return keys;
}

}  // namespace geminga::query::top
