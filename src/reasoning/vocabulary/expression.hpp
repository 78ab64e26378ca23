// A class expression whose names were found in a vocabulary.
#ifndef GEMINGA_REASONING_VOCABULARY_EXPRESSION_HPP
#define GEMINGA_REASONING_VOCABULARY_EXPRESSION_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "reasoning/syntax/manchester/limits.hpp"
#include "reasoning/syntax/manchester/parse.hpp"

namespace geminga::vocabulary {

/// The most octets of an expression, whoever wrote it.
inline constexpr std::size_t max_expression_bytes = manchester::ExpressionLimits{}.text_bytes;

/// The result of Vocabulary::read() (src/reasoning/syntax/manchester/MANCHESTER.md).
class Expression {
 public:
  /// Equal for expressions that differ only in their spelling. read() takes it.
  [[nodiscard]] std::string canonical() const;

 private:
  friend class Vocabulary;
  explicit Expression(manchester::Expression parsed) : parsed_(std::move(parsed)) {}
  manchester::Expression parsed_;
};

/// The error, one line, of a text that cannot be read as an expression or as a name in any vocabulary. For where no
/// ontology is loaded that could say more.
[[nodiscard]] std::optional<std::string> check_grammar(std::string_view text);

}  // namespace geminga::vocabulary

#endif
