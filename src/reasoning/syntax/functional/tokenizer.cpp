#include "reasoning/syntax/functional/tokenizer.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "base/text.hpp"
#include "base/utf8.hpp"

namespace geminga::functional {
namespace {

constexpr std::uint8_t name_byte = 1;   ///< of words, prefixes, local names and blank nodes
constexpr std::uint8_t iri_byte = 2;    ///< between angle brackets
constexpr std::uint8_t blank_byte = 4;  ///< white space
constexpr std::uint8_t digit_byte = 8;
constexpr std::uint8_t letter_byte = 16;
constexpr std::uint8_t hex_byte = 32;
constexpr std::uint8_t escapable_byte = 64;  ///< behind a backslash in a local name (SPARQL 1.1, PN_LOCAL_ESC)

constexpr std::array<std::uint8_t, 256> make_classes() {
  std::array<std::uint8_t, 256> classes{};
  for (unsigned byte = 0x21; byte < 256; ++byte) {
    if (byte != '<' && byte != '>' && byte != 0x7f) classes[byte] |= iri_byte;
  }
  for (unsigned byte = 'a'; byte <= 'z'; ++byte) classes[byte] |= name_byte | letter_byte;
  for (unsigned byte = 'A'; byte <= 'Z'; ++byte) classes[byte] |= name_byte | letter_byte;
  for (unsigned byte = '0'; byte <= '9'; ++byte) classes[byte] |= name_byte | digit_byte | hex_byte;
  for (const char c : std::string_view("abcdefABCDEF")) classes[static_cast<unsigned char>(c)] |= hex_byte;
  for (const char c : std::string_view("_-.")) classes[static_cast<unsigned char>(c)] |= name_byte;
  for (const char c : std::string_view(" \t\r\n")) classes[static_cast<unsigned char>(c)] |= blank_byte;
  for (const char c : std::string_view("_~.-!$&'()*+,;=/?#@%"))
    classes[static_cast<unsigned char>(c)] |= escapable_byte;
  return classes;
}
constexpr std::array<std::uint8_t, 256> classes = make_classes();

bool is_a(char c, std::uint8_t wanted) { return (classes[static_cast<unsigned char>(c)] & wanted) != 0; }

/// Whether a character beyond ASCII may stand in a name (SPARQL, PN_CHARS). A no-break space may not.
bool is_name_character(char32_t c) {
  struct Range {
    char32_t first, last;
  };
  static constexpr std::array<Range, 14> ranges{{{0xb7, 0xb7},
                                                 {0xc0, 0xd6},
                                                 {0xd8, 0xf6},
                                                 {0xf8, 0x2ff},
                                                 {0x300, 0x37d},
                                                 {0x37f, 0x1fff},
                                                 {0x200c, 0x200d},
                                                 {0x203f, 0x2040},
                                                 {0x2070, 0x218f},
                                                 {0x2c00, 0x2fef},
                                                 {0x3001, 0xd7ff},
                                                 {0xf900, 0xfdcf},
                                                 {0xfdf0, 0xfffd},
                                                 {0x10000, 0xeffff}}};
  return std::ranges::any_of(ranges, [c](const Range& range) { return c >= range.first && c <= range.last; });
}

std::string_view between(const char* begin, const char* end) { return {begin, static_cast<std::size_t>(end - begin)}; }

const char* find_byte(const char* begin, const char* end, char byte) {
  return static_cast<const char*>(std::memchr(begin, byte, static_cast<std::size_t>(end - begin)));
}

std::string limit_text(std::string_view what, std::size_t limit) {
  return std::string(what) + " of more than " + std::to_string(limit) + " bytes";
}

}  // namespace

std::optional<Problem> check_text(std::string_view bytes) {
  const auto line_of = [&](std::size_t place) {
    return 1 + static_cast<std::uint32_t>(std::ranges::count(bytes.substr(0, place), '\n'));
  };
  if (const std::size_t nul = bytes.find('\0'); nul != std::string_view::npos)
    return Problem{line_of(nul), "a NUL byte"};
  if (const auto place = base::find_invalid_utf8(bytes))
    return Problem{line_of(*place), "bytes that are no UTF-8: save the file as UTF-8"};
  return std::nullopt;
}

void append_unescaped(std::string& to, std::string_view name) {
  while (!name.empty()) {
    const std::size_t escape = std::min(name.find('\\'), name.size());
    to.append(name.substr(0, escape));
    if (escape + 1 >= name.size()) return;
    to.push_back(name[escape + 1]);
    name.remove_prefix(escape + 2);
  }
}

bool append_unescaped_text(std::string& to, std::string_view text) {
  bool has_other = false;
  while (!text.empty()) {
    const std::size_t escape = std::min(text.find('\\'), text.size());
    to.append(text.substr(0, escape));
    if (escape + 1 >= text.size()) break;
    const char next = text[escape + 1];
    if (next != '"' && next != '\\') {
      has_other = true;
      to.push_back('\\');
    }
    to.push_back(next);
    text.remove_prefix(escape + 2);
  }
  return has_other;
}

Tokenizer::Tokenizer(std::string_view text, const FunctionalLimits& limits)
    : limits_(limits),
      end_(text.data() + text.size()),
      place_(text.data()),
      token_begin_(text.data()),
      counted_(text.data()) {
  advance();
}

std::uint32_t Tokenizer::line_at(const char* place) {
  line_ += static_cast<std::uint32_t>(std::count(counted_, place, '\n'));
  counted_ = place;
  return line_;
}

std::uint32_t Tokenizer::line() { return line_at(token_begin_); }

void Tokenizer::go_back(const Place& place) {
  place_ = place.next;
  token_begin_ = place.begin;
  counted_ = place.counted;
  line_ = place.line;
  token_ = place.token;
  problem_.reset();
}

void Tokenizer::fail(std::string text) {
  if (!problem_) problem_ = Problem{line(), std::move(text)};
  token_ = Token{TokenKind::failed, false, 0, {}};
}

void Tokenizer::fail(Problem problem) {
  problem_ = std::move(problem);
  token_ = Token{TokenKind::failed, false, 0, {}};
}

void Tokenizer::finish(TokenKind kind, const char* begin, const char* end, const char* next) {
  token_.kind = kind;
  token_.text = between(begin, end);
  place_ = next;
}

void Tokenizer::skip_blanks() {
  for (;;) {
    while (place_ != end_ && is_a(*place_, blank_byte)) ++place_;
    if (place_ == end_ || *place_ != '#') return;
    while (place_ != end_ && *place_ != '\n' && *place_ != '\r') ++place_;
  }
}

void Tokenizer::advance() {
  if (token_.kind == TokenKind::failed) return;
  skip_blanks();
  token_begin_ = place_;
  token_.has_escapes = false;
  if (place_ == end_) return finish(TokenKind::end, end_, end_, end_);
  switch (*place_) {
    case '(':
      return finish(TokenKind::open, place_, place_ + 1, place_ + 1);
    case ')':
      return finish(TokenKind::close, place_, place_ + 1, place_ + 1);
    case '=':
      return finish(TokenKind::equals, place_, place_ + 1, place_ + 1);
    case '<':
      return take_iri();
    case '"':
      return take_string();
    case '@':
      return take_language();
    case '^':
      if (end_ - place_ < 2 || place_[1] != '^') return fail("a single '^'");
      return finish(TokenKind::carets, place_, place_ + 2, place_ + 2);
    case '_':
      if (end_ - place_ >= 2 && place_[1] == ':') return take_node_id();
      return take_name();
    default:
      return take_name();
  }
}

void Tokenizer::take_iri() {
  const char* begin = place_ + 1;
  const char* end = begin;
  while (end != end_ && is_a(*end, iri_byte)) ++end;
  if (static_cast<std::size_t>(end - begin) > limits_.iri_bytes) return fail(limit_text("an IRI", limits_.iri_bytes));
  if (end == end_) return fail("an IRI that is never closed by '>'");
  if (*end != '>')
    return fail("an IRI with a space, control character or '<' in it: <" + base::printable(between(begin, end), 60));
  finish(TokenKind::full_iri, begin, end, end + 1);
}

void Tokenizer::take_string() {
  const char* begin = place_ + 1;
  const char* end = find_byte(begin, end_, '"');
  std::size_t escapes = 0;
  bool has_escapes = false;
  if (end == nullptr) return fail("a text that is never closed by '\"'");
  if (find_byte(begin, end, '\\') != nullptr) {
    for (end = begin; end != end_ && *end != '"'; ++end) {
      if (*end != '\\') continue;
      if (++end == end_) break;
      if (*end == '"' || *end == '\\') ++escapes;
      has_escapes = true;
    }
    if (end == end_) return fail("a text that is never closed by '\"'");
  }
  if (static_cast<std::size_t>(end - begin) - escapes > limits_.literal_bytes)
    return fail(limit_text("a text", limits_.literal_bytes));
  token_.has_escapes = has_escapes;
  finish(TokenKind::string, begin, end, end + 1);
}

void Tokenizer::take_language() {
  // BCP 47's langtag as RDF writes it: a word of letters, then words of letters and digits.
  const char* begin = place_ + 1;
  const char* end = begin;
  bool is_first = true;
  for (;;) {
    const char* word = end;
    while (end != end_ && is_a(*end, is_first ? letter_byte : letter_byte | digit_byte)) ++end;
    if (word == end) return fail("a language tag that is none: @" + base::printable(between(begin, end), 60));
    if (end == end_ || *end != '-') break;
    is_first = false;
    ++end;
  }
  if (static_cast<std::size_t>(end - begin) > limits_.iri_bytes)
    return fail(limit_text("a language tag", limits_.iri_bytes));
  finish(TokenKind::language, begin, end, end);
}

const char* Tokenizer::end_of_run(const char* from) const {
  while (from != end_) {
    if (is_a(*from, name_byte)) {
      ++from;
    } else if (static_cast<unsigned char>(*from) >= 0x80 && is_name_character(base::character_at(from))) {
      from += base::character_bytes(static_cast<unsigned char>(*from));
    } else {
      break;
    }
  }
  return from;
}

void Tokenizer::take_node_id() {
  const char* begin = place_ + 2;
  const char* end = end_of_run(begin);
  if (begin == end) return fail("a blank node without a name behind '_:'");
  if (static_cast<std::size_t>(end - begin) > limits_.iri_bytes)
    return fail(limit_text("the name of a blank node", limits_.iri_bytes));
  finish(TokenKind::node_id, begin, end, end);
}

void Tokenizer::take_name() {
  const char* begin = place_;
  const char* end = end_of_run(begin);
  if (end != end_ && *end == ':') {
    token_.prefix_bytes = static_cast<std::uint32_t>(std::min<std::ptrdiff_t>(end - begin, 1L << 30));
    return take_local_name(end + 1);
  }
  if (begin == end) {
    const std::size_t count = base::character_bytes(static_cast<unsigned char>(*begin));
    return fail("unexpected '" + base::printable(between(begin, begin + count)) + "'");
  }
  if (static_cast<std::size_t>(end - begin) > limits_.iri_bytes) return fail(limit_text("a word", limits_.iri_bytes));
  const bool is_number = std::all_of(begin, end, [](char c) { return is_a(c, digit_byte); });
  finish(is_number ? TokenKind::number : TokenKind::word, begin, end, end);
}

void Tokenizer::take_local_name(const char* begin) {
  const char* end = begin;
  for (;;) {
    end = end_of_run(end);
    if (end == end_) break;
    if (*end == ':') {
      ++end;
    } else if (*end == '%' && end_ - end >= 3 && is_a(end[1], hex_byte) && is_a(end[2], hex_byte)) {
      end += 3;
    } else if (*end == '\\' && end_ - end >= 2 && is_a(end[1], escapable_byte)) {
      token_.has_escapes = true;
      end += 2;
    } else {
      break;
    }
  }
  if (static_cast<std::size_t>(end - place_) > limits_.iri_bytes) return fail(limit_text("a name", limits_.iri_bytes));
  finish(TokenKind::prefixed_name, place_, end, end);
}

}  // namespace geminga::functional
