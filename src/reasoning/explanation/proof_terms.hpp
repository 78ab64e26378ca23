// The class expressions of a proof: few forms, so that few rules are enough, and words for what is concluded.
#ifndef GEMINGA_REASONING_EXPLANATION_PROOF_TERMS_HPP
#define GEMINGA_REASONING_EXPLANATION_PROOF_TERMS_HPP

#include <map>
#include <string>
#include <vector>

#include "reasoning/owl/print.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::reasoner {

/// Makes terms in a source, in a form in which equal meanings are more often equal terms: an individual is the class of
/// itself alone, `value` and `min 1` are `some`, `exactly` is `min and max`, every restriction has a filler,
/// conjunctions are flat and sorted. Recursion is bounded by the nesting of terms.
class ProofTerms {
 public:
  explicit ProofTerms(el::OntologySource& source) : source_(source) {}

  /// The same class expression or data range in that form.
  [[nodiscard]] el::TermId normal(el::TermId term);
  /// The class of one individual; of a literal: the data range.
  [[nodiscard]] el::TermId singleton(el::TermId individual);
  [[nodiscard]] el::TermId some(el::TermId role, el::TermId filler);
  [[nodiscard]] el::TermId conjunction(const std::vector<el::TermId>& parts);
  /// Of a property expression; the inverse of an inverse is the property.
  [[nodiscard]] el::TermId inverse(el::TermId role);

  /// "A SubClassOf B", "a Type B", "a r b": as one would write it as an axiom. The terms are in normal form.
  [[nodiscard]] std::string readable(el::TermId sub, el::TermId super, const el::ShortName& short_name);

 private:
  [[nodiscard]] el::TermId restriction(const el::Term& term);
  [[nodiscard]] el::TermId at_least(std::uint32_t count, el::TermId role, el::TermId filler);
  [[nodiscard]] el::TermId at_most(std::uint32_t count, el::TermId role, el::TermId filler);
  [[nodiscard]] bool is_data(el::TermId role) const { return source_.kind(role) == el::TermKind::data_property; }
  [[nodiscard]] el::TermId as_written(el::TermId term);
  [[nodiscard]] el::TermId write(el::TermId term);
  [[nodiscard]] el::TermId normalise(el::TermId term);

  el::OntologySource& source_;
  // Terms share their parts: each is turned once.
  std::map<el::TermId, el::TermId> normal_;
  std::map<el::TermId, el::TermId> written_;
};

}  // namespace geminga::reasoner

#endif
