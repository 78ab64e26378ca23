#include "discovery/matching/conditions/pattern.hpp"

namespace geminga::matching {

bool is_like(std::string_view text, std::string_view pattern) {
  const auto first = pattern.find('*');
  if (first == std::string_view::npos) return text == pattern;
  const auto last = pattern.rfind('*');
  const std::string_view front = pattern.substr(0, first);
  const std::string_view back = pattern.substr(last + 1);
  if (text.size() < front.size() + back.size() || !text.starts_with(front) || !text.ends_with(back)) return false;
  text = text.substr(front.size(), text.size() - front.size() - back.size());
  for (std::string_view rest = pattern.substr(first, last - first); !rest.empty();) {
    rest.remove_prefix(1);
    const std::string_view piece = rest.substr(0, rest.find('*'));
    const auto at = text.find(piece);
    if (at == std::string_view::npos) return false;
    text.remove_prefix(at + piece.size());
    rest.remove_prefix(piece.size());
  }
  return true;
}

}  // namespace geminga::matching
