#include "discovery/matching/conditions/where_parser.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "discovery/matching/conditions/number.hpp"
#include "discovery/matching/conditions/similar_unit.hpp"
#include "discovery/matching/conditions/unit.hpp"

namespace geminga::matching {
namespace {

using Node = Where::Node;

bool is_blank(char octet) { return octet == ' ' || octet == '\t' || octet == '\r' || octet == '\n'; }

bool is_word_octet(char octet) { return base::is_key_octet(octet) || octet == ':' || octet == '/' || octet == '+'; }

bool is_pattern_octet(char octet) { return is_word_octet(octet) || octet == '*'; }

/// Symbols of units may have letters of any alphabet.
bool is_unit_octet(char octet) {
  return is_pattern_octet(octet) || octet == '^' || octet == '%' || octet == '#' ||
         static_cast<unsigned char>(octet) >= 0x80;
}

/// The run of such octets that a text begins with.
std::string_view run_of(std::string_view text, bool (*is_one)(char octet)) {
  return text.substr(0, static_cast<std::size_t>(std::ranges::find_if_not(text, is_one) - text.begin()));
}

char lower(char octet) { return octet >= 'A' && octet <= 'Z' ? static_cast<char>(octet - 'A' + 'a') : octet; }

/// The words of the language may be written in any case. Keys and texts have case.
bool is_keyword(std::string_view word, std::string_view keyword) {
  return std::ranges::equal(word, keyword, {}, lower);
}

bool is_reserved(std::string_view word) {
  return std::ranges::any_of(std::array<std::string_view, 4>{"and", "or", "not", "has"},
                             [word](std::string_view keyword) { return is_keyword(word, keyword); });
}

}  // namespace

std::expected<Where::Parsed, Error> WhereParser::parse() {
  if (const Result root = any_of(0); !root) return std::unexpected(root.error());
  skip_blanks();
  if (at_ != text_.size()) return wrong("expected 'and', 'or' or the end");
  return std::move(parsed_);
}

WhereParser::Result WhereParser::any_of(std::size_t depth) { return chain(Node::Kind::any_of, "or", "||", depth); }

WhereParser::Result WhereParser::all_of(std::size_t depth) { return chain(Node::Kind::all_of, "and", "&&", depth); }

WhereParser::Result WhereParser::chain(Node::Kind kind, std::string_view joining, std::string_view sign,
                                       std::size_t depth) {
  const auto operand = [&] { return kind == Node::Kind::any_of ? all_of(depth) : unary(depth); };
  const std::size_t first = parsed_.nodes.size();
  Node node{.kind = kind};
  do {
    if (Result next = operand(); !next) return next;
    ++node.operands;
  } while (take_word(joining) || take_sign(sign));
  return node.operands == 1 ? Result() : add(node, first);
}

WhereParser::Result WhereParser::unary(std::size_t depth) {
  skip_blanks();
  const std::size_t begin = at_;
  const auto deeper = [&]() -> std::expected<std::size_t, Error> {
    if (depth >= max_where_depth) return wrong("nested deeper than 32 levels", begin);
    return depth + 1;
  };
  if (take_word("not") || (!text_.substr(at_).starts_with("!=") && take_sign("!"))) {
    const auto level = deeper();
    if (!level) return std::unexpected(level.error());
    const std::size_t first = parsed_.nodes.size();
    Result negated = unary(*level);
    if (negated && parsed_.nodes.back().kind == Node::Kind::negation) {
      parsed_.nodes.pop_back();  // two negations cancel out, so a run of them from the air costs no memory
      return negated;
    }
    return negated ? add(Node{.kind = Node::Kind::negation, .operands = 1}, first) : negated;
  }
  if (take_sign("(")) {
    const auto level = deeper();
    if (!level) return std::unexpected(level.error());
    Result inner = any_of(*level);
    if (inner && !take_sign(")")) return wrong("expected ')'");
    return inner;
  }
  return take_word("has") ? has() : comparison();
}

WhereParser::Result WhereParser::has() {
  const auto name = key("expected a key after 'has'");
  if (!name) return std::unexpected(name.error());
  return add(Node{.kind = Node::Kind::has, .key = *name}, parsed_.nodes.size());
}

WhereParser::Result WhereParser::comparison() {
  const auto name = key("expected a key, 'has', 'not' or '('");
  if (!name) return std::unexpected(name.error());
  if (auto read = set_or_pattern(*name)) return std::move(*read);
  const auto sign = operation();
  if (!sign) return std::unexpected(sign.error());
  const bool is_ordered = *sign != Where::Operator::equal && *sign != Where::Operator::different;
  const auto value = literal(is_ordered);
  if (!value) return std::unexpected(value.error());
  return compare(*name, *sign, *value);
}

WhereParser::Result WhereParser::compare(Where::Slice key, Where::Operator operation, const Literal& value) {
  return add(Node{.kind = Node::Kind::comparison,
                  .operation = operation,
                  .wanted = value.wanted,
                  .key = key,
                  .value = value.text},
             parsed_.nodes.size());
}

std::optional<WhereParser::Result> WhereParser::set_or_pattern(Where::Slice key) {
  if (take_word("in")) return set(key, false);
  if (take_word("not")) return take_word("in") ? set(key, true) : Result(wrong("expected 'in' after 'not'"));
  if (!take_word("like")) return std::nullopt;
  auto value = literal();
  if (!value) return Result(std::unexpected(value.error()));
  value->wanted = Where::Wanted::pattern;
  return compare(key, Where::Operator::equal, *value);
}

WhereParser::Result WhereParser::set(Where::Slice key, bool is_none_of) {
  if (!take_sign("(")) return wrong("expected '(' after 'in'");
  const std::size_t first = parsed_.nodes.size();
  Node node{.kind = is_none_of ? Node::Kind::all_of : Node::Kind::any_of};
  do {
    const auto value = literal();
    if (!value) return std::unexpected(value.error());
    const auto operation = is_none_of ? Where::Operator::different : Where::Operator::equal;
    if (Result one = compare(key, operation, *value); !one) return one;
    ++node.operands;
  } while (take_sign(","));
  if (!take_sign(")")) return wrong("expected ',' or ')'");
  return node.operands == 1 ? Result() : add(node, first);
}

std::expected<Where::Slice, Error> WhereParser::key(std::string_view wanted) {
  skip_blanks();
  const std::string_view name = word();
  if (name.empty() || is_reserved(name)) return wrong(wanted);
  const auto odd = std::ranges::find_if_not(name, base::is_key_octet);
  if (odd != name.end()) {
    return wrong("a key has only letters, digits, '_', '.' and '-'",
                 at_ + static_cast<std::size_t>(odd - name.begin()));
  }
  at_ += name.size();
  return keep(name);
}

std::expected<Where::Operator, Error> WhereParser::operation() {
  using enum Where::Operator;
  // Longer signs first, so that `<=` is not read as `<`.
  constexpr std::array<std::pair<std::string_view, Where::Operator>, 7> signs{
      {{"==", equal}, {"!=", different}, {"<=", at_most}, {">=", at_least}, {"=", equal}, {"<", less}, {">", greater}}};
  for (const auto& [sign, meaning] : signs) {
    if (take_sign(sign)) return meaning;
  }
  return wrong("expected =, !=, <, <=, >, >=, in, not in or like");
}

std::expected<WhereParser::Literal, Error> WhereParser::literal(bool is_ordered) {
  skip_blanks();
  if (at_ < text_.size() && (text_[at_] == '"' || text_[at_] == '\'')) return quoted();
  const std::string_view bare = run_of(text_.substr(at_), is_pattern_octet);
  if (bare.empty() || is_reserved(bare)) return wrong("expected a number, a word or a quoted text");
  if (number_length(bare) == bare.size()) return numeric(bare);
  const bool is_pattern = bare.contains('*');
  if (is_ordered && is_pattern) return wrong("a pattern is neither less nor greater: quote it to compare it as a text");
  // As a text it would be compared by its digits, which nobody means.
  if (is_ordered && quantity(run_of(text_.substr(at_), is_unit_octet), declared_ ? *declared_ : vocabulary::Units())) {
    return wrong("write a blank between number and unit, or quote it to compare it as a text");
  }
  at_ += bare.size();
  return Literal{keep(bare), is_pattern ? Where::Wanted::pattern : Where::Wanted::text};
}

std::expected<WhereParser::Literal, Error> WhereParser::numeric(std::string_view digits) {
  if (!number(digits)) return wrong("this number is out of range: quote it to compare it as a text");
  const std::size_t begin = at_;
  at_ += digits.size();
  const std::size_t end = at_;
  skip_blanks();
  const std::string_view sign = unit_word();
  if (sign.empty() || is_reserved(sign)) {
    at_ = end;
    return Literal{keep(digits), Where::Wanted::number};
  }
  const std::string written = std::string(digits) + ' ' + std::string(sign);
  const bool is_of_table = unit(sign).has_value();
  const vocabulary::Units undeclared;
  const vocabulary::Units& declared = declared_ ? *declared_ : undeclared;
  if (declared_ && !unit(sign, declared)) return wrong_unit(sign);
  if ((declared_ || is_of_table) && !quantity(written, declared)) return wrong("this number is out of range", begin);
  parsed_.has_declared_unit = parsed_.has_declared_unit || !is_of_table;
  at_ += sign.size();
  return Literal{keep(written), Where::Wanted::quantity};
}

std::string_view WhereParser::unit_word() const {
  const std::string_view rest = text_.substr(at_);
  // An IRI may have any octets but these between its brackets.
  const std::size_t end = rest.starts_with('<') ? rest.find_first_of(" \t\r\n>'\"", 1) : std::string_view::npos;
  return end != std::string_view::npos && rest[end] == '>' ? rest.substr(0, end + 1) : run_of(rest, is_unit_octet);
}

std::unexpected<Error> WhereParser::wrong_unit(std::string_view sign) const {
  auto error = wrong("expected 'and', 'or', the end or a unit that is known");
  if (!suggests_) return error;
  std::string meant = similar_unit(sign);
  if (meant.empty()) meant = declared_->similar_symbol(sign);
  const std::string help =
      meant.empty() ? std::string(known_units) : "did you mean " + base::printable(meant, max_unit_octets) + "?";
  return std::unexpected(Error{error.error().code, error.error().text + ": " + help});
}

std::expected<WhereParser::Literal, Error> WhereParser::quoted() {
  const std::size_t begin = at_;
  const char quote = text_[at_++];
  std::string read;
  while (at_ < text_.size() && text_[at_] != quote) {
    if (text_[at_] == '\\') {
      ++at_;
      if (at_ == text_.size()) break;
      if (text_[at_] != '\\' && text_[at_] != '"' && text_[at_] != '\'')
        return wrong("only \\\\, \\\" and \\' are escapes");
    }
    read += text_[at_++];
  }
  if (at_ >= text_.size()) return wrong("this text has no closing quote", begin);
  ++at_;
  if (!base::is_valid_utf8(read)) return wrong("this text is no UTF-8", begin);
  return Literal{keep(read), Where::Wanted::text};
}

WhereParser::Result WhereParser::add(Node node, std::size_t first) {
  node.first = static_cast<std::uint16_t>(first);
  parsed_.nodes.push_back(node);
  return {};
}

Where::Slice WhereParser::keep(std::string_view text) {
  const Where::Slice slice{static_cast<std::uint16_t>(parsed_.texts.size()), static_cast<std::uint16_t>(text.size())};
  parsed_.texts += text;
  return slice;
}

void WhereParser::skip_blanks() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
}

std::string_view WhereParser::word() const { return run_of(text_.substr(at_), is_word_octet); }

bool WhereParser::take_word(std::string_view wanted) {
  skip_blanks();
  if (!is_keyword(word(), wanted)) return false;
  at_ += wanted.size();
  return true;
}

bool WhereParser::take_sign(std::string_view wanted) {
  skip_blanks();
  if (!text_.substr(at_).starts_with(wanted)) return false;
  at_ += wanted.size();
  return true;
}

std::unexpected<Error> WhereParser::wrong(std::string_view what, std::size_t at) const {
  return std::unexpected(Error{ErrorCode::impossible, std::string(parse_error_prefix) + std::string(what) +
                                                          " at octet " + std::to_string(at + 1)});
}

}  // namespace geminga::matching
