// Cuts a class expression, or a document, into its terminal symbols, one at a time.
#ifndef GEMINGA_REASONING_SYNTAX_MANCHESTER_TOKENIZER_HPP
#define GEMINGA_REASONING_SYNTAX_MANCHESTER_TOKENIZER_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace geminga::manchester {

enum class TokenKind : std::uint8_t {
  end,       ///< of the text
  bad,       ///< no token: `value` says what is wrong
  name,      ///< soma:Ball, Ball, or <IRI> with its brackets
  section,   ///< SubClassOf:, in documents
  label,     ///< 'left eye'; value: without the quotes
  keyword,   ///< and, or, not, that, some, only, value, Self, min, max, exactly, inverse, true, false
  number,    ///< 17, -3.5, 1e3f
  string,    ///< "text"; value: without the quotes, its escapes resolved
  language,  ///< @en; value: without the @
  carets,    ///< ^^
  facet,     ///< <, <=, >, >=, and the words of facets, between square brackets
  symbol,    ///< ( ) { } [ ] , and, in documents, ->
};

struct Token {
  TokenKind kind = TokenKind::end;
  std::string_view text;  ///< as it stands there
  std::string value;      ///< of labels, strings, languages, and what is wrong with bad ones
  std::size_t begin = 0;  ///< octet, from 0
};

/// Walks over a text of valid UTF-8, which must outlive it.
class Tokenizer {
 public:
  explicit Tokenizer(std::string_view text) : text_(text) { advance(); }
  /// For a document: these words begin frames and sections and are no names, and comments are skipped. The words are
  /// sorted and outlive the tokenizer.
  Tokenizer(std::string_view text, std::span<const std::string_view> sections)
      : text_(text), sections_(sections), is_document_(true) {
    advance();
  }

  [[nodiscard]] const Token& token() const { return token_; }
  void advance();
  /// Says whether a facet may stand here. Then `<` begins a comparison, otherwise an IRI. Holds for the tokens that
  /// follow.
  void set_facets(bool are_facets) { are_facets_ = are_facets; }
  /// The first octet so far where a backslash of a document escapes nothing, and stands for itself.
  [[nodiscard]] std::optional<std::size_t> odd_backslash() const { return odd_backslash_; }
  /// The column of an octet, from 1, in characters.
  [[nodiscard]] std::size_t column_of(std::size_t octet) const;

 private:
  void finish(TokenKind kind, std::size_t size);
  void fail(std::size_t size, std::string what);
  void take_quoted(char quote, TokenKind kind);
  void take_iri();
  void take_word();

  void skip_comments();

  std::string_view text_;
  std::span<const std::string_view> sections_;
  bool is_document_ = false;
  std::size_t place_ = 0;
  bool are_facets_ = false;
  std::optional<std::size_t> odd_backslash_;
  Token token_;
};

}  // namespace geminga::manchester

#endif
