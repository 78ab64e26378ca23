// The answers of `geminga-ontology explain`, in text and in JSON.
#ifndef GEMINGA_ONTOLOGY_EXPLAIN_OUTPUT_HPP
#define GEMINGA_ONTOLOGY_EXPLAIN_OUTPUT_HPP

#include <optional>
#include <string>
#include <vector>

#include "reasoning/compiled/ontology.hpp"
#include "reasoning/explanation/explain.hpp"
#include "reasoning/explanation/proof.hpp"
#include "reasoning/explanation/why_not.hpp"

namespace geminga::ontology {

/// A question and its answer.
struct Explained {
  taxonomy::ClassNumber sub{};
  taxonomy::ClassNumber super{};
  bool is_entailed = false;
  bool is_all = false;                         ///< all sets are wanted
  explanation::AllSets sets;                   ///< one set, unless all are wanted
  std::vector<explanation::Proof> proofs;      ///< of each set, where they are wanted
  std::optional<explanation::WhyNot> why_not;  ///< where it is not entailed
};

/// `explainer` found the sets; null where the subsumption is not entailed.
[[nodiscard]] std::string as_text(const compiled::Ontology& ontology, const Explained& explained,
                                  const explanation::Explainer* explainer);
/// One document on one line.
[[nodiscard]] std::string as_json(const compiled::Ontology& ontology, const Explained& explained,
                                  const explanation::Explainer* explainer);

}  // namespace geminga::ontology

#endif
