// The class expressions of a proof: a normal form, so that few rules suffice, and readable text.
#ifndef GEMINGA_REASONING_EXPLANATION_PROOF_TERMS_HPP
#define GEMINGA_REASONING_EXPLANATION_PROOF_TERMS_HPP

#include <map>
#include <string>
#include <vector>

#include "reasoning/owl/print.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::explanation {

/// Makes terms in a normal form, in which terms of equal meaning are more often equal: an individual is the class with
/// this one instance, `value` and `min 1` are `some`, `exactly` is `min and max`, every restriction has a filler, and
/// conjunctions are flat and sorted. Recursion is bounded by the nesting of terms.
class ProofTerms {
 public:
  explicit ProofTerms(owl::Ontology& source) : source_(source) {}

  /// The normal form of a class expression or data range.
  [[nodiscard]] owl::TermId normal(owl::TermId term);
  /// The class of one individual, or the data range of one literal.
  [[nodiscard]] owl::TermId singleton(owl::TermId individual);
  [[nodiscard]] owl::TermId some(owl::TermId role, owl::TermId filler);
  [[nodiscard]] owl::TermId conjunction(const std::vector<owl::TermId>& parts);
  /// The inverse of a property expression. The inverse of an inverse is the property.
  [[nodiscard]] owl::TermId inverse(owl::TermId role);

  /// "A SubClassOf B", "a Type B", "a r b": the axiom as people write it. The terms are in normal form.
  [[nodiscard]] std::string readable(owl::TermId sub, owl::TermId super, const owl::ShortName& short_name);

 private:
  [[nodiscard]] owl::TermId restriction(const owl::Term& term);
  [[nodiscard]] owl::TermId at_least(std::uint32_t count, owl::TermId role, owl::TermId filler);
  [[nodiscard]] owl::TermId at_most(std::uint32_t count, owl::TermId role, owl::TermId filler);
  [[nodiscard]] bool is_data(owl::TermId role) const { return source_.kind(role) == owl::TermKind::data_property; }
  [[nodiscard]] owl::TermId as_written(owl::TermId term);
  [[nodiscard]] owl::TermId write(owl::TermId term);
  [[nodiscard]] owl::TermId normalise(owl::TermId term);

  owl::Ontology& source_;
  // Terms share their parts, so each is converted once.
  std::map<owl::TermId, owl::TermId> normal_;
  std::map<owl::TermId, owl::TermId> written_;
};

}  // namespace geminga::explanation

#endif
