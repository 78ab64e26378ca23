// Runs of octets, and one octet at a time where something begins or ends (RDF 1.1 Turtle, section 6.5; OWL 2
// functional-style syntax, section 2; XML 1.0, section 2.4).
#include "reasoning/syntax/long_text.hpp"

#include <algorithm>
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

constexpr std::string_view comment_begin = "<!--";

std::uint32_t line_ends_in(std::string_view stretch) {
  std::uint32_t ends = 0;
  for (std::size_t at = stretch.find('\n'); at != std::string_view::npos; at = stretch.find('\n', at + 1)) ++ends;
  return ends;
}

}  // namespace

std::optional<std::uint32_t> LongText::look_at(std::string_view stretch) {
  return is_xml_ ? look_at_xml(stretch) : look_at_words(stretch);
}

std::optional<std::uint32_t> LongText::look_at_words(std::string_view stretch) {
  while (!stretch.empty()) {
    const std::size_t run = run_in(stretch);
    if (run > 0) {
      take_run(stretch.substr(0, run));
    } else {
      step(stretch.front());
      if (stretch.front() == '\n') ++line_;
    }
    stretch.remove_prefix(std::max<std::size_t>(run, 1));
    if (text_bytes_ > limits_.text) return found(Kind::text, begin_);
    if (blank_bytes_ > limits_.blank) return found(Kind::blank, blank_begin_);
    if (name_bytes_ > limits_.name) return found(Kind::name, line_);
  }
  return std::nullopt;
}

void LongText::begin_text(Within within) {
  within_ = within;
  text_bytes_ = 0;
  begin_ = line_;
}

void LongText::note_blank(std::size_t blanks) {
  if (blank_bytes_ == 0) blank_begin_ = line_;
  blank_bytes_ = blanks == 0 ? 0 : blank_bytes_ + blanks;
}

std::size_t LongText::run_in(std::string_view stretch) const {
  if (is_escaped_) return 0;
  const auto until = [&](auto&& ends) {
    return static_cast<std::size_t>(std::ranges::find_if(stretch, ends) - stretch.begin());
  };
  switch (within_) {
    case Within::nothing:
      if (stretch.starts_with(' ')) return until([](char c) { return c != ' '; });
      return until([](char c) { return c == '\\' || ends_name[static_cast<unsigned char>(c)]; });
    case Within::iri:
      return until([](char c) { return c == '>' || c == '\n' || c == ' '; });
    case Within::comment:
      return std::min(stretch.find('\n'), stretch.size());
    case Within::text:
    case Within::long_text:
      break;
  }
  return until([&](char c) { return c == '\\' || c == quote_; });
}

void LongText::take_run(std::string_view run) {
  switch (within_) {
    case Within::nothing: {
      const bool is_blank = run.front() == ' ';
      note_blank(is_blank ? run.size() : 0);
      name_bytes_ = is_blank ? 0 : name_bytes_ + run.size();
      quotes_ = 0;
      return;
    }
    case Within::iri:
      name_bytes_ += run.size();
      return;
    case Within::comment:
      return note_blank(run.size());
    case Within::text:
    case Within::long_text:
      break;
  }
  quotes_ = 0;
  text_bytes_ += run.size();
  line_ += line_ends_in(run);
}

void LongText::step(char c) {
  switch (within_) {
    case Within::nothing:
      name_bytes_ = ends_name[static_cast<unsigned char>(c)] ? 0 : name_bytes_ + 1;
      // An escaped mark belongs to a name, as in ex:O\'Brien. No name contains a quotation mark.
      if (is_escaped_ && c != '"') {
        is_escaped_ = false;
        return;
      }
      is_escaped_ = c == '\\';
      note_blank(c == '#' || c == ' ' || c == '\t' || c == '\r' || c == '\n' ? 1 : 0);
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
      within_ = Within::nothing;
      name_bytes_ = 0;
      return;
    case Within::comment:
      note_blank(1);
      within_ = Within::nothing;
      return;
    case Within::text:
    case Within::long_text:
      break;
  }
  ++text_bytes_;
  if (is_escaped_ || c == '\\') {
    is_escaped_ = !is_escaped_;
    quotes_ = 0;
  } else if (within_ == Within::text || ++quotes_ == 3) {
    quotes_ = within_ == Within::text && text_bytes_ == 1 ? 2 : 0;
    within_ = Within::nothing;
    text_bytes_ = 0;
  }
}

/// Markup inside a text, such as CDATA, ends its count.
std::optional<std::uint32_t> LongText::look_at_xml(std::string_view stretch) {
  constexpr std::size_t none = std::string_view::npos;
  std::size_t begin = none;  // of the text or comment, if it begins in this stretch
  std::size_t open = stretch.find('<');
  std::size_t close = stretch.find('>');
  std::size_t at = 0;
  while (at < stretch.size()) {
    if (within_ == Within::comment) {
      at = step_comment(stretch, at);
      if (comment_bytes_ > limits_.xml_comment) break;
      if (within_ == Within::nothing) begin = at - 1;
      continue;
    }
    if (opened_ > 0 && stretch[at] == comment_begin[opened_]) {
      ++at;
      ++text_bytes_;
      if (++opened_ < comment_begin.size()) continue;
      begin_comment();
      continue;
    }
    opened_ = 0;
    if (open < at) open = stretch.find('<', at);
    if (close < at) close = stretch.find('>', at);
    const std::size_t mark = std::min({open, close, stretch.size()});
    text_bytes_ += mark - at;
    at = mark;
    if (at == stretch.size() || text_bytes_ > limits_.text) break;
    opened_ = at == open ? 1 : 0;
    text_bytes_ = 0;
    begin = at++;
  }
  if (begin != none) begin_ = line_ + line_ends_in(stretch.substr(0, begin));
  line_ += line_ends_in(stretch);
  if (text_bytes_ > limits_.text) return found(Kind::text, begin_);
  if (comment_bytes_ > limits_.xml_comment) return found(Kind::xml_comment, begin_);
  return std::nullopt;
}

void LongText::begin_comment() {
  within_ = Within::comment;
  opened_ = 0;
  text_bytes_ = 0;
  comment_bytes_ = 0;
  dashes_ = 2;
}

std::size_t LongText::step_comment(std::string_view stretch, std::size_t at) {
  const std::string_view part = stretch.substr(at, std::min(stretch.find('>', at), stretch.size()) - at);
  const std::size_t other = part.find_last_not_of('-');
  dashes_ = other == std::string_view::npos ? dashes_ + part.size() : part.size() - other - 1;
  comment_bytes_ += part.size();
  at += part.size();
  if (at == stretch.size()) return at;
  if (dashes_ >= 2) within_ = Within::nothing;
  dashes_ = 0;
  ++comment_bytes_;
  return at + 1;
}

}  // namespace geminga::syntax
