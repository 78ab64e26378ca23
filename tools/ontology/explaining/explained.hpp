// The answer of explain, and its two forms: text and JSON.
#ifndef GEMINGA_ONTOLOGY_EXPLAINING_EXPLAINED_HPP
#define GEMINGA_ONTOLOGY_EXPLAINING_EXPLAINED_HPP

#include <optional>
#include <string>
#include <vector>

#include "ontology/explaining/question.hpp"
#include "reasoning/explanation/explain.hpp"
#include "reasoning/explanation/laconic.hpp"
#include "reasoning/explanation/proof.hpp"
#include "reasoning/explanation/why_not.hpp"

namespace geminga::ontology {

/// The answer to a question.
struct Explained {
  reasoner::Answer answer;                     ///< whether it is entailed
  bool is_all = false;                         ///< all sets are wanted
  explanation::AllSets sets;                   ///< one set, unless all are wanted
  std::vector<explanation::Proof> proofs;      ///< of each set, where they are wanted
  std::vector<explanation::Laconic> laconic;   ///< of each set, where they are wanted
  std::optional<explanation::WhyNot> why_not;  ///< where it is not entailed, and both sides are classes of the files

  [[nodiscard]] bool is_entailed() const { return answer.verdict == reasoner::Verdict::yes; }
};

/// `explainer` found the sets; null where the answer is not yes. Axioms that define a class of the question are not
/// written but in proofs, whose steps use them.
[[nodiscard]] std::string as_text(const Question& question, const Explained& explained,
                                  const explanation::Explainer* explainer);
/// One document on one line.
[[nodiscard]] std::string as_json(const Question& question, const Explained& explained,
                                  const explanation::Explainer* explainer);

}  // namespace geminga::ontology

#endif
