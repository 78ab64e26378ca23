// Knows of a statement how many terms it has, and whether its first may name a graph.
#include "reasoning/syntax/rdf/scan/graph_marks.hpp"

#include <utility>

namespace geminga::rdf {
namespace {

GraphMark mark(std::size_t begin, std::size_t end, bool ends_statement = false) {
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - begin), ends_statement};
}

}  // namespace

std::string without_marks(std::string_view text, const std::vector<GraphMark>& marks) {
  std::string out;
  out.reserve(text.size() + 2 * marks.size());
  std::size_t copied = 0;
  for (const GraphMark& one : marks) {
    out += text.substr(copied, one.begin - copied);
    for (const char c : text.substr(one.begin, one.size)) out += c == '\n' || c == '\r' ? c : ' ';
    if (one.ends_statement) out += ". ";
    copied = std::size_t{one.begin} + one.size;
  }
  return out += text.substr(copied);
}

void GraphMarks::begin_term(std::size_t begin) {
  if (terms_ == 0 && !has_keyword_) begin_ = begin;
  ++terms_;
  is_name_ = false;
  opens_blank_ = false;
  is_datatype_next_ = false;
  is_behind_graph_ = false;
}

void GraphMarks::name(std::size_t begin, std::size_t end, bool is_of_quads) {
  if (!is_of_quads) has_only_quads_ = false;
  if (std::exchange(is_datatype_next_, false)) return;
  begin_term(begin);
  is_name_ = terms_ == 1;
  if (terms_ > 4) has_only_quads_ = false;
  if (terms_ == 4 && is_of_quads && (reads_quads_ || has_only_quads_)) quads_.push_back(mark(begin, end));
}

void GraphMarks::literal(std::size_t begin) {
  begin_term(begin);
  if (terms_ > 3) has_only_quads_ = false;
}

void GraphMarks::keyword(std::size_t begin) {
  if (terms_ != 0 || has_keyword_) return other(begin, 'g');
  begin_ = begin;
  has_keyword_ = true;
  is_behind_graph_ = false;
}

void GraphMarks::other(std::size_t begin, char first) {
  has_only_quads_ = false;
  if (first == ']' && opens_blank_) {  // [ ] names a graph
    is_name_ = true;
    opens_blank_ = false;
    return;
  }
  begin_term(begin);
  opens_blank_ = first == '[' && terms_ == 1;
}

void GraphMarks::dot(std::size_t place) {
  if (is_behind_graph_) misplaced(place);  // a formula of Notation 3
  end_statement();
}

void GraphMarks::directive() {
  has_only_quads_ = false;
  end_statement();
}

void GraphMarks::end_statement() {
  terms_ = 0;
  has_keyword_ = false;
  is_name_ = false;
  opens_blank_ = false;
  is_datatype_next_ = false;
  is_behind_graph_ = false;
}

void GraphMarks::misplaced(std::size_t place) {
  if (!misplaced_) misplaced_ = place;
}

void GraphMarks::open(std::size_t place, bool is_in_directive) {
  has_only_quads_ = false;
  const bool has_name = terms_ == 1 && is_name_;
  const bool has_none = terms_ == 0 && !has_keyword_;
  if (is_in_graph_ || is_in_directive || !(has_name || has_none)) return misplaced(place);
  marks_.push_back(mark(has_name ? begin_ : place, place + 1));
  ++graphs_;
  opened_ = place;
  end_statement();
  is_in_graph_ = true;
}

void GraphMarks::close(std::size_t place) {
  if (!is_in_graph_) return misplaced(place);
  marks_.push_back(mark(place, place + 1, terms_ > 0));
  end_statement();
  is_in_graph_ = false;
  is_behind_graph_ = true;
}

std::optional<std::size_t> GraphMarks::problem() const {
  if (graphs_ == 0) return std::nullopt;
  return is_in_graph_ && !misplaced_ ? std::optional(opened_) : misplaced_;
}

std::vector<GraphMark> GraphMarks::take() {
  if (graphs_ > 0) return std::move(marks_);
  if (reads_quads_ || has_only_quads_) return std::move(quads_);
  return {};
}

}  // namespace geminga::rdf
