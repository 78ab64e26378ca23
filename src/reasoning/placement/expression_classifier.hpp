// Class expressions are classified on arrival, one by one, without a change to the loaded ontology.
//
// The classes above an expression are derived in a context of its own, which is laid over the base
// (expression_overlay.hpp). The classes below it are those whose contexts in the base are in it
// (expression_members.hpp). So the cost of an expression depends on the contexts that it leads to and on the classes
// below it, and not on the size of the ontology. Nothing is left behind.
#ifndef GEMINGA_REASONING_PLACEMENT_EXPRESSION_CLASSIFIER_HPP
#define GEMINGA_REASONING_PLACEMENT_EXPRESSION_CLASSIFIER_HPP

#include <cstddef>
#include <expected>
#include <memory>
#include <optional>

#include "reasoning/placement/expression.hpp"
#include "reasoning/placement/expression_base.hpp"

namespace geminga::placement {

/// Answers questions about expressions over one ontology, which must outlive it. Movable; may be shared by threads.
class ExpressionClassifier {
 public:
  /// Saturates the ontology, which takes the time and memory of its classification. An error if it is over a limit or
  /// inconsistent.
  [[nodiscard]] static std::expected<ExpressionClassifier, ExpressionError> build(const compiled::Ontology& ontology,
                                                                                  const ExpressionLimits& limits = {});

  /// The place of a class expression of `query`, whose names are those of the ontology. Always sound. Complete if the
  /// place has no gaps, as for ontologies in OWL 2 EL with functional properties, and expressions of these with unions,
  /// and with complements outside of restrictions and unions.
  [[nodiscard]] ExpressionPlace classify(const owl::Ontology& query, owl::TermId expression) const;
  /// The answer whether every instance of one expression is one of the other. `gaps` says why a no may be wrong.
  struct Subsumption {
    bool holds = false;
    std::vector<std::string> gaps;
  };
  [[nodiscard]] Subsumption is_subsumed(const owl::Ontology& query, owl::TermId sub, owl::TermId super) const;

  /// The first conjunction, restriction or other compound expression that an axiom makes equivalent to this class,
  /// which becomes a term of the query; nothing if there is none. Costs a pass over the axioms.
  [[nodiscard]] std::optional<owl::TermId> definition(owl::Ontology& query, owl::TermId named_class) const;

  /// The number of contexts of the base. No question changes it.
  [[nodiscard]] std::size_t context_count() const { return base_->context_count(); }

 private:
  explicit ExpressionClassifier(std::unique_ptr<const ExpressionBase> base) : base_(std::move(base)) {}
  std::unique_ptr<const ExpressionBase> base_;
};

}  // namespace geminga::placement

#endif
