// Finds a text or a stretch of nothing that is too long while its file is read, so that a refused file is not in memory
// as a whole first.
#ifndef GEMINGA_RDF_LONG_TEXT_HPP
#define GEMINGA_RDF_LONG_TEXT_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "rdf/syntax.hpp"

namespace geminga::rdf {

/// Goes over a file in stretches. It knows where texts begin and end and nothing else: what it lets pass is scanned by
/// the reader of its syntax, with the exact limits.
class LongText {
 public:
  /// A text are the octets between two ends of tags, of XML, or in one pair of quotation marks, of other syntaxes. Of
  /// these, too, white space and comments in a row are looked at.
  LongText(Syntax syntax, std::size_t max_text, std::size_t max_blank)
      : is_xml_(is_xml(syntax)), max_text_(max_text), max_blank_(max_blank) {}

  /// The line in which something begins that is too long; nothing so far.
  [[nodiscard]] std::optional<std::uint32_t> look_at(std::string_view stretch);
  /// Of what was found: it is white space and comments.
  [[nodiscard]] bool is_blank() const { return blank_bytes_ > max_blank_; }

 private:
  enum class Within : std::uint8_t { nothing, iri, comment, text, long_text };
  void step(char c);
  void step_xml(char c);
  void begin_text(Within within);
  void note_blank(bool is_blank);

  bool is_xml_;
  std::size_t max_text_;
  std::size_t max_blank_;
  Within within_ = Within::nothing;
  char quote_ = '"';
  bool is_escaped_ = false;
  unsigned quotes_ = 0;      ///< in a row: three open and close a long text
  std::uint32_t last_ = 0;   ///< the three octets before, of XML
  std::uint32_t line_ = 1;   ///< of this octet
  std::uint32_t begin_ = 1;  ///< the line in which the text begins
  std::size_t text_bytes_ = 0;
  std::size_t blank_bytes_ = 0;
  std::uint32_t blank_begin_ = 1;
};

}  // namespace geminga::rdf

#endif
