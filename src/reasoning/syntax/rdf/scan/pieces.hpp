// Where a large file can be cut, so that several parsers read it at once.
//
// The descriptions below rdf:RDF, and the statements of a Turtle file, can be parsed one by one behind the declarations
// at the beginning of the file. The cuts depend on the file only, not on the number of threads, and so do the names of
// blank nodes and the order of triples.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_SCAN_PIECES_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_SCAN_PIECES_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace geminga::rdf {

/// A stretch of a file, from here to the next piece.
struct Piece {
  std::size_t begin = 0;
  std::uint32_t line = 1;   ///< in which it begins
  std::size_t triples = 0;  ///< of Turtle: how many stand before it
};

/// The cuts of a file. The scan fills it in; without a cut the file is one piece.
class Pieces {
 public:
  /// No piece but the last is smaller than `bytes`.
  explicit Pieces(std::size_t bytes) : bytes_(bytes) {}

  /// The octets before this place are parsed before every piece: the first tag and its DOCTYPE, or directives.
  void begin_at(std::size_t place, std::uint32_t lines, std::string closing = {}) {
    if (preamble_ != 0) return forbid();
    preamble_ = place;
    preamble_lines_ = lines;
    closing_ = std::move(closing);
  }
  /// Undoes all cuts, and allows no more.
  void forbid() {
    is_forbidden_ = true;
    parts_.resize(1);
  }
  /// Whether a cut at this place would be taken.
  [[nodiscard]] bool wants(std::size_t place) const { return !is_forbidden_ && place - parts_.back().begin >= bytes_; }
  void cut(const Piece& piece) { parts_.push_back(piece); }

  [[nodiscard]] const std::vector<Piece>& parts() const { return parts_; }
  [[nodiscard]] std::size_t preamble() const { return preamble_; }
  /// Ends of lines in what stands before every piece.
  [[nodiscard]] std::uint32_t preamble_lines() const { return preamble_lines_; }
  /// The text that is parsed behind every piece but the last.
  [[nodiscard]] const std::string& closing() const { return closing_; }

 private:
  std::size_t bytes_;
  std::vector<Piece> parts_{Piece{}};
  std::size_t preamble_ = 0;
  std::uint32_t preamble_lines_ = 0;
  std::string closing_;
  bool is_forbidden_ = false;
};

}  // namespace geminga::rdf

#endif
