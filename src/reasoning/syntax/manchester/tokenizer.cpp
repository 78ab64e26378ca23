// The terminal symbols of MANCHESTER.md.
#include "reasoning/syntax/manchester/tokenizer.hpp"

#include <algorithm>
#include <array>

#include "base/utf8.hpp"

namespace geminga::manchester {
namespace {

constexpr std::string_view blanks = " \t\r\n";
constexpr std::string_view ends_of_words = " \t\r\n(){}[],<>\"'^@=";
constexpr std::string_view not_in_iris = " \t\r\n<>\"{}|\\^`";
constexpr std::array<std::string_view, 14> keywords{"and",  "or",  "not", "that",    "some",    "only", "value",
                                                    "Self", "min", "max", "exactly", "inverse", "true", "false"};
constexpr std::array<std::string_view, 5> facet_words{"length", "minLength", "maxLength", "pattern", "langRange"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

template <typename Words>
bool is_one_of(const Words& words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

/// [sign] digits [. digits] [e [sign] digits] [f], with at least one digit before or behind the point.
bool is_number(std::string_view word) {
  std::size_t at = 0;
  const auto digits = [&] {
    const std::size_t begin = at;
    while (at < word.size() && is_digit(word[at])) ++at;
    return at - begin;
  };
  const auto take = [&](std::string_view any) {
    if (at == word.size() || any.find(word[at]) == std::string_view::npos) return false;
    ++at;
    return true;
  };
  take("+-");
  std::size_t count = digits();
  if (take(".")) count += digits();
  if (count == 0) return false;
  if (take("eE")) {
    take("+-");
    if (digits() == 0) return false;
  }
  take("fF");
  return at == word.size();
}

}  // namespace

std::size_t Tokenizer::column_of(std::size_t octet) const { return 1 + base::count_characters(text_.substr(0, octet)); }

void Tokenizer::finish(TokenKind kind, std::size_t size) {
  token_.kind = kind;
  token_.text = text_.substr(token_.begin, size);
  place_ = token_.begin + size;
}

void Tokenizer::fail(std::size_t size, std::string what) {
  finish(TokenKind::bad, size);
  token_.value = std::move(what);
}

void Tokenizer::take_quoted(char quote, TokenKind kind) {
  for (std::size_t at = place_ + 1; at < text_.size(); ++at) {
    char character = text_[at];
    if (character == quote) return finish(kind, at + 1 - place_);
    if (character == '\\') {
      if (++at == text_.size()) break;
      character = text_[at];
      if (character != '\\' && character != quote) {
        if (!is_document_) return fail(1, "a backslash stands before a quote or a backslash only");
        if (!odd_backslash_) odd_backslash_ = at - 1;
        token_.value += '\\';
      }
    }
    token_.value += character;
  }
  fail(1, std::string("a text that begins with ") + quote + " does not end");
}

void Tokenizer::take_iri() {
  const std::size_t end = text_.find_first_of(not_in_iris, place_ + 1);
  if (end == std::string_view::npos || text_[end] != '>' || end == place_ + 1) {
    return fail(1, "an IRI that begins with < does not end with >");
  }
  finish(TokenKind::name, end + 1 - place_);
}

void Tokenizer::take_word() {
  const std::size_t end = std::min(text_.find_first_of(ends_of_words, place_), text_.size());
  const std::string_view word = text_.substr(place_, end - place_);
  TokenKind kind = TokenKind::name;
  if (is_one_of(keywords, word)) kind = TokenKind::keyword;
  if (is_number(word)) kind = TokenKind::number;
  if (are_facets_ && is_one_of(facet_words, word)) kind = TokenKind::facet;
  if (is_document_ && word.ends_with(':') && std::ranges::binary_search(sections_, word)) kind = TokenKind::section;
  finish(kind, word.size());
}

void Tokenizer::skip_comments() {
  while (place_ < text_.size() && text_[place_] == '#') {
    place_ = std::min(text_.find_first_of("\r\n", place_), text_.size());
    place_ = std::min(text_.find_first_not_of(blanks, place_), text_.size());
  }
}

void Tokenizer::advance() {
  place_ = std::min(text_.find_first_not_of(blanks, place_), text_.size());
  if (is_document_) skip_comments();
  token_ = {.kind = TokenKind::end, .text = {}, .value = {}, .begin = place_};
  if (place_ == text_.size()) return;
  const char first = text_[place_];
  if (static_cast<unsigned char>(first) < 0x20 || first == 0x7f) return fail(1, "a control character");
  if (std::string_view("(){}[],").find(first) != std::string_view::npos) return finish(TokenKind::symbol, 1);
  if (is_document_ && text_.substr(place_, 2) == "->") return finish(TokenKind::symbol, 2);
  const bool has_equals = place_ + 1 < text_.size() && text_[place_ + 1] == '=';
  if (are_facets_ && (first == '<' || first == '>')) return finish(TokenKind::facet, has_equals ? 2 : 1);
  switch (first) {
    case '"':
      return take_quoted('"', TokenKind::string);
    case '\'':
      return take_quoted('\'', TokenKind::label);
    case '<':
      return take_iri();
    case '^':
      if (text_.substr(place_, 2) == "^^") return finish(TokenKind::carets, 2);
      return fail(1, "a lone ^");
    case '@': {
      const std::size_t end = std::min(text_.find_first_of(ends_of_words, place_ + 1), text_.size());
      token_.value = text_.substr(place_ + 1, end - place_ - 1);
      return finish(TokenKind::language, end - place_);
    }
    case '>':
    case '=':
      return fail(1, std::string("a ") + first + " outside of square brackets");
    default:
      return take_word();
  }
}

}  // namespace geminga::manchester
