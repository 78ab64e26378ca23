// The reader of `where` expressions.
#include "matching/where_parser.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/text.hpp"

namespace geminga::matching {
namespace {

using Node = Where::Node;

bool is_blank(char octet) { return octet == ' ' || octet == '\t' || octet == '\r' || octet == '\n'; }

bool is_key_octet(char octet) {
  return (octet >= 'a' && octet <= 'z') || (octet >= 'A' && octet <= 'Z') || (octet >= '0' && octet <= '9') ||
         octet == '_' || octet == '.' || octet == '-';
}

bool is_word_octet(char octet) { return is_key_octet(octet) || octet == ':' || octet == '/' || octet == '+'; }

bool is_digit(char octet) { return octet >= '0' && octet <= '9'; }

char lower(char octet) { return octet >= 'A' && octet <= 'Z' ? static_cast<char>(octet - 'A' + 'a') : octet; }

/// The words of the language have no case; keys and texts do.
bool is_keyword(std::string_view word, std::string_view keyword) {
  return std::ranges::equal(word, keyword, {}, lower);
}

bool is_reserved(std::string_view word) {
  return std::ranges::any_of(std::array<std::string_view, 4>{"and", "or", "not", "has"},
                             [word](std::string_view keyword) { return is_keyword(word, keyword); });
}

}  // namespace

bool is_number(std::string_view text) {
  std::string_view digits = text;
  if (!digits.empty() && (digits.front() == '-' || digits.front() == '+')) digits.remove_prefix(1);
  if (digits.empty() || !is_digit(digits.front())) return false;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return error == std::errc() && end == digits.data() + digits.size() && std::isfinite(value);
}

std::expected<std::vector<Node>, Error> WhereParser::parse() {
  const Result root = any_of(0);
  if (!root) return std::unexpected(root.error());
  skip_blanks();
  if (at_ != text_.size()) return wrong("expected 'and', 'or' or the end");
  return std::move(nodes_);
}

WhereParser::Result WhereParser::any_of(std::size_t depth) { return chain(Node::Kind::any_of, "or", "||", depth); }

WhereParser::Result WhereParser::all_of(std::size_t depth) { return chain(Node::Kind::all_of, "and", "&&", depth); }

WhereParser::Result WhereParser::chain(Node::Kind kind, std::string_view joining, std::string_view sign,
                                       std::size_t depth) {
  const auto operand = [&] { return kind == Node::Kind::any_of ? all_of(depth) : unary(depth); };
  Node node{kind, {}, {}, {}, {}};
  do {
    const Result next = operand();
    if (!next) return next;
    node.children.push_back(*next);
  } while (take_word(joining) || take_sign(sign));
  return node.children.size() == 1 ? Result(node.children.front()) : add(std::move(node));
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
    const Result negated = unary(*level);
    return negated ? add(Node{Node::Kind::negation, {*negated}, {}, {}, {}}) : negated;
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
  auto name = key("expected a key after 'has'");
  if (!name) return std::unexpected(name.error());
  return add(Node{Node::Kind::has, {}, std::move(*name), {}, {}});
}

WhereParser::Result WhereParser::comparison() {
  auto name = key("expected a key, 'has', 'not' or '('");
  if (!name) return std::unexpected(name.error());
  const auto sign = operation();
  if (!sign) return std::unexpected(sign.error());
  auto value = literal();
  if (!value) return std::unexpected(value.error());
  return add(Node{Node::Kind::comparison, {}, std::move(*name), *sign, std::move(*value)});
}

std::expected<std::string, Error> WhereParser::key(std::string_view wanted) {
  skip_blanks();
  const std::string_view name = word();
  if (name.empty() || is_reserved(name)) return wrong(wanted);
  const auto odd = std::ranges::find_if_not(name, is_key_octet);
  if (odd != name.end()) {
    return wrong("a key has only letters, digits, '_', '.' and '-'",
                 at_ + static_cast<std::size_t>(odd - name.begin()));
  }
  at_ += name.size();
  return std::string(name);
}

std::expected<Where::Operator, Error> WhereParser::operation() {
  using enum Where::Operator;
  // Longer signs first, so that `<=` is not read as `<`.
  constexpr std::array<std::pair<std::string_view, Where::Operator>, 7> signs{
      {{"==", equal}, {"!=", different}, {"<=", at_most}, {">=", at_least}, {"=", equal}, {"<", less}, {">", greater}}};
  for (const auto& [sign, meaning] : signs) {
    if (take_sign(sign)) return meaning;
  }
  return wrong("expected =, !=, <, <=, > or >=");
}

std::expected<Where::Literal, Error> WhereParser::literal() {
  skip_blanks();
  if (at_ < text_.size() && (text_[at_] == '"' || text_[at_] == '\'')) return quoted();
  const std::string_view bare = word();
  if (bare.empty() || is_reserved(bare)) return wrong("expected a number, a word or a quoted text");
  at_ += bare.size();
  return Where::Literal{std::string(bare), is_number(bare)};
}

std::expected<Where::Literal, Error> WhereParser::quoted() {
  const std::size_t begin = at_;
  const char quote = text_[at_++];
  Where::Literal read;
  while (at_ < text_.size() && text_[at_] != quote) {
    if (text_[at_] == '\\') {
      ++at_;
      if (at_ == text_.size()) break;
      if (text_[at_] != '\\' && text_[at_] != '"' && text_[at_] != '\'')
        return wrong("only \\\\, \\\" and \\' are escapes");
    }
    read.text += text_[at_++];
  }
  if (at_ >= text_.size()) return wrong("this text has no closing quote", begin);
  ++at_;
  if (!base::is_valid_utf8(read.text)) return wrong("this text is no UTF-8", begin);
  return read;
}

WhereParser::Result WhereParser::add(Node node) {
  nodes_.push_back(std::move(node));
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

void WhereParser::skip_blanks() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
}

std::string_view WhereParser::word() const {
  const std::string_view rest = text_.substr(at_);
  const auto end = std::ranges::find_if_not(rest, is_word_octet);
  return rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
}

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
  return std::unexpected(
      Error{ErrorCode::impossible, "where: " + std::string(what) + " at octet " + std::to_string(at + 1)});
}

}  // namespace geminga::matching
