#include "reasoning/syntax/count.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace geminga::syntax {

std::expected<std::uint32_t, CountFault> read_count(std::string_view text) {
  text = base::trimmed(text);
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  if (text.empty() || text.find_first_not_of("0123456789") != std::string_view::npos)
    return std::unexpected(CountFault::not_a_count);
  text.remove_prefix(std::min(text.find_first_not_of('0'), text.size() - 1));
  if (is_negative && text != "0") return std::unexpected(CountFault::not_a_count);
  const auto number = base::parse_number<std::uint32_t>(text);
  if (!number) return std::unexpected(CountFault::too_great);
  return *number;
}

}  // namespace geminga::syntax
