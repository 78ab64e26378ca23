#include "query/need.hpp"

#include <charconv>
#include <optional>
#include <sstream>

#include "discovery/roles/task.hpp"

namespace geminga::query {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
}

/// The place of ` where ` outside of quotation marks.
std::size_t place_of_where(std::string_view text) {
  bool is_quoted = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\\') {
      ++at;
    } else if (text[at] == '"') {
      is_quoted = !is_quoted;
    } else if (!is_quoted && text.substr(at).starts_with(" where ")) {
      return at;
    }
  }
  return std::string_view::npos;
}

/// Reads what is before the colon; nothing where it is no head.
std::optional<Need> read_head(std::string_view head) {
  Need need;
  std::istringstream words{std::string(head)};
  bool has_words = false;
  for (std::string word; words >> word; has_words = true) {
    if (word == "shared" && !need.is_shared) {
      need.is_shared = true;
      continue;
    }
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), need.count);
    if (has_words || error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  }
  return has_words ? std::optional(need) : std::nullopt;
}

}  // namespace

std::expected<Need, std::string> read_need(std::string_view text) {
  Need need;
  std::string_view rest = text;
  if (const auto colon = text.find(':'); colon != std::string_view::npos) {
    if (auto head = read_head(text.substr(0, colon))) {
      need = std::move(*head);
      rest = text.substr(colon + 1);
    }
  }
  need.text = trimmed(text);
  const auto where = place_of_where(rest);
  need.expression = trimmed(rest.substr(0, where));
  if (where != std::string_view::npos) {
    need.condition = trimmed(rest.substr(where + std::string_view(" where ").size()));
    if (need.condition.empty()) return std::unexpected("nothing stands behind where: write 'where battery >= 30 %'");
  }
  if (need.expression.empty()) {
    return std::unexpected("has no class expression: write '2: canSee some WarmThing where battery >= 30 %'");
  }
  if (need.count == 0 || need.count > roles::max_holders) {
    return std::unexpected("asks for " + std::to_string(need.count) + " robots: ask for 1 to " +
                           std::to_string(roles::max_holders));
  }
  return need;
}

std::expected<Wish, std::string> read_wish(std::string_view text) {
  std::istringstream words{std::string(text)};
  Wish wish;
  std::string order;
  std::string more;
  words >> wish.attribute >> order >> more;
  if (wish.attribute.empty() || !more.empty() || (order != "asc" && order != "desc")) {
    return std::unexpected("is no wish: write one attribute with asc or desc, as in 'battery desc'");
  }
  wish.is_descending = order == "desc";
  return wish;
}

}  // namespace geminga::query
