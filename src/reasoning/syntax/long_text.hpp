// Finds a text, a name or white space that is too long while its file is read, so that a refused file is not in memory
// as a whole first.
#ifndef GEMINGA_REASONING_SYNTAX_LONG_TEXT_HPP
#define GEMINGA_REASONING_SYNTAX_LONG_TEXT_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "reasoning/syntax/syntax.hpp"

namespace geminga::syntax {

/// The most octets of each kind of stretch.
struct LongTextLimits {
  std::size_t text = 0;
  std::size_t blank = 0;                            ///< white space and comments in a row, not in XML
  std::size_t name = 0;                             ///< also of an IRI; in XML these are texts
  std::size_t xml_comment = std::size_t{8} << 20U;  ///< libxml2 keeps one as a whole
};

/// Goes over a file in stretches, and knows only where texts begin and end. The reader of the syntax checks the exact
/// limits later.
class LongText {
 public:
  enum class Kind : std::uint8_t { text, blank, name, xml_comment };

  /// In XML a text is what is between two tags. In other syntaxes it is what is in one pair of quotation marks.
  LongText(Syntax syntax, const LongTextLimits& limits) : is_xml_(is_xml(syntax)), limits_(limits) {}

  /// The line in which something too long begins. Nothing if nothing was found so far.
  [[nodiscard]] std::optional<std::uint32_t> look_at(std::string_view stretch);
  /// The kind of stretch that was found too long.
  [[nodiscard]] Kind kind() const { return kind_; }

 private:
  enum class Within : std::uint8_t { nothing, iri, comment, text, long_text };
  [[nodiscard]] std::optional<std::uint32_t> look_at_xml(std::string_view stretch);
  [[nodiscard]] std::optional<std::uint32_t> look_at_words(std::string_view stretch);
  void begin_comment();
  /// Goes on in an XML comment from a place to the next one where it may end, and returns that.
  std::size_t step_comment(std::string_view stretch, std::size_t at);
  /// Octets at the beginning of a stretch that only make longer what is open, and take it no further.
  [[nodiscard]] std::size_t run_in(std::string_view stretch) const;
  void take_run(std::string_view run);
  void step(char c);
  void begin_text(Within within);
  void note_blank(std::size_t blanks);
  [[nodiscard]] std::optional<std::uint32_t> found(Kind kind, std::uint32_t line) {
    kind_ = kind;
    return line;
  }

  bool is_xml_;
  LongTextLimits limits_;
  Kind kind_ = Kind::text;
  Within within_ = Within::nothing;
  char quote_ = '"';
  bool is_escaped_ = false;
  unsigned quotes_ = 0;      ///< in a row: three open and close a long text
  std::size_t opened_ = 0;   ///< octets of `<!--` that stand before this one, of XML
  std::size_t dashes_ = 0;   ///< in an XML comment, in a row before this octet
  std::uint32_t line_ = 1;   ///< of this octet
  std::uint32_t begin_ = 1;  ///< the line in which the text begins
  std::size_t text_bytes_ = 0;
  std::size_t blank_bytes_ = 0;
  std::uint32_t blank_begin_ = 1;
  std::size_t name_bytes_ = 0;  ///< of this name or IRI
  std::size_t comment_bytes_ = 0;
};

}  // namespace geminga::syntax

#endif
