// What `geminga-ontology explain` found, in text and in JSON.
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
  el::ClassNumber sub{};
  el::ClassNumber super{};
  bool is_entailed = false;
  bool is_all = false;                      ///< all sets were asked for
  reasoner::AllSets sets;                   ///< one set where not
  std::vector<reasoner::Proof> proofs;      ///< of each set, where they were asked for
  std::optional<reasoner::WhyNot> why_not;  ///< where it is not entailed
};

/// `explainer` is the one that found the sets; null where it is not entailed.
[[nodiscard]] std::string as_text(const el::Ontology& ontology, const Explained& explained,
                                  const reasoner::Explainer* explainer);
/// One document on one line.
[[nodiscard]] std::string as_json(const el::Ontology& ontology, const Explained& explained,
                                  const reasoner::Explainer* explainer);

}  // namespace geminga::ontology

#endif
