// The brackets, strings and IRIs of Turtle and N-Triples (RDF 1.1 Turtle, section 6.5), measured against the limits.
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "reasoning/syntax/rdf/scan/graph_marks.hpp"
#include "reasoning/syntax/rdf/scan/pieces.hpp"
#include "reasoning/syntax/rdf/scan/scan.hpp"
#include "reasoning/syntax/rdf/scan/turtle_lines.hpp"
#include "reasoning/syntax/vocabulary.hpp"

namespace geminga::rdf {
namespace {

/// The prefixes that the OWL API knows without a declaration.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> usual_prefixes{{{"rdf", syntax::rdf_namespace},
                                                                                       {"rdfs", syntax::rdfs_namespace},
                                                                                       {"owl", syntax::owl_namespace},
                                                                                       {"xsd", syntax::xsd_namespace}}};

class TurtleScan {
 public:
  TurtleScan(std::string_view bytes, bool is_n_triples, const syntax::FileLimits& limits)
      : bytes_(bytes), limits_(limits), marks_(is_n_triples), pieces_(limits.piece_bytes) {}

  std::expected<Layout, ScanProblem> run() {
    if (bytes_.starts_with("\xef\xbb\xbf")) place_ = 3;
    while (place_ < bytes_.size() && !problem_) {
      const std::size_t before = place_;
      step();
      watch_for_blanks(before);
      watch_for_cuts(before);
      if (lines_.statement_triples() > limits_.statement_triples)
        fail(place_,
             "has a statement of more than " + std::to_string(limits_.statement_triples) + " triples: split it");
      if (lines_.prefix_count() > limits_.prefixes)
        fail(place_, "declares more than " + std::to_string(limits_.prefixes) + " prefixes");
      if (marks_.graph_count() > limits_.graphs)
        fail(place_, "has more than " + std::to_string(limits_.graphs) + " graphs");
    }
    if (const auto place = marks_.problem())
      fail(*place, "has { ... } where TriG has none: Notation 3 is not read, convert it to Turtle");
    if (problem_) return std::unexpected(std::move(*problem_));
    return Layout{.pieces = std::move(pieces_),
                  .lines = lines_.take(),
                  .needs_turtle = needs_turtle_,
                  .base_texts = std::move(bases_),
                  .repairs = declarations(),
                  .graph_marks = marks_.take()};
  }

 private:
  void step() {
    switch (bytes_[place_]) {
      case '#':
        comment();
        break;
      case '<':
        iri();
        break;
      case '"':
      case '\'':
        string();
        break;
      case '[':
      case '(':
        if (++depth_ > limits_.nesting)
          fail(place_, "nests brackets more than " + std::to_string(limits_.nesting) + " deep");
        marks_.other(place_, bytes_[place_]);
        lines_.open(bytes_[place_++], line_here());
        break;
      case ']':
      case ')':
        if (depth_ > 0) --depth_;
        marks_.other(place_, bytes_[place_]);
        lines_.close(bytes_[place_++]);
        break;
      case '{':
        marks_.open(place_++, lines_.is_in_directive());
        lines_.punctuation('.');
        break;
      case '}':
        marks_.close(place_++);
        lines_.punctuation('.');
        break;
      case ';':
      case ',':
        marks_.other(place_, bytes_[place_]);
        lines_.punctuation(bytes_[place_++]);
        break;
      case ' ':
      case '\t':
      case '\r':
      case '\n':
        ++place_;
        break;
      case '^':  // ^^ before a datatype
        ++place_;
        marks_.datatype();
        lines_.datatype();
        break;
      default:
        name();
    }
  }

  void watch_for_blanks(std::size_t before) {
    const bool is_blank = std::string_view(" \t\r\n#").find(bytes_[before]) != std::string_view::npos;
    if (!is_blank) blank_begin_ = place_;
    if (place_ - blank_begin_ > limits_.blank_bytes)
      too_long(blank_begin_, "white space and comments", limits_.blank_bytes);
  }

  /// Statements can be read one by one behind the directives at the begin of the file, where there are no later ones.
  void watch_for_cuts(std::size_t before) {
    if (lines_.is_in_statement()) {
      if (!has_begun_) pieces_.begin_at(before, line_at(before) - 1);
      has_begun_ = true;
    } else if (has_begun_ && lines_.directive_count() != directives_) {
      pieces_.forbid();
    } else if (has_begun_ && pieces_.wants(place_) && bytes_[place_ - 1] == '\n') {  // N-Triples is read by lines
      pieces_.cut({place_, line_here(), lines_.triple_count()});
    }
    if (!has_begun_) directives_ = lines_.directive_count();
  }

  /// A run of characters without a break is a name, a number or a keyword; a name may escape what would end it.
  void name() {
    const std::size_t begin = place_;
    if (bytes_[begin] == '.' && !is_digit(begin + 1)) {
      marks_.dot(place_++);
      lines_.punctuation('.');
      return;
    }
    for (;;) {
      place_ = std::min(bytes_.find_first_of(" \t\r\n#<\"'[](){}\\,;^", place_), bytes_.size());
      if (place_ >= bytes_.size() || bytes_[place_] != '\\') break;
      place_ = std::min(place_ + 2, bytes_.size());
    }
    if (place_ == begin) ++place_;
    if (place_ - begin > limits_.iri_bytes) too_long(begin, "a name", limits_.iri_bytes);
    const std::string_view word = bytes_.substr(begin, place_ - begin);
    note_prefix(word);
    const bool was_in_directive = lines_.is_in_directive();
    lines_.word(word, line_at(begin));
    if (was_in_directive || lines_.is_in_directive()) return marks_.directive();
    note_term(word, begin);
  }

  /// Tells the marks of graphs a word. A dot at its end ends the statement, as for the lines.
  void note_term(std::string_view word, std::size_t begin) {
    const bool is_end = word.ends_with('.') && !word.ends_with("\\.");
    if (is_end) word.remove_suffix(1);
    if (base::in_lower_case(word) == "graph") {
      marks_.keyword(begin);
    } else if (word.find(':') != std::string_view::npos) {
      marks_.name(begin, begin + word.size(), word.starts_with("_:"));
    } else if (!word.starts_with('@') && !word.empty()) {
      marks_.other(begin, word.front());
    }
    if (is_end) marks_.dot(begin + word.size());
  }

  /// Whether a prefix that has one meaning everywhere is used before it is declared.
  void note_prefix(std::string_view word) {
    const std::string_view prefix = word.substr(0, std::min(word.find(':'), word.size()));
    for (std::size_t at = 0; at < usual_prefixes.size(); ++at) {
      if (prefix != usual_prefixes[at].first || prefix.size() == word.size()) continue;
      if (lines_.is_in_directive()) is_declared_[at] = true;
      if (!is_declared_[at]) is_missing_[at] = true;
    }
  }

  /// Declares the prefixes that are missing, before the first line.
  [[nodiscard]] std::vector<Repair> declarations() const {
    std::string text;
    for (std::size_t at = 0; at < usual_prefixes.size(); ++at) {
      if (!is_missing_[at]) continue;
      text.append("@prefix ").append(usual_prefixes[at].first).append(": <");
      text.append(usual_prefixes[at].second).append("> . ");
    }
    if (text.empty()) return {};
    return {{{bytes_.size() - base::without_mark(bytes_).size(), 0, std::move(text)},
             "a prefix of RDF, RDFS, OWL or XSD that the file does not declare"}};
  }

  /// Raptor's N-Triples reader takes a quotation mark or apostrophe in a comment for the begin of a text, and silently
  /// skips what follows; its Turtle reader does not.
  void comment() {
    const std::size_t end = std::min(bytes_.find('\n', place_), bytes_.size());
    if (bytes_.substr(place_, end - place_).find_first_of("\"'") != std::string_view::npos) needs_turtle_ = true;
    place_ = end;
  }

  [[nodiscard]] bool is_digit(std::size_t place) const {
    return place < bytes_.size() && bytes_[place] >= '0' && bytes_[place] <= '9';
  }

  void iri() {
    const std::size_t begin = place_++;
    while (place_ < bytes_.size() && bytes_[place_] != '>' && bytes_[place_] != '\n') {
      if (bytes_[place_] == '\\') {
        escape();
      } else {
        if (bytes_[place_] == '"') fail(place_, "has an IRI with a quotation mark in it");
        ++place_;
      }
    }
    if (place_ - begin > limits_.iri_bytes) too_long(begin, "an IRI", limits_.iri_bytes);
    const std::string_view text = bytes_.substr(begin + 1, place_ - begin - 1);
    // An escape may stand for a character that a base must not have; such a base is left as it is.
    if (lines_.is_base_next() && text.find('\\') == std::string_view::npos)
      bases_.push_back({begin + 1, text.size(), std::string(text)});
    if (!is_absolute(text)) needs_turtle_ = true;
    ++place_;
    const bool is_of_directive = lines_.is_in_directive();
    lines_.term(line_at(begin));
    is_of_directive ? marks_.directive() : marks_.name(begin, std::min(place_, bytes_.size()), is_absolute(text));
  }

  /// Whether an IRI begins with a scheme (RFC 3986, section 3.1).
  [[nodiscard]] static bool is_absolute(std::string_view iri) {
    const std::size_t end = iri.find_first_of(":/?#");
    return end != std::string_view::npos && end != 0 && iri[end] == ':';
  }

  void string() {
    const std::size_t begin = place_;
    const char quote = bytes_[place_];
    const std::array<char, 3> fence{quote, quote, quote};
    const bool is_long = place_ + 2 < bytes_.size() && bytes_[place_ + 1] == quote && bytes_[place_ + 2] == quote;
    place_ += is_long ? 3 : 1;
    for (;; ++place_) {
      if (place_ >= bytes_.size()) break;
      const char c = bytes_[place_];
      if (c == '\\') {
        escape();
        --place_;
      } else if (c == quote) {
        if (!is_long) break;
        if (bytes_.substr(place_, 3) == std::string_view(fence.data(), 3)) break;
      } else if (c == '\n' && !is_long) {
        break;  // no Turtle; Redland says so
      }
    }
    if (place_ - begin > limits_.literal_bytes) too_long(begin, "a literal", limits_.literal_bytes);
    place_ += is_long ? 3 : 1;
    lines_.term(line_at(begin));
    marks_.literal(begin);
  }

  /// \u0000 would cut a name short, and a surrogate would become bad UTF-8.
  void escape() {
    const std::size_t begin = place_;
    place_ += 2;
    if (begin + 1 >= bytes_.size()) return;
    const char kind = bytes_[begin + 1];
    if (kind != 'u' && kind != 'U') return;
    const std::string digits(bytes_.substr(begin + 2, kind == 'u' ? 4 : 8));
    if (digits.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) return;
    const unsigned long code = std::stoul('0' + digits, nullptr, 16);
    if (code == 0) fail(begin, "writes a NUL as " + std::string(bytes_.substr(begin, 2 + digits.size())));
    if ((code >= 0xd800 && code <= 0xdfff) || code > 0x10ffff)
      fail(begin, "writes no character as " + std::string(bytes_.substr(begin, 2 + digits.size())));
  }

  /// The line of a place that is not before the last one asked for.
  std::uint32_t line_at(std::size_t place) {
    for (; counted_ < place; ++counted_) {
      if (bytes_[counted_] == '\n') ++line_;
    }
    return line_;
  }
  std::uint32_t line_here() { return line_at(std::min(place_, bytes_.size())); }

  void too_long(std::size_t place, const char* what, std::size_t limit) {
    fail(place, std::string("has ") + what + " of more than " + std::to_string(limit) + " bytes");
  }

  void fail(std::size_t place, std::string text) {
    if (!problem_) problem_ = ScanProblem{line_of(bytes_, place), std::move(text)};
  }

  std::string_view bytes_;
  const syntax::FileLimits& limits_;
  TurtleLines lines_;
  GraphMarks marks_;
  Pieces pieces_;
  std::vector<BaseText> bases_;
  bool needs_turtle_ = false;
  std::array<bool, usual_prefixes.size()> is_declared_{};
  std::array<bool, usual_prefixes.size()> is_missing_{};
  bool has_begun_ = false;      ///< the first statement
  std::size_t directives_ = 0;  ///< before it
  std::size_t place_ = 0;
  std::size_t counted_ = 0;
  std::uint32_t line_ = 1;
  std::size_t depth_ = 0;
  std::size_t blank_begin_ = 0;  ///< of the white space and comments that go on to here
  std::optional<ScanProblem> problem_;
};

}  // namespace

std::expected<Layout, ScanProblem> scan_turtle(std::string_view bytes, bool is_n_triples,
                                               const syntax::FileLimits& limits) {
  return TurtleScan(bytes, is_n_triples, limits).run();
}

}  // namespace geminga::rdf
