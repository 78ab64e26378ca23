#include "reasoning/syntax/graph/existence.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/text.hpp"
#include "reasoning/syntax/graph/query_text.hpp"
#include "reasoning/syntax/graph/reading.hpp"

namespace geminga::graph {
namespace {

constexpr std::string_view exists_mark = "urn:geminga:query#exists";
constexpr std::string_view not_exists_mark = "urn:geminga:query#not-exists";

/// Another text for a stretch of the query.
struct Edit {
  std::size_t begin;
  std::size_t end;
  std::string text;
};

/// Reads words of a query in small letters from a place on.
class Words {
 public:
  Words(std::string_view mask, std::size_t at) : mask_(mask), at_(at) {}

  bool take(std::string_view word) {
    const std::size_t next = std::min(mask_.find_first_not_of(space, at_), mask_.size());
    const bool is_sign = word == "(" || word == "{";
    if (is_sign ? mask_.substr(next, 1) != word : !is_keyword(mask_, next, word)) return false;
    at_ = next + word.size();
    return true;
  }
  [[nodiscard]] std::size_t place() const { return at_; }

 private:
  std::string_view mask_;
  std::size_t at_;
};

/// Whether the filter from `begin` to `end` is all that a group within the pattern has. rasqal takes such a group for
/// its only part, so that the filter would move into the group around it.
bool is_alone_in_group(std::string_view mask, std::size_t begin, std::size_t end) {
  const std::size_t before = begin == 0 ? std::string_view::npos : mask.find_last_not_of(space, begin - 1);
  const std::size_t after = mask.find_first_not_of(" \t\r\n.", end);  // a dot may stand behind a filter
  if (before == std::string_view::npos || after == std::string_view::npos) return false;
  const std::string_view outside = mask.substr(0, before);
  return mask[before] == '{' && mask[after] == '}' &&
         std::ranges::count(outside, '{') > std::ranges::count(outside, '}');
}

std::string_view subject_of(const rasqal_triple& triple) {
  if (triple.subject == nullptr || triple.subject->type != RASQAL_LITERAL_URI) return {};
  return reinterpret_cast<const char*>(raptor_uri_as_string(triple.subject->value.uri));
}

}  // namespace

std::string with_marked_existence(const std::string& query) {
  const std::string mask = base::in_lower_case(masked(query));
  std::vector<Edit> edits;
  for (std::size_t at = 0; at < mask.size(); ++at) {
    if (!is_keyword(mask, at, "filter")) continue;
    Words words(mask, at + std::string_view("filter").size());
    const bool has_parenthesis = words.take("(");
    const bool is_not = words.take("not");
    if (!words.take("exists") || !words.take("{")) continue;
    std::size_t end = std::min(closing(mask, words.place() - 1) + 1, mask.size());
    const std::size_t close = mask.find_first_not_of(space, end);
    if (has_parenthesis) {
      if (close == std::string::npos || mask[close] != ')') continue;
      end = close + 1;
    }
    if (is_alone_in_group(mask, at, end)) continue;
    if (has_parenthesis) edits.push_back({close, end, " "});
    std::string text = "OPTIONAL { <";
    text.append(is_not ? not_exists_mark : exists_mark)
        .append("> <urn:geminga:query#mark> <urn:geminga:query#mark> . ");
    for (std::size_t in = at; in < words.place(); ++in) {
      if (query[in] == '\n') text += '\n';
    }
    edits.push_back({at, words.place(), std::move(text)});
  }
  std::ranges::sort(edits, {}, &Edit::begin);
  std::string marked;
  std::size_t copied = 0;
  for (const Edit& edit : edits) {
    marked.append(query, copied, edit.begin - copied).append(edit.text);
    copied = edit.end;
  }
  return marked.append(query, copied);
}

bool is_mark(const rasqal_triple& triple) {
  const std::string_view subject = subject_of(triple);
  return subject == exists_mark || subject == not_exists_mark;
}

std::optional<bool> existence_of(rasqal_graph_pattern* optional) {
  if (rasqal_graph_pattern_get_operator(optional) != RASQAL_GRAPH_PATTERN_OPERATOR_OPTIONAL) return std::nullopt;
  rasqal_graph_pattern* first = rasqal_graph_pattern_get_sub_graph_pattern(optional, 0);
  if (first != nullptr && rasqal_graph_pattern_get_operator(first) == RASQAL_GRAPH_PATTERN_OPERATOR_GROUP)
    first = rasqal_graph_pattern_get_sub_graph_pattern(first, 0);
  const rasqal_triple* triple = first == nullptr ? nullptr : rasqal_graph_pattern_get_triple(first, 0);
  if (triple == nullptr || !is_mark(*triple)) return std::nullopt;
  return subject_of(*triple) == exists_mark;
}

}  // namespace geminga::graph
