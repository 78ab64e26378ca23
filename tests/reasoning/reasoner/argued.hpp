// Premise and conclusion as a few lines of text, and whether each line of the conclusion follows.
#ifndef GEMINGA_TESTS_REASONING_REASONER_ARGUED_HPP
#define GEMINGA_TESTS_REASONING_REASONER_ARGUED_HPP

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/owl/source.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "support/written.hpp"

namespace geminga::reasoner {

/// In the syntax of support/written.hpp, in one source; the conclusion is its second file.
struct Argued {
  Argued(std::string_view premise_text, std::string_view conclusion_text) {
    owl::write_into(source, premise_text, "premise.ofn");
    const auto middle = static_cast<std::uint32_t>(source.axiom_count());
    owl::write_into(source, conclusion_text, "conclusion.ofn");
    for (std::uint32_t axiom = 0; axiom < source.axiom_count(); ++axiom)
      (axiom < middle ? premise : conclusion).push_back(axiom);
  }

  [[nodiscard]] std::vector<Answer> answers() const { return entails_each(source, premise, conclusion); }

  owl::Ontology source;
  std::vector<std::uint32_t> premise;
  std::vector<std::uint32_t> conclusion;
};

/// "yes", "no", or "unknown: why", of each line of the conclusion, behind each other.
inline std::string answer_to(std::string_view premise, std::string_view conclusion) {
  std::string text;
  for (const Answer& answer : Argued(premise, conclusion).answers()) {
    if (!text.empty()) text += ", ";
    text += answer.verdict == Verdict::yes ? "yes" : answer.verdict == Verdict::no ? "no" : "unknown: " + answer.reason;
  }
  return text;
}

}  // namespace geminga::reasoner

#endif
