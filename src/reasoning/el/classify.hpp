// Classification: from the axioms of an Ontology to the taxonomy of its named classes.
#ifndef GEMINGA_REASONING_EL_CLASSIFY_HPP
#define GEMINGA_REASONING_EL_CLASSIFY_HPP

#include <expected>
#include <string>

#include "base/budget.hpp"
#include "reasoning/el/limits.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/taxonomy/classification.hpp"

namespace geminga::el {

struct ClassifyOptions {
  unsigned threads = 1;  ///< of saturation; the result does not depend on it
  bool inherits = true;  ///< closes by inheritance if possible (closure/inheritance.hpp)
  /// The budget of the work of deriving, borrowed; null: only `limits` bound it. When it is spent, the conclusions so
  /// far are still reduced to a taxonomy, which is linear in the axioms.
  base::Budget* budget = nullptr;
  ClassifyLimits limits{};
};

/// The reason why an ontology could not be classified. `text` is one line for a user.
struct ClassifyError {
  std::string text;
};

/// Classifies. The result depends only on the set of axioms, not on their order or on threads, unless it is cut off.
[[nodiscard]] std::expected<taxonomy::Classification, ClassifyError> classify(const owl::Ontology& source,
                                                                              const ClassifyOptions& options = {});

}  // namespace geminga::el

#endif
