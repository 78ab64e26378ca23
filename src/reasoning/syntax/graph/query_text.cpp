#include "reasoning/syntax/graph/query_text.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/text.hpp"

namespace geminga::graph {
namespace {

/// Whether the query itself declares the prefix.
bool declares(std::string_view query, std::string_view prefix) {
  const std::string word = std::string(prefix) + ':';
  for (std::size_t at = query.find(word); at != std::string_view::npos; at = query.find(word, at + 1)) {
    const bool is_word = at > 0 && space.find(query[at - 1]) != std::string_view::npos;
    const std::size_t behind = query.find_first_not_of(space, at + word.size());
    if (is_word && behind != std::string_view::npos && query[behind] == '<') return true;
  }
  return false;
}

/// The end of a quoted text of SPARQL that begins here, or of the query where it has none.
std::size_t end_of_quoted(std::string_view query, std::size_t at) {
  const std::string quote(1, query[at]);
  const std::string end = query.substr(at, 3) == quote + quote + quote ? quote + quote + quote : quote;
  for (at += end.size(); at < query.size(); ++at) {
    if (query.substr(at, end.size()) == end) return at + end.size();
    if (query[at] == '\\') ++at;
  }
  return query.size();
}

/// The end of the text, comment, IRI or escape that begins here; the next place if none does.
std::size_t end_of_piece(std::string_view query, std::size_t at) {
  switch (query[at]) {
    case '"':
    case '\'':
      return end_of_quoted(query, at);
    case '#':
      return std::min(query.find_first_of("\r\n", at), query.size());
    case '<': {  // an IRI has none of these, and less-than has one of them behind it
      const std::size_t behind = query.find_first_of("<>\"{}|^`\\ \t\r\n", at + 1);
      return behind != std::string_view::npos && query[behind] == '>' ? behind + 1 : at + 1;
    }
    case '\\':
      return std::min(at + 2, query.size());
    default:
      return at + 1;
  }
}

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// Whether the word that ends here is a number or a variable, and no name that may have a - in it.
bool is_number_before(std::string_view mask, std::size_t end) {
  std::size_t begin = end;
  while (begin > 0 && (is_name_character(mask[begin - 1]) || mask[begin - 1] == '.')) --begin;
  const bool is_number = begin < end && mask[begin] >= '0' && mask[begin] <= '9';
  const bool is_variable = begin > 0 && (mask[begin - 1] == '?' || mask[begin - 1] == '$');
  return (is_number || is_variable) && (begin == 0 || mask[begin - 1] != ':');
}

/// Whether a number ends here, and no name.
bool is_digits_before(std::string_view mask, std::size_t end) {
  std::size_t begin = end;
  while (begin > 0 && (mask[begin - 1] == '.' || (mask[begin - 1] >= '0' && mask[begin - 1] <= '9'))) --begin;
  return begin < end && (begin == 0 || !(is_name_character(mask[begin - 1]) ||
                                         std::string_view("?$:").find(mask[begin - 1]) != std::string_view::npos));
}

/// Reads a block of values from the text of a query.
class ValuesReader {
 public:
  ValuesReader(const std::string& query, const std::string& mask, std::size_t at)
      : query_(query), mask_(mask), at_(at) {}

  std::optional<WrittenValues> read() {
    WrittenValues values;
    const bool has_rows = take('(');
    do {
      if (!skip() || (query_[at_] != '?' && query_[at_] != '$')) break;
      ++at_;
      values.variables.push_back(word());
    } while (has_rows);
    if (has_rows && !take(')')) return std::nullopt;
    if (!take('{')) return std::nullopt;
    while (!take('}')) {
      auto& row = values.rows.emplace_back();
      if (has_rows && !take('(')) return std::nullopt;
      do {
        if (has_rows && take(')')) break;
        if (!skip()) return std::nullopt;
        const std::string written = term();
        if (written.empty()) return std::nullopt;
        row.push_back(base::in_lower_case(written) == "undef" ? std::nullopt : std::optional(written));
      } while (has_rows);
      if (row.size() != values.variables.size()) return std::nullopt;
    }
    return values;
  }
  [[nodiscard]] std::size_t end() const { return at_; }

 private:
  /// Goes to the next character that is no space and no comment. False at the end.
  bool skip() {
    while (at_ < query_.size()) {
      if (query_[at_] == '#' && mask_[at_] == ' ') {
        at_ = end_of_piece(query_, at_);
      } else if (space.find(query_[at_]) != std::string_view::npos) {
        ++at_;
      } else {
        return true;
      }
    }
    return false;
  }
  bool take(char wanted) {
    if (!skip() || query_[at_] != wanted) return false;
    ++at_;
    return true;
  }
  std::string word() {
    const std::size_t begin = at_;
    while (at_ < query_.size() && is_name_character(query_[at_])) ++at_;
    return query_.substr(begin, at_ - begin);
  }
  std::string term() {
    const std::size_t begin = at_;
    if (query_[at_] == '<' || query_[at_] == '"' || query_[at_] == '\'') {
      const bool is_text = query_[at_] != '<';
      at_ = end_of_piece(query_, at_);
      if (is_text && query_.substr(at_, 2) == "^^") {
        at_ += 2;
        if (at_ < query_.size() && query_[at_] == '<') {
          at_ = end_of_piece(query_, at_);
        } else {
          plain();
        }
      } else if (is_text && at_ < query_.size() && query_[at_] == '@') {
        plain();
      }
    } else {
      plain();
    }
    return query_.substr(begin, at_ - begin);
  }
  void plain() {
    while (at_ < query_.size() && std::string_view(" \t\r\n(){}<\"'#").find(query_[at_]) == std::string_view::npos)
      at_ += query_[at_] == '\\' ? 2 : 1;
    at_ = std::min(at_, query_.size());
  }

  const std::string& query_;
  const std::string& mask_;
  std::size_t at_;
};

/// The end of the literal of SPARQL that begins here, maybe with a sign; `at` if none does. `mask` is in small letters.
std::size_t end_of_literal(std::string_view query, std::string_view mask, std::size_t at) {
  const auto is_digit = [&](std::size_t place) {
    return place < mask.size() && mask[place] >= '0' && mask[place] <= '9';
  };
  const auto end_of_name = [&](std::size_t place) {
    while (place < mask.size() && (is_name_character(mask[place]) || mask[place] == ':' || mask[place] == '.')) ++place;
    return mask[place - 1] == '.' ? place - 1 : place;
  };
  if (query[at] == '"' || query[at] == '\'') {
    const std::size_t end = end_of_piece(query, at);
    if (end < query.size() && query[end] == '@') return end_of_name(end + 1);
    if (query.substr(end, 2) != "^^" || end + 2 == query.size()) return end;
    return query[end + 2] == '<' ? end_of_piece(query, end + 2) : end_of_name(end + 2);
  }
  for (const std::string_view truth : {"true", "false"}) {
    if (is_keyword(mask, at, truth)) return at + truth.size();
  }
  const bool is_inside = at > 0 && (is_name_character(mask[at - 1]) ||
                                    std::string_view("?$:.@\\%").find(mask[at - 1]) != std::string_view::npos);
  const std::size_t first = mask[at] == '+' || mask[at] == '-' ? at + 1 : at;
  const bool is_number = is_digit(first) || (first < mask.size() && mask[first] == '.' && is_digit(first + 1));
  if (is_inside || !is_number) return at;
  at = first;
  while (is_digit(at) || (at < mask.size() && mask[at] == '.')) ++at;
  if (at == mask.size() || mask[at] != 'e') return at;
  const std::size_t exponent = at + 1 < mask.size() && (mask[at + 1] == '+' || mask[at + 1] == '-') ? at + 2 : at + 1;
  if (!is_digit(exponent)) return at;
  for (at = exponent; is_digit(at);) ++at;
  return at;
}

}  // namespace

bool is_keyword(std::string_view mask, std::size_t at, std::string_view keyword) {
  if (mask.substr(at, keyword.size()) != keyword) return false;
  const std::size_t end = at + keyword.size();
  const bool ends = end == mask.size() || (!is_name_character(mask[end]) && mask[end] != ':');
  return ends && (at == 0 || (!is_name_character(mask[at - 1]) &&
                              std::string_view("?$:.@").find(mask[at - 1]) == std::string_view::npos));
}

std::size_t closing(std::string_view mask, std::size_t open) {
  std::size_t level = 0;
  for (std::size_t at = open; at < mask.size(); ++at) {
    if (mask[at] == '{') ++level;
    if (mask[at] == '}' && --level == 0) return at;
  }
  return mask.size();
}

std::string masked(std::string_view query) {
  std::string mask(query);
  for (std::size_t at = 0; at < query.size();) {
    const std::size_t end = end_of_piece(query, at);
    if (end > at + 1)
      std::fill(mask.begin() + static_cast<std::ptrdiff_t>(at), mask.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    at = end;
  }
  return mask;
}

std::string with_prefixes(const std::string& query, const Prefixes& prefixes) {
  std::string text;
  for (const auto& [prefix, name] : prefixes) {
    const bool is_plain = std::ranges::all_of(prefix, [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    });
    const bool is_iri = name.find_first_of("<>\"{}|\\^` ") == std::string::npos;
    if (is_plain && is_iri && !declares(query, prefix))
      text.append("PREFIX ").append(prefix).append(": <").append(name).append("> ");
  }
  const std::string mask = base::in_lower_case(masked(query));
  const std::size_t first = mask.find_first_not_of(space);
  if (first == std::string::npos || !is_keyword(mask, first, "base")) return text + query;
  const std::size_t begin = query.find('<', first);
  const std::size_t end = begin == std::string::npos ? begin : query.find('>', begin);
  if (end == std::string::npos) return text + query;
  return query.substr(0, end + 1) + ' ' + text + query.substr(end + 1);
}

std::string with_spaced_signs(const std::string& query) {
  const std::string mask = base::in_lower_case(masked(query));
  std::string spaced;
  std::size_t parentheses = 0;  // numbers with signs stand in triples and VALUES, too
  char last = ' ';              // the last character that is no space
  for (std::size_t at = 0; at < query.size(); ++at) {
    if (is_keyword(mask, at, "values")) {
      const std::size_t open = mask.find('{', at);
      const std::size_t end = open == std::string::npos ? mask.size() : closing(mask, open);
      spaced += query.substr(at, end - at);
      if (end == mask.size()) return spaced;
      at = end;
    }
    spaced += query[at];
    if (mask[at] == '(') ++parentheses;
    if (mask[at] == ')' && parentheses > 0) --parentheses;
    const bool is_sign = mask[at] == '+' || mask[at] == '-';
    const bool is_number =
        at + 1 < mask.size() && std::string_view("0123456789.").find(mask[at + 1]) != std::string_view::npos;
    const bool ends_operand =
        (is_name_character(last) && last != '-') || last == ')' || last == '"' || last == '\'' || last == '>';
    const bool is_behind_name = at > 0 && is_name_character(mask[at - 1]);
    const bool is_in_name = is_behind_name && mask[at] == '-' && !is_number_before(mask, at);
    const bool is_exponent = is_behind_name && mask[at - 1] == 'e' && is_digits_before(mask, at - 1);
    if (is_sign && is_number && parentheses > 0 && ends_operand && !is_in_name && !is_exponent) spaced += ' ';
    if (space.find(query[at]) == std::string_view::npos) last = query[at];
  }
  return spaced;
}

std::string with_opaque_constants(const std::string& query) {
  enum class Place : std::uint8_t { clauses, pattern, formula };
  const std::string mask = base::in_lower_case(masked(query));
  std::string text;
  std::vector<Place> places{Place::clauses};  // outside, and within what braces and parentheses are open
  bool begins_formula = false;  // behind FILTER or BIND: other parentheses in a pattern are those of lists
  bool is_separator = false;    // of GROUP_CONCAT, which is no expression
  for (std::size_t at = 0; at < query.size();) {
    if (mask[at] == '{') {
      places.push_back(Place::pattern);
    } else if (mask[at] == '(') {
      const bool is_list = places.back() == Place::pattern && !std::exchange(begins_formula, false);
      places.push_back(is_list ? Place::pattern : Place::formula);
    } else if ((mask[at] == ')' || mask[at] == '}') && places.size() > 1) {
      places.pop_back();
    } else if (is_keyword(mask, at, "filter") || is_keyword(mask, at, "bind")) {
      begins_formula = true;
    } else if (is_keyword(mask, at, "select")) {
      places.back() = Place::clauses;  // an inner query fills its braces
    } else if (is_keyword(mask, at, "separator")) {
      is_separator = true;
    }
    const bool is_remark_or_iri = mask[at] == ' ' && (query[at] == '#' || query[at] == '<');
    const std::size_t literal = is_remark_or_iri ? at : end_of_literal(query, mask, at);
    const std::size_t end = literal > at ? literal : end_of_piece(query, at);
    const std::string piece = query.substr(at, end - at);
    const bool is_constant = literal > at && places.back() == Place::formula && !std::exchange(is_separator, false);
    text += is_constant ? " COALESCE(" + piece + ", RAND())" : piece;
    at = end;
  }
  return text;
}

std::size_t levels_of(std::string_view mask, std::string_view opening, std::string_view closing) {
  std::size_t deepest = 0;
  std::size_t level = 0;
  for (const char c : mask) {
    if (opening.contains(c)) deepest = std::max(deepest, ++level);
    if (closing.contains(c) && level > 0) --level;
  }
  return deepest;
}

bool describes_all(const std::string& query) {
  const std::string mask = base::in_lower_case(masked(query));
  constexpr std::string_view describe = "describe";
  for (std::size_t at = 0; at < mask.size(); ++at) {
    if (!is_keyword(mask, at, describe)) continue;
    const std::size_t next = mask.find_first_not_of(space, at + describe.size());
    return next != std::string::npos && mask[next] == '*';
  }
  return false;
}

std::string prologue_of(const std::string& query) {
  const std::string mask = base::in_lower_case(masked(query));
  for (std::size_t at = 0; at < mask.size(); ++at) {
    for (const std::string_view verb : {"select", "ask", "construct", "describe"}) {
      if (is_keyword(mask, at, verb)) return query.substr(0, at);
    }
  }
  return {};
}

std::optional<InnerTexts> inner_texts(const std::string& query) {
  InnerTexts found;
  const std::string mask = base::in_lower_case(masked(query));
  std::size_t level = 0;
  for (std::size_t at = prologue_of(query).size(); at < mask.size(); ++at) {
    if (mask[at] == '{') ++level;
    if (mask[at] == '}' && level > 0) --level;
    if (mask[at] == '{') {
      const std::size_t next = mask.find_first_not_of(space, at + 1);
      if (next != std::string::npos && is_keyword(mask, next, "select")) {
        const std::size_t end = closing(mask, at);
        found.queries.push_back(query.substr(next, end - next));
        at = end;
        --level;
      }
    } else if (is_keyword(mask, at, "values")) {
      ValuesReader reader(query, mask, at + std::string_view("values").size());
      auto values = reader.read();
      if (!values) return std::nullopt;
      if (level == 0) {
        found.last = std::move(values);
      } else {
        found.values.push_back(std::move(*values));
      }
      at = reader.end() - 1;
    }
  }
  return found;
}

}  // namespace geminga::graph
