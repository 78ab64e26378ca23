// Prepares a vocabulary for class expressions, and reads and places them.
#include <utility>

#include "base/assert.hpp"
#include "reasoning/syntax/manchester/canonical.hpp"
#include "reasoning/vocabulary/expression.hpp"
#include "reasoning/vocabulary/expression_reader.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::vocabulary {

std::string Expression::canonical() const { return manchester::canonical(parsed_.source, parsed_.term); }

std::optional<std::string> check_grammar(std::string_view text) {
  if (!manchester::is_compound(text)) return std::nullopt;
  const auto error = manchester::check_grammar(text);
  return error ? std::optional(manchester::to_string(*error)) : std::nullopt;
}

Vocabulary Vocabulary::with_expressions() const {
  GEMINGA_ASSERT(is_loaded());
  Vocabulary prepared = *this;
  prepared.reader_ = std::make_shared<const ExpressionReader>(*ontology_);
  return prepared;
}

std::expected<void, Error> Vocabulary::check_expressions() const {
  if (reader_ == nullptr) {
    return std::unexpected(
        Error{ErrorCode::not_ready, "not ready: the ontology is being prepared for class expressions"});
  }
  if (!reader_->parts) return std::unexpected(reader_->parts.error());
  return {};
}

std::expected<Expression, Error> Vocabulary::read(std::string_view text, std::size_t max_bytes) const {
  manchester::ExpressionLimits limits;
  limits.text_bytes = max_bytes;
  auto parsed = manchester::parse(text, reader_->parts->names, limits);
  if (parsed) return Expression(std::move(*parsed));
  const bool is_large = parsed.error().kind == manchester::ParseError::Kind::too_large;
  return std::unexpected(Error{is_large ? ErrorCode::too_large : ErrorCode::impossible, to_string(parsed.error())});
}

Place Vocabulary::place(const Expression& expression) const {
  return reader_->parts->classifier.classify(expression.parsed_.source, expression.parsed_.term);
}

Vocabulary::Subsumed Vocabulary::is_subsumed(const Expression& sub, const Expression& super) const {
  owl::Ontology query;  // the classifier asks about two terms of one source
  const owl::TermId below = query.copy(sub.parsed_.source, sub.parsed_.term);
  const owl::TermId above = query.copy(super.parsed_.source, super.parsed_.term);
  auto found = reader_->parts->classifier.is_subsumed(query, below, above);
  return {.holds = found.holds, .gaps = std::move(found.gaps)};
}

std::expected<Expression, Error> Vocabulary::both(const Expression& one, const Expression& other) const {
  const std::string text = "(" + one.canonical() + ") and (" + other.canonical() + ")";
  return read(text, text.size());
}

}  // namespace geminga::vocabulary
