// Conclusions: told ones follow at once, those about anonymous individuals are rolled up, all others are refuted or
// follow.
#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "reasoning/owl/canonical.hpp"
#include "reasoning/reasoner/anonymous.hpp"
#include "reasoning/reasoner/challenge.hpp"
#include "reasoning/reasoner/possibility.hpp"
#include "reasoning/reasoner/reasoner.hpp"

namespace geminga::reasoner {
namespace {

using owl::AxiomKind;
using owl::TermId;

using Content = std::pair<AxiomKind, std::vector<TermId>>;

/// An axiom with the members of sets in one order, so that equal axioms are equal values.
Content content_of(const owl::Axiom& axiom) {
  std::vector<TermId> arguments(axiom.arguments.begin(), axiom.arguments.end());
  const auto members = arguments.begin() + static_cast<std::ptrdiff_t>(owl::set_begin(axiom.kind, arguments.size()));
  std::sort(members, arguments.end());
  return {axiom.kind, std::move(arguments)};
}

/// Conclusions that have one answer together, and where their challenges are.
struct Part {
  std::vector<std::size_t> conclusions;  ///< their positions
  std::size_t first = 0;                 ///< challenges of which none may be possible: [first, witnesses)
  std::size_t witnesses = 0;             ///< [witnesses, last)
  std::size_t last = 0;
  std::string undecided;
};

class Entailment {
 public:
  Entailment(const owl::Ontology& source, std::span<const std::uint32_t> premise,
             std::span<const std::uint32_t> conclusion, base::Budget* budget)
      : source_(source),
        premise_(premise),
        conclusion_(conclusion),
        budget_(budget),
        answers_(conclusion.size(), Answer{Verdict::yes, {}}),
        excerpt_(source, premise),
        challenger_(excerpt_) {}

  std::vector<Answer> run() {
    answer_told();
    add_groups();
    for (std::size_t at = 0; at < conclusion_.size(); ++at) {
      if (!is_answered_[at]) add_axiom(at);
    }
    const std::vector<Answer> possible = are_possible(excerpt_, challenges_, budget_);
    for (const Part& part : parts_) {
      const Answer answer = conclude(part, possible);
      for (const std::size_t at : part.conclusions) join(answers_[at], answer);
    }
    follow_from_contradiction();
    return std::move(answers_);
  }

 private:
  /// Joins the answers of the parts of one conclusion: each must follow.
  static void join(Answer& all, const Answer& part) {
    const auto rank = [](const Answer& answer) {
      return answer.verdict == Verdict::no ? 2 : answer.verdict == Verdict::unknown ? 1 : 0;
    };
    if (rank(part) > rank(all)) all = part;
  }

  /// Everything follows from a contradiction, also conclusions that cannot be refuted.
  void follow_from_contradiction() {
    const auto is_unknown = [](const Answer& answer) { return answer.verdict == Verdict::unknown; };
    if (std::ranges::none_of(answers_, is_unknown)) return;
    if (is_consistent(excerpt_.source, budget_).verdict != Verdict::no) return;
    for (Answer& answer : answers_) answer = {Verdict::yes, {}};
  }

  /// Declarations follow, and so do axioms that the premise has in the same words.
  void answer_told() {
    is_answered_.assign(conclusion_.size(), false);
    std::map<Content, std::vector<std::size_t>> wanted;
    for (std::size_t at = 0; at < conclusion_.size(); ++at) {
      const owl::Axiom axiom = source_.axiom(conclusion_[at]);
      if (axiom.kind == AxiomKind::declaration) {
        is_answered_[at] = true;
      } else {
        wanted[content_of(axiom)].push_back(at);
      }
    }
    for (const std::uint32_t number : premise_) {
      const auto found = wanted.find(content_of(source_.axiom(number)));
      if (found == wanted.end()) continue;
      for (const std::size_t at : found->second) is_answered_[at] = true;
    }
  }

  void add_groups() {
    std::vector<std::uint32_t> open;
    std::map<std::uint32_t, std::size_t> position;
    for (std::size_t at = 0; at < conclusion_.size(); ++at) {
      if (is_answered_[at]) continue;
      open.push_back(conclusion_[at]);
      position.emplace(conclusion_[at], at);
    }
    for (const auto& group : find_groups(source_, open)) {
      Part part;
      std::vector<Statement> facts;
      for (const std::uint32_t number : group) {
        const owl::Axiom axiom = source_.axiom(number);
        Statement& fact = facts.emplace_back(axiom.kind, std::vector<TermId>{});
        for (const TermId argument : axiom.arguments) fact.arguments.push_back(excerpt_.term(argument));
        part.conclusions.push_back(position.at(number));
        is_answered_[part.conclusions.back()] = true;
      }
      add_group(std::move(part), std::move(facts));
    }
  }

  void add_group(Part part, std::vector<Statement> facts) {
    auto rolled = roll_up(excerpt_, std::move(facts));
    if (!rolled) {
      part.undecided = std::move(rolled.error());
      part.first = part.witnesses = part.last = challenges_.size();
      parts_.push_back(std::move(part));
      return;
    }
    if (rolled->has_expression) {
      add(part, rolled->individual
                    ? challenger_.refute(AxiomKind::class_assertion, {rolled->expression, *rolled->individual})
                    : challenger_.refute_emptiness_everywhere(rolled->expression));
    }
    for (const Statement& fact : rolled->plain) add(part, challenger_.refute(fact.kind, fact.arguments));
  }

  void add_axiom(std::size_t at) {
    const owl::Axiom axiom = source_.axiom(conclusion_[at]);
    std::vector<TermId> arguments;
    for (const TermId argument : axiom.arguments) arguments.push_back(excerpt_.term(argument));
    Part part;
    part.conclusions.push_back(at);
    add(part, challenger_.refute(axiom.kind, arguments));
  }

  void add(Part part, Refutation refutation) {
    const auto append = [&](std::vector<Challenge>& more) {
      std::ranges::move(more, std::back_inserter(challenges_));
      return challenges_.size();
    };
    part.first = challenges_.size();
    part.witnesses = append(refutation.all);
    part.last = append(refutation.witnesses);
    part.undecided = std::move(refutation.undecided);
    parts_.push_back(std::move(part));
  }

  static Answer conclude(const Part& part, const std::vector<Answer>& possible) {
    const std::span<const Answer> all(possible);
    const auto is_possible = [](const Answer& answer) { return answer.verdict == Verdict::yes; };
    if (std::ranges::any_of(all.subspan(part.first, part.last - part.first), is_possible)) return {Verdict::no, {}};
    if (!part.undecided.empty()) return {Verdict::unknown, part.undecided};
    for (const Answer& answer : all.subspan(part.first, part.witnesses - part.first)) {
      if (answer.verdict == Verdict::unknown) return answer;
    }
    return {Verdict::yes, {}};
  }

  const owl::Ontology& source_;
  std::span<const std::uint32_t> premise_;
  std::span<const std::uint32_t> conclusion_;
  base::Budget* budget_;
  std::vector<Answer> answers_;
  std::vector<bool> is_answered_;
  Excerpt excerpt_;
  Challenger challenger_;
  std::vector<Part> parts_;
  std::vector<Challenge> challenges_;
};

}  // namespace

std::vector<Answer> entails_each(const owl::Ontology& source, std::span<const std::uint32_t> premise,
                                 std::span<const std::uint32_t> conclusion, base::Budget* budget) {
  if (source.problem()) return {conclusion.size(), {Verdict::unknown, *source.problem()}};
  return Entailment(source, premise, conclusion, budget).run();
}

}  // namespace geminga::reasoner
