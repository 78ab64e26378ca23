// Asks reasoning/explanation within the limits of a daemon, which has others to serve on the same thread.
#include "reasoning/explanation/explain.hpp"

#include <utility>

#include "reasoning/explanation/why_not.hpp"
#include "reasoning/vocabulary/explanation.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::vocabulary {
namespace {

constexpr auto patience = explanation::Patience::of_a_daemon;

/// Without axioms matching goes on, and there are no explanations.
std::expected<void, Error> check(const compiled::Ontology& ontology) {
  if (const auto axioms = ontology.check_axioms(); !axioms) {
    return std::unexpected(Error{ErrorCode::impossible, axioms.error().text});
  }
  return {};
}

}  // namespace

std::expected<Explanation, Error> Vocabulary::explain(ClassNumber sub, ClassNumber super) const {
  if (const auto axioms = check(*ontology_); !axioms) return std::unexpected(axioms.error());
  Explanation found{.is_subsumed = is_subsumed(sub, super), .axioms = {}, .common = {}, .missing = {}};
  if (auto axioms = explanation::explain(*ontology_, sub, super, patience)) found.axioms = std::move(*axioms);
  if (found.is_subsumed) return found;
  explanation::WhyNot why_not = explanation::why_not(*ontology_, sub, super, patience);
  found.missing = explanation::describe(*ontology_, sub, super, why_not);
  found.common = std::move(why_not.common);
  return found;
}

std::expected<std::string, Error> Vocabulary::why_not(ClassNumber sub, ClassNumber super) const {
  if (const auto axioms = check(*ontology_); !axioms) return std::unexpected(axioms.error());
  return explanation::describe_briefly(*ontology_, sub, super, explanation::why_not(*ontology_, sub, super, patience));
}

}  // namespace geminga::vocabulary
