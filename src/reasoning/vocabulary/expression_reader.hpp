// The tables of a vocabulary that class expressions need, and every reason why there are none as an error.
#ifndef GEMINGA_REASONING_VOCABULARY_EXPRESSION_READER_HPP
#define GEMINGA_REASONING_VOCABULARY_EXPRESSION_READER_HPP

#include <expected>
#include <new>
#include <utility>

#include "geminga/error.hpp"
#include "reasoning/compiled/entity_names.hpp"
#include "reasoning/placement/expression_classifier.hpp"

namespace geminga::vocabulary {

/// The classifier of expressions and its names, or why expressions are impossible.
class ExpressionReader {
 public:
  struct Parts {
    placement::ExpressionClassifier classifier;
    compiled::EntityNames names;
  };

  explicit ExpressionReader(const compiled::Ontology& ontology) : parts(make(ontology)) {}

  const std::expected<Parts, Error> parts;

 private:
  [[nodiscard]] static std::expected<Parts, Error> make(const compiled::Ontology& ontology) {
    try {
      auto classifier = placement::ExpressionClassifier::build(ontology);
      if (!classifier) return std::unexpected(Error{ErrorCode::impossible, classifier.error().text});
      return Parts{std::move(*classifier), compiled::EntityNames(ontology)};
    } catch (const std::bad_alloc&) {
      return std::unexpected(
          Error{ErrorCode::impossible, "not enough memory for class expressions: name a class instead"});
    }
  }
};

}  // namespace geminga::vocabulary

#endif
