// Cuts functional-style syntax into its terminal symbols, one at a time, without copying them.
#ifndef GEMINGA_REASONING_SYNTAX_FUNCTIONAL_TOKENIZER_HPP
#define GEMINGA_REASONING_SYNTAX_FUNCTIONAL_TOKENIZER_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "reasoning/syntax/functional/limits.hpp"

namespace geminga::functional {

enum class TokenKind : std::uint8_t {
  end,            ///< of the file
  failed,         ///< something was wrong: nothing more will come
  open,           ///< (
  close,          ///< )
  equals,         ///< =
  carets,         ///< ^^
  word,           ///< SubClassOf
  number,         ///< 17
  full_iri,       ///< <http://example.org/a>; text: without the angle brackets
  prefixed_name,  ///< soma:Ball
  node_id,        ///< _:b0; text: without _:
  string,         ///< "text"; text: without the quotes, its escapes as they are
  language,       ///< @en-GB; text: without the @
};

/// One terminal symbol. The text lives as long as the file's bytes.
struct Token {
  TokenKind kind = TokenKind::end;
  bool has_escapes = false;        ///< of strings and prefixed names: unescape() makes a difference
  std::uint32_t prefix_bytes = 0;  ///< of prefixed names: what stands before the colon
  std::string_view text;
};

/// An error in a text, and its line.
struct Problem {
  std::uint32_t line = 0;
  std::string text;
};

/// The first problem of a text before it is tokenized: a NUL, or octets that are not UTF-8.
[[nodiscard]] std::optional<Problem> check_text(std::string_view bytes);

/// Appends a local name with its escapes resolved.
void append_unescaped(std::string& to, std::string_view name);

/// Appends a text with its escapes resolved. Any other backslash stays. Returns whether there is one.
bool append_unescaped_text(std::string& to, std::string_view text);

/// Walks over a text that check_text() has accepted. White space and comments are skipped.
class Tokenizer {
 public:
  /// Stands on the first token. Both arguments must outlive the tokenizer.
  Tokenizer(std::string_view text, const FunctionalLimits& limits);

  [[nodiscard]] const Token& token() const { return token_; }
  [[nodiscard]] bool is(TokenKind kind) const { return token_.kind == kind; }
  void advance();

  /// The line, from 1, in which the current token begins. Each octet is counted once, however often this is called.
  [[nodiscard]] std::uint32_t line();

  /// Ends the tokens with a problem in the line of the current token. The first problem is kept.
  void fail(std::string text);
  /// Ends them with this problem instead.
  void fail(Problem problem);
  [[nodiscard]] const std::optional<Problem>& problem() const { return problem_; }

  /// A token to go back to.
  struct Place {
    const char* next = nullptr;
    const char* begin = nullptr;
    const char* counted = nullptr;
    std::uint32_t line = 1;
    Token token;
  };
  [[nodiscard]] Place place() const { return {place_, token_begin_, counted_, line_, token_}; }
  /// Stands on this token again, without a problem.
  void go_back(const Place& place);

 private:
  void skip_blanks();
  void take_iri();
  void take_string();
  void take_language();
  void take_node_id();
  void take_name();
  void take_local_name(const char* begin);
  [[nodiscard]] const char* end_of_run(const char* from) const;
  void finish(TokenKind kind, const char* begin, const char* end, const char* next);
  [[nodiscard]] std::uint32_t line_at(const char* place);

  const FunctionalLimits& limits_;
  const char* end_;
  const char* place_;        ///< behind the current token
  const char* token_begin_;  ///< of the current token
  const char* counted_;      ///< lines were counted up to here
  std::uint32_t line_ = 1;   ///< of counted_
  Token token_;
  std::optional<Problem> problem_;
};

}  // namespace geminga::functional

#endif
