#include "reasoning/reasoner/damaged.hpp"

#include <algorithm>
#include <numeric>

#include "base/text.hpp"
#include "reasoning/reasoner/readings.hpp"

namespace geminga::reasoner {
namespace {

/// What an answer that is left open hangs on.
Answer open_answer(const owl::Ontology& source, std::size_t damaged, const std::string& why) {
  const owl::Axiom axiom = source.damaged(damaged);
  std::string text = "it may hang on " + std::string(owl::damaged_literal) + ": " +
                     base::printable(source.files()[static_cast<std::size_t>(axiom.file)].path, 4096);
  if (axiom.line != 0) text += ':' + std::to_string(axiom.line);
  return {Verdict::unknown, why.empty() ? text : text + " (" + why + ')'};
}

/// The axioms of a reading as numbers of the source.
std::vector<std::uint32_t> add(const std::vector<Statement>& reading, owl::Ontology& source,
                               std::span<const std::size_t> damaged) {
  std::vector<std::uint32_t> numbers;
  for (std::size_t at = 0; at < reading.size(); ++at) {
    const owl::Axiom original = source.damaged(damaged[at]);
    const std::size_t before = source.axiom_count();
    source.add(reading[at].kind, reading[at].arguments, original.file, original.line);
    if (source.axiom_count() > before) numbers.push_back(static_cast<std::uint32_t>(before));
  }
  return numbers;
}

bool is_no(const Answer& answer) { return answer.verdict == Verdict::no; }

}  // namespace

std::vector<Answer> entails_each(owl::Ontology& source, std::span<const std::uint32_t> premise,
                                 std::span<const std::uint32_t> conclusion, std::span<const std::size_t> damaged,
                                 base::Budget* budget) {
  std::vector<Answer> answers = entails_each(std::as_const(source), premise, conclusion, budget);
  if (damaged.empty() || std::ranges::none_of(answers, is_no)) return answers;
  const auto leave_open = [&](Answer& answer, const std::string& why) {
    if (is_no(answer)) answer = open_answer(source, damaged.front(), why);
  };
  const auto readings = find_readings(source, premise, conclusion, damaged);
  if (!readings) {
    for (Answer& answer : answers) leave_open(answer, readings.error());
    return answers;
  }
  for (const std::vector<Statement>& reading : *readings) {
    std::vector<std::uint32_t> read(premise.begin(), premise.end());
    const std::vector<std::uint32_t> meant = add(reading, source, damaged);
    read.insert(read.end(), meant.begin(), meant.end());
    const bool is_whole = meant.size() == reading.size();
    const auto again = is_whole ? entails_each(std::as_const(source), read, conclusion, budget) : std::vector<Answer>();
    for (std::size_t at = 0; at < answers.size(); ++at) {
      if (!is_whole || !is_no(again[at])) leave_open(answers[at], is_whole ? again[at].reason : "");
    }
    if (std::ranges::none_of(answers, is_no)) break;
  }
  return answers;
}

Answer is_consistent_as_meant(owl::Ontology& source, base::Budget* budget) {
  Answer answer = is_consistent(source, budget);
  if (answer.verdict != Verdict::yes || source.damaged_count() == 0) return answer;
  std::vector<std::size_t> damaged(source.damaged_count());
  std::iota(damaged.begin(), damaged.end(), 0U);
  std::vector<std::uint32_t> axioms(source.axiom_count());
  std::iota(axioms.begin(), axioms.end(), 0U);
  const auto readings = find_readings(source, axioms, {}, damaged);
  if (!readings) return open_answer(source, 0, readings.error());
  for (const std::vector<Statement>& reading : *readings) {
    std::vector<std::uint32_t> read = axioms;
    const std::vector<std::uint32_t> meant = add(reading, source, damaged);
    read.insert(read.end(), meant.begin(), meant.end());
    if (meant.size() != reading.size()) return open_answer(source, 0, "");
    const Answer of_reading = entails(source, read, owl::thing_term, owl::nothing_term, budget);
    if (!is_no(of_reading)) return open_answer(source, 0, of_reading.reason);
  }
  return answer;
}

}  // namespace geminga::reasoner
