// One octet at a time (RDF 1.1 Turtle, section 6.5; OWL 2 functional-style syntax, section 2; XML 1.0, section 2.4).
#include "reasoning/syntax/long_text.hpp"

#include <array>

namespace geminga::syntax {
namespace {

/// A name ends at a character that no syntax allows in names. Some syntaxes allow even fewer, which does not matter
/// here.
constexpr std::array<bool, 256> ends_name = [] {
  std::array<bool, 256> ends{};
  for (const char c : std::string_view(" \t\r\n#<>\"'()[];,")) ends[static_cast<unsigned char>(c)] = true;
  return ends;
}();

}  // namespace

std::optional<std::uint32_t> LongText::look_at(std::string_view stretch) {
  for (const char c : stretch) {
    if (is_xml_) {
      step_xml(c);
    } else {
      step(c);
    }
    if (c == '\n') ++line_;
    if (text_bytes_ > limits_.text) return found(Kind::text, begin_);
    if (blank_bytes_ > limits_.blank) return found(Kind::blank, blank_begin_);
    if (name_bytes_ > limits_.name) return found(Kind::name, line_);
    if (comment_bytes_ > limits_.xml_comment) return found(Kind::xml_comment, begin_);
  }
  return std::nullopt;
}

void LongText::begin_text(Within within) {
  within_ = within;
  text_bytes_ = 0;
  begin_ = line_;
}

void LongText::note_blank(bool is_blank) {
  if (blank_bytes_ == 0) blank_begin_ = line_;
  blank_bytes_ = is_blank ? blank_bytes_ + 1 : 0;
}

void LongText::note_name(bool is_name) { name_bytes_ = is_name ? name_bytes_ + 1 : 0; }

void LongText::step(char c) {
  switch (within_) {
    case Within::nothing:
      note_name(!ends_name[static_cast<unsigned char>(c)]);
      // An escaped mark belongs to a name, as in ex:O\'Brien. No name contains a quotation mark.
      if (is_escaped_ && c != '"') {
        is_escaped_ = false;
        return;
      }
      is_escaped_ = c == '\\';
      note_blank(c == '#' || c == ' ' || c == '\t' || c == '\r' || c == '\n');
      // Two quotation marks are an empty text, and three the begin of a long one.
      if (quotes_ == 2 && c == quote_) return begin_text(Within::long_text);
      quotes_ = 0;
      if (c == '"' || c == '\'') {
        quote_ = c;
        quotes_ = 1;
        begin_text(Within::text);
      } else if (c == '<') {
        within_ = Within::iri;
      } else if (c == '#') {
        within_ = Within::comment;
      }
      return;
    case Within::iri:
      note_name(c != '>');
      if (c == '>' || c == '\n' || c == ' ') {
        within_ = Within::nothing;
        name_bytes_ = 0;
      }
      return;
    case Within::comment:
      note_blank(true);
      if (c == '\n') within_ = Within::nothing;
      return;
    case Within::text:
    case Within::long_text:
      break;
  }
  ++text_bytes_;
  if (is_escaped_ || c == '\\') {
    is_escaped_ = !is_escaped_;
    quotes_ = 0;
  } else if (c != quote_) {
    quotes_ = 0;
  } else if (within_ == Within::text || ++quotes_ == 3) {
    quotes_ = within_ == Within::text && text_bytes_ == 1 ? 2 : 0;
    within_ = Within::nothing;
    text_bytes_ = 0;
  }
}

/// Markup inside a text, such as CDATA, ends its count.
void LongText::step_xml(char c) {
  last_ = last_ << 8U | static_cast<unsigned char>(c);
  constexpr std::uint32_t opened = '<' << 24U | '!' << 16U | '-' << 8U | '-';
  constexpr std::uint32_t closed = '-' << 16U | '-' << 8U | '>';
  if (within_ == Within::comment) {
    ++comment_bytes_;
    if ((last_ & 0xffffffU) == closed) begin_text(Within::nothing);
  } else if (last_ == opened) {
    begin_text(Within::comment);
    comment_bytes_ = 0;
  } else if (c == '<' || c == '>') {
    begin_text(Within::nothing);
  } else {
    ++text_bytes_;
  }
}

}  // namespace geminga::syntax
