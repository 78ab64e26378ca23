// From a class expression in the Manchester syntax of OWL 2 to a term of the reasoner. The grammar is in MANCHESTER.md.
//
//   const compiled::EntityNames names(ontology);
//   const auto expression = manchester::parse("Sensor and (observes some Ball)", names);
//   if (!expression) return refuse(to_string(expression.error()));  // "column 13: no object property is 'observs'"
//   const auto place = classifier.classify(expression->source, expression->term);
#ifndef GEMINGA_REASONING_SYNTAX_MANCHESTER_PARSE_HPP
#define GEMINGA_REASONING_SYNTAX_MANCHESTER_PARSE_HPP

#include <expected>
#include <optional>
#include <string_view>

#include "reasoning/owl/names.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/syntax/manchester/error.hpp"
#include "reasoning/syntax/manchester/limits.hpp"

namespace geminga::manchester {

/// One expression: a term of a source of its own. Its names are full IRIs.
struct Expression {
  owl::Ontology source;
  owl::TermId term{};
};

/// Reads a whole text. Any bytes may be given.
[[nodiscard]] std::expected<Expression, ParseError> parse(std::string_view text, const owl::Names& names,
                                                          const ExpressionLimits& limits = {});

/// The error of a text that is an expression in no ontology, whatever its names mean. Nothing: some ontology can have
/// the names that make it one.
[[nodiscard]] std::optional<ParseError> check_grammar(std::string_view text, const ExpressionLimits& limits = {});

/// Whether a text is more than one name: it has a keyword, a bracket or a comma outside of quotation marks and IRIs.
/// Any other text is better looked up as a name, because that error says more.
[[nodiscard]] bool is_compound(std::string_view text);

}  // namespace geminga::manchester

#endif
