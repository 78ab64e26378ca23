// Subsumptions that are to follow no more: that classes can have no instance, a contradiction, or one subsumption.
#ifndef GEMINGA_ONTOLOGY_REPAIR_UNWANTED_HPP
#define GEMINGA_ONTOLOGY_REPAIR_UNWANTED_HPP

#include <cstdint>
#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "ontology/loading/closure.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/explanation/explain_module.hpp"
#include "reasoning/explanation/explain_oracle.hpp"

namespace geminga::ontology {

/// The answer to which of the unwanted subsumptions still follow.
struct Following {
  std::vector<Subsumption> certain;
  bool may_be_more = false;  ///< the engines did not decide all of them
};

/// Unwanted subsumptions of one ontology, asked of the axioms that can matter for them. Borrows the ontology and the
/// budget.
class Unwanted {
 public:
  /// Those of one super: a subsumption, a contradiction (owl:Thing below owl:Nothing), or all classes that can have no
  /// instance (below owl:Nothing).
  Unwanted(const compiled::Ontology& ontology, std::vector<taxonomy::ClassNumber> subs, taxonomy::ClassNumber super,
           base::Budget& budget);
  Unwanted(const Unwanted&) = delete;
  Unwanted& operator=(const Unwanted&) = delete;

  /// Those that follow when these axioms of the module are taken out, in the order of the constructor. The engines of a
  /// classification decide, so that nothing is missed that they can decide.
  [[nodiscard]] Following following_without(const explanation::AxiomSet& removed);
  /// A minimal set of axioms that entails one of them when others are taken out. Nothing if no engine finds it within
  /// its limits.
  [[nodiscard]] std::optional<explanation::AxiomSet> reason_without(const Subsumption& one,
                                                                    const explanation::AxiomSet& removed);

  [[nodiscard]] const explanation::Module& module() const { return module_; }

 private:
  [[nodiscard]] explanation::AxiomSet left(const explanation::AxiomSet& removed) const;

  const compiled::Ontology& ontology_;
  std::vector<taxonomy::ClassNumber> subs_;
  taxonomy::ClassNumber super_;
  base::Budget& budget_;
  explanation::Module module_;
  explanation::Oracle oracle_;
};

}  // namespace geminga::ontology

#endif
