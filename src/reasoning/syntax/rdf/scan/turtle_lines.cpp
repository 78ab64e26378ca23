// A stack of open brackets, each with the lines of its objects (RDF 1.1 Turtle, section 6.5).
#include "reasoning/syntax/rdf/scan/turtle_lines.hpp"

#include <algorithm>
#include <cctype>

namespace geminga::rdf {
namespace {

bool is_keyword(std::string_view text, std::string_view lower) {
  return std::ranges::equal(text, lower,
                            [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

}  // namespace

void TurtleLines::word(std::string_view text, std::uint32_t line) {
  const bool is_statement_start = frames_.size() == 1 && frames_.front().next == Part::subject;
  if (is_statement_start && (text == "@prefix" || is_keyword(text, "prefix"))) {
    directive_left_ = 2;
    ++prefix_count_;
    ++directive_count_;
  } else if (is_statement_start && (text == "@base" || is_keyword(text, "base"))) {
    directive_left_ = 1;
    is_base_next_ = true;
    ++directive_count_;
  } else if (text.starts_with('@')) {
    if (text.ends_with('.')) end_statement();  // the language of the literal before it
  } else {
    // A dot at the end of a word ends the statement; a dot alone is punctuation.
    const bool is_end = text.ends_with('.') && !text.ends_with("\\.");
    if (text != ".") term(line);
    if (is_end) end_statement();
  }
}

void TurtleLines::term(std::uint32_t line) {
  if (is_datatype_next_) {
    is_datatype_next_ = false;
    return;
  }
  if (directive_left_ > 0) {
    --directive_left_;
    is_base_next_ = false;
    return;
  }
  Frame& frame = frames_.back();
  if (frame.bracket == '(') {
    frame.objects.push_back(line);
    statement_triples_ += 2;
  } else if (frame.next == Part::subject) {
    frame.next = Part::verb;
  } else if (frame.next == Part::verb) {
    frame.next = Part::object;
  } else {
    frame.objects.push_back(line);
    ++statement_triples_;
  }
}

void TurtleLines::open(char bracket, std::uint32_t line) {
  Frame& frame = frames_.emplace_back();
  frame.bracket = bracket;
  frame.next = Part::verb;
  frame.line = line;
}

void TurtleLines::close(char bracket) {
  if (frames_.size() == 1 || frames_.back().bracket != (bracket == ']' ? '[' : '(')) return;
  const std::uint32_t line = frames_.back().line;
  flush(frames_.back());
  frames_.pop_back();
  is_datatype_next_ = false;
  term(line);
}

void TurtleLines::punctuation(char mark) {
  if (mark == '.') return end_statement();
  if (mark == ';' && frames_.back().next != Part::subject) frames_.back().next = Part::verb;
}

void TurtleLines::end_statement() {
  // A directive in SPARQL's style has no dot, but its IRI may be followed by one that belongs to nothing.
  directive_left_ = 0;
  is_base_next_ = false;
  is_datatype_next_ = false;
  frames_.resize(1);
  flush(frames_.front());
  frames_.front() = Frame{};
  statement_triples_ = 0;
}

void TurtleLines::flush(Frame& frame) {
  if (frame.bracket != '(') {
    lines_.insert(lines_.end(), frame.objects.begin(), frame.objects.end());
    return;
  }
  for (auto line = frame.objects.rbegin(); line != frame.objects.rend(); ++line)
    lines_.insert(lines_.end(), {*line, *line});  // rdf:first and rdf:rest
}

}  // namespace geminga::rdf
