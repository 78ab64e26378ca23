// The answer of the engines as a JSON value and as an exit status.
#ifndef GEMINGA_ONTOLOGY_LOADING_VERDICT_HPP
#define GEMINGA_ONTOLOGY_LOADING_VERDICT_HPP

#include <boost/json/value.hpp>
#include <string>

#include "base/budget.hpp"
#include "ontology/command/words.hpp"
#include "reasoning/reasoner/reasoner.hpp"

namespace geminga::ontology {

/// true, false, or null where it is unknown.
[[nodiscard]] inline boost::json::value verdict_as_json(reasoner::Verdict verdict) {
  if (verdict == reasoner::Verdict::unknown) return nullptr;
  return verdict == reasoner::Verdict::yes;
}

/// The exit status of an answer to `question`, e.g. "whether there is a contradiction". Says why it cannot be decided.
[[nodiscard]] inline Exit exit_of(const reasoner::Answer& answer, const std::string& question,
                                  const base::Budget& budget) {
  if (answer.verdict != reasoner::Verdict::unknown)
    return answer.verdict == reasoner::Verdict::yes ? Exit::yes : Exit::no;
  return say_error("it cannot be decided " + question + ": " + answer.reason,
                   budget.is_spent() ? Exit::timed_out : Exit::usage);
}

}  // namespace geminga::ontology

#endif
