// Expressions over ontologies written in tests, and where they stand as text.
#ifndef GEMINGA_TESTS_REASONING_SYNTAX_MANCHESTER_PLACE_HPP
#define GEMINGA_TESTS_REASONING_SYNTAX_MANCHESTER_PLACE_HPP

#include <memory>
#include <string>
#include <string_view>

#include "reasoning/compiled/entity_names.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/placement/expression_classifier.hpp"
#include "reasoning/syntax/manchester/parse.hpp"

namespace geminga::manchester {

/// An ontology in the syntax of support/written.hpp, with its reader and classifier of expressions.
class Asked {
 public:
  explicit Asked(std::string_view ontology, const placement::ExpressionLimits& limits = {});
  explicit Asked(const owl::Ontology& source, const placement::ExpressionLimits& limits = {});

  /// `= A`, or `< A B > C D`: the classes right above and right below by local name, in the order of their numbers;
  /// `nothing` where it has no instance. ` ?` behind it where there are gaps. A text that cannot be read fails the test
  /// that asks.
  [[nodiscard]] std::string place(std::string_view expression) const;
  [[nodiscard]] placement::ExpressionPlace place_of(std::string_view expression) const;
  /// "yes", "no", or "no?" where there are gaps.
  [[nodiscard]] std::string is_subsumed(std::string_view sub, std::string_view super) const;
  /// The canonical text, or the error.
  [[nodiscard]] std::string read(std::string_view expression, const ExpressionLimits& limits = {}) const;

  [[nodiscard]] const compiled::Ontology& ontology() const { return *ontology_; }
  [[nodiscard]] const placement::ExpressionClassifier& classifier() const { return *classifier_; }
  [[nodiscard]] const compiled::EntityNames& names() const { return *names_; }

 private:
  std::unique_ptr<compiled::Ontology> ontology_;
  std::unique_ptr<compiled::EntityNames> names_;
  std::unique_ptr<placement::ExpressionClassifier> classifier_;
};

}  // namespace geminga::manchester

#endif
