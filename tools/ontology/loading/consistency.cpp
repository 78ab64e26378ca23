#include "ontology/loading/consistency.hpp"

#include <string>
#include <utility>

#include "ontology/loading/argument.hpp"
#include "ontology/loading/refused.hpp"
#include "reasoning/owl/left_out.hpp"
#include "reasoning/reasoner/ill_typed.hpp"

namespace geminga::ontology {

using reasoner::Answer;
using reasoner::Verdict;

Answer consistency_of(rdf::Loaded& loaded, Answer of_axioms, base::Budget* budget) {
  Answer answer = reasoner::consistency_of_repairs(loaded.source, std::move(of_axioms), budget);
  if (answer.verdict != Verdict::yes) return answer;
  if (auto unread = find_unread(loaded.source, {}, false)) return {Verdict::unknown, std::move(*unread)};
  if (auto refused = describe_refused(loaded)) return {Verdict::unknown, std::move(*refused)};
  return answer;
}

Answer consistency_of(ClassifiedFiles& classified, base::Budget* budget) {
  const reasoner::Classified& found = classified.classification;
  Answer answer{Verdict::yes, {}};
  if (!found.is_consistent) {
    answer.verdict = Verdict::no;
  } else if (!found.consistency_gap.empty()) {
    answer = {Verdict::unknown, found.consistency_gap};
  }
  return consistency_of(classified.loaded, std::move(answer), budget);
}

Answer consistency_of(const compiled::Ontology& ontology) {
  if (!ontology.is_consistent()) return {Verdict::no, {}};
  for (const owl::LeftOut& one : ontology.left_out()) {
    if (!one.construct.starts_with(import_words))
      return {Verdict::unknown, one.construct + " was left out: " + one.first};
  }
  for (const std::string& gap : ontology.gaps()) {
    if (gap.find(contradiction_question) != std::string::npos) return {Verdict::unknown, gap};
  }
  return {Verdict::yes, {}};
}

void note_model(reasoner::Classified& classification) {
  classification.undecided.consistency = false;
  classification.consistency_gap.clear();
}

void put_consistency(const Answer& answer, boost::json::object& document) {
  if (answer.verdict != Verdict::unknown) {
    document["consistent"] = answer.verdict == Verdict::yes;
    return;
  }
  document["consistent"] = nullptr;
  document["reason"] = answer.reason;
}

}  // namespace geminga::ontology
