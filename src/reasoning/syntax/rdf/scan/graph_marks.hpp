// The graphs of TriG and N-Quads, which are read as one graph.
//
// TriG (RDF 1.1 TriG, section 2) is Turtle but for `NAME { ... }`, and N-Quads are N-Triples but for a fourth term.
// Without these marks a file says the union of its graphs, in the syntax that raptor reads with lines and in pieces.
// raptor's own reader of TriG knows neither GRAPH nor blank nodes as names.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_SCAN_GRAPH_MARKS_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_SCAN_GRAPH_MARKS_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace geminga::rdf {

/// A stretch of a file that says to which graph triples belong.
struct GraphMark {
  std::uint32_t begin = 0;
  std::uint32_t size = 0;
  bool ends_statement = false;  ///< a brace that closes a graph behind a triple without a dot
};

/// The text without them. Every line keeps its number.
[[nodiscard]] std::string without_marks(std::string_view text, const std::vector<GraphMark>& marks);

/// Follows the tokens of a file of Turtle or N-Triples, in their order. `begin` and `end` are places in the file, which
/// is smaller than 4 GiB.
class GraphMarks {
 public:
  /// `reads_quads`: a fourth term is a graph's name, even if other statements of the file are no N-Quads.
  explicit GraphMarks(bool reads_quads) : reads_quads_(reads_quads) {}

  /// An IRI, or the label of a blank node. `is_of_quads`: neither prefixed nor relative.
  void name(std::size_t begin, std::size_t end, bool is_of_quads);
  void literal(std::size_t begin);
  void datatype() { is_datatype_next_ = true; }  ///< the next name is that of the literal before it
  void keyword(std::size_t begin);               ///< GRAPH
  void other(std::size_t begin, char first);     ///< another token, which N-Quads have not
  void dot(std::size_t place);
  void directive();  ///< a token of a directive, or its dot
  void open(std::size_t place, bool is_in_directive);
  void close(std::size_t place);

  /// The place of the first brace that is no part of TriG, behind a graph. Without a graph it is none: a file that is
  /// no RDF at all has braces, too.
  [[nodiscard]] std::optional<std::size_t> problem() const;
  [[nodiscard]] std::size_t graph_count() const { return graphs_; }
  /// The marks of the whole file; none where a brace or a fourth term is no part of TriG or N-Quads.
  [[nodiscard]] std::vector<GraphMark> take();

 private:
  void begin_term(std::size_t begin);
  void end_statement();
  void misplaced(std::size_t place);

  std::vector<GraphMark> marks_;  ///< of TriG
  std::vector<GraphMark> quads_;
  std::size_t begin_ = 0;  ///< of the statement
  std::size_t terms_ = 0;  ///< of the statement
  std::size_t graphs_ = 0;
  std::size_t opened_ = 0;  ///< the place of the last graph
  std::optional<std::size_t> misplaced_;
  bool reads_quads_;
  bool has_only_quads_ = true;
  bool has_keyword_ = false;
  bool is_name_ = false;      ///< the statement so far is what may name a graph
  bool opens_blank_ = false;  ///< it is a [
  bool is_datatype_next_ = false;
  bool is_in_graph_ = false;
  bool is_behind_graph_ = false;  ///< nothing stands between here and the brace that closed the last graph
};

}  // namespace geminga::rdf

#endif
