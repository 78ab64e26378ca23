#include "reasoning/reasoner/ill_typed.hpp"

#include <algorithm>
#include <numeric>

#include "base/text.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/reasoner/repairs.hpp"

namespace geminga::reasoner {
namespace {

/// The construct under which the axiom was left out.
std::string_view construct_of(const owl::Ontology& source, const owl::Axiom& axiom) {
  for (const owl::TermId id : owl::terms_in(source, axiom.arguments)) {
    if (source.kind(id) == owl::TermKind::literal && !source.is_well_typed(id)) return owl::ill_typed_literal;
  }
  return owl::foreign_facet;
}

/// An answer that stays open because of an axiom with an ill-typed literal.
Answer open_answer(const owl::Ontology& source, std::size_t ill_typed, const std::string& why) {
  const owl::Axiom axiom = source.ill_typed(ill_typed);
  std::string text = "it may hang on " + std::string(construct_of(source, axiom)) + ": " +
                     base::printable(source.files()[static_cast<std::size_t>(axiom.file)].path, 4096);
  if (axiom.line != 0) text += ':' + std::to_string(axiom.line);
  return {Verdict::unknown, why.empty() ? text : text + " (" + why + ')'};
}

/// Adds the axioms of a repair to the source, and returns their numbers.
std::vector<std::uint32_t> add(const std::vector<Statement>& repair, owl::Ontology& source,
                               std::span<const std::size_t> ill_typed) {
  std::vector<std::uint32_t> numbers;
  for (std::size_t at = 0; at < repair.size(); ++at) {
    const owl::Axiom original = source.ill_typed(ill_typed[at]);
    const std::size_t before = source.axiom_count();
    source.add(repair[at].kind, repair[at].arguments, original.file, original.line);
    if (source.axiom_count() > before) numbers.push_back(static_cast<std::uint32_t>(before));
  }
  return numbers;
}

bool is_no(const Answer& answer) { return answer.verdict == Verdict::no; }

}  // namespace

std::vector<Answer> entails_each(owl::Ontology& source, std::span<const std::uint32_t> premise,
                                 std::span<const std::uint32_t> conclusion, std::span<const std::size_t> ill_typed,
                                 base::Budget* budget) {
  std::vector<Answer> answers = entails_each(std::as_const(source), premise, conclusion, budget);
  if (ill_typed.empty() || std::ranges::none_of(answers, is_no)) return answers;
  const auto leave_open = [&](Answer& answer, const std::string& why) {
    if (is_no(answer)) answer = open_answer(source, ill_typed.front(), why);
  };
  const auto repairs = find_repairs(source, premise, conclusion, ill_typed);
  if (!repairs) {
    for (Answer& answer : answers) leave_open(answer, repairs.error());
    return answers;
  }
  for (const std::vector<Statement>& repair : *repairs) {
    std::vector<std::uint32_t> read(premise.begin(), premise.end());
    const std::vector<std::uint32_t> meant = add(repair, source, ill_typed);
    read.insert(read.end(), meant.begin(), meant.end());
    const bool is_whole = meant.size() == repair.size();
    const auto again = is_whole ? entails_each(std::as_const(source), read, conclusion, budget) : std::vector<Answer>();
    for (std::size_t at = 0; at < answers.size(); ++at) {
      if (!is_whole || !is_no(again[at])) leave_open(answers[at], is_whole ? again[at].reason : "");
    }
    if (std::ranges::none_of(answers, is_no)) break;
  }
  return answers;
}

Answer is_consistent_repaired(owl::Ontology& source, base::Budget* budget) {
  return consistency_of_repairs(source, is_consistent(source, budget), budget);
}

Answer consistency_of_repairs(owl::Ontology& source, Answer answer, base::Budget* budget) {
  if (answer.verdict != Verdict::yes || source.ill_typed_count() == 0) return answer;
  std::vector<std::size_t> ill_typed(source.ill_typed_count());
  std::iota(ill_typed.begin(), ill_typed.end(), 0U);
  std::vector<std::uint32_t> axioms(source.axiom_count());
  std::iota(axioms.begin(), axioms.end(), 0U);
  const auto repairs = find_repairs(source, axioms, {}, ill_typed);
  if (!repairs) return open_answer(source, 0, repairs.error());
  for (const std::vector<Statement>& repair : *repairs) {
    std::vector<std::uint32_t> read = axioms;
    const std::vector<std::uint32_t> meant = add(repair, source, ill_typed);
    read.insert(read.end(), meant.begin(), meant.end());
    if (meant.size() != repair.size()) return open_answer(source, 0, "");
    const Answer of_reading = entails(source, read, owl::thing_term, owl::nothing_term, budget);
    if (!is_no(of_reading)) return open_answer(source, 0, of_reading.reason);
  }
  return answer;
}

}  // namespace geminga::reasoner
