// The lines of the triples of a Turtle file, in the order in which raptor gives the triples out.
//
// Raptor gives out the triples of a statement at its end, and knows no other line. A statement often describes a whole
// class, and users need the line of each axiom.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_SCAN_TURTLE_LINES_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_SCAN_TURTLE_LINES_HPP

#include <cstdint>
#include <string_view>
#include <vector>

namespace geminga::rdf {

/// Follows the tokens of a file. A triple has the line of its object; raptor gives out the triples of brackets and
/// lists when they close, those of a list from its end, and all others at the end of the statement. A file that is no
/// Turtle gives lines that mean nothing; raptor refuses it.
class TurtleLines {
 public:
  TurtleLines() { frames_.emplace_back(); }

  void word(std::string_view text, std::uint32_t line);  ///< a name, number or keyword; perhaps with a final dot
  void term(std::uint32_t line);                         ///< an IRI or a string
  void open(char bracket, std::uint32_t line);
  void close(char bracket);
  void punctuation(char mark);  ///< one of . ; ,
  /// The next word or IRI is the datatype of the literal before it.
  void datatype() { is_datatype_next_ = true; }

  /// Whether the next IRI is the base of those behind it.
  [[nodiscard]] bool is_base_next() const { return is_base_next_; }

  /// Whether the next word or IRI is of a directive.
  [[nodiscard]] bool is_in_directive() const { return directive_left_ > 0; }

  /// Triples of the open statement, those of its closed brackets included.
  [[nodiscard]] std::size_t statement_triples() const { return statement_triples_; }
  [[nodiscard]] std::size_t prefix_count() const { return prefix_count_; }
  /// The number of @prefix and @base, also in the style of SPARQL.
  [[nodiscard]] std::size_t directive_count() const { return directive_count_; }
  [[nodiscard]] bool is_in_statement() const { return frames_.size() > 1 || frames_.front().next != Part::subject; }
  /// Triples of the statements that have ended.
  [[nodiscard]] std::size_t triple_count() const { return lines_.size(); }
  [[nodiscard]] std::vector<std::uint32_t> take() { return std::move(lines_); }

 private:
  enum class Part { subject, verb, object };
  struct Frame {
    char bracket = 0;  ///< 0: the statement itself
    Part next = Part::subject;
    std::uint32_t line = 0;
    std::vector<std::uint32_t> objects;
  };

  void end_statement();
  void flush(Frame& frame);

  std::vector<Frame> frames_;
  std::vector<std::uint32_t> lines_;
  std::size_t statement_triples_ = 0;
  std::size_t prefix_count_ = 0;
  std::size_t directive_count_ = 0;
  bool is_base_next_ = false;
  bool is_datatype_next_ = false;
  int directive_left_ = 0;  ///< terms of a directive that are still to come
};

}  // namespace geminga::rdf

#endif
