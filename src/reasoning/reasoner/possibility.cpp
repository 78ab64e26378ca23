// Each engine is asked the questions that the ones before it have left open.
#include "reasoning/reasoner/possibility.hpp"

#include <algorithm>
#include <utility>

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/consequence/closure.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/reasoner/unused.hpp"

namespace geminga::reasoner {
namespace {

/// Most questions are answered within the first limit. The second is for those that the tableau leaves open, too.
constexpr consequence::Options few_derived{.clauses = 200'000, .alternatives = 200};
constexpr consequence::Options many_derived{.clauses = 2'000'000};

class Decision {
 public:
  Decision(const Excerpt& excerpt, std::span<const Challenge> challenges, base::Budget* budget)
      : excerpt_(excerpt), challenges_(challenges), budget_(budget), answers_(challenges.size()) {}

  std::vector<Answer> run() {
    const bool has_class = std::ranges::any_of(challenges_, [](const Challenge& asked) { return !!asked.of; });
    if (has_class) {
      ask_el();
      if (is_open()) ask_beyond();
    }
    for (std::size_t at = 0; at < challenges_.size(); ++at) {
      if (!challenges_[at].of) answers_[at] = ask_alone(challenges_[at]);
    }
    return std::move(answers_);
  }

 private:
  [[nodiscard]] bool is_open(std::size_t at) const {
    return challenges_[at].of && answers_[at].verdict == Verdict::unknown;
  }
  [[nodiscard]] bool is_open() const {
    for (std::size_t at = 0; at < challenges_.size(); ++at) {
      if (is_open(at)) return true;
    }
    return false;
  }

  void answer(std::size_t at, Verdict verdict) { answers_[at] = {verdict, {}}; }

  /// If the ontology has no model, no situation is possible.
  void answer_all_impossible() {
    for (Answer& answer : answers_) answer = {Verdict::no, {}};
  }

  /// The first of the given axioms that belongs to the premise or describes the challenge: what was not used of it may
  /// matter. Axioms that describe other challenges do not.
  template <typename UnusedAxioms>
  static const typename UnusedAxioms::value_type* find_unused(const UnusedAxioms& unused, std::size_t premise,
                                                              const Challenge& asked) {
    for (const auto& entry : unused) {
      if (entry.axiom < premise || (entry.axiom >= asked.first_axiom && entry.axiom < asked.last_axiom)) return &entry;
    }
    return nullptr;
  }

  void ask_el() {
    const auto found = el::classify(excerpt_.source, {.budget = budget_});
    if (!found) return;
    if (!found->is_consistent) return answer_all_impossible();
    const taxonomy::ClassNumber empty = found->representative[static_cast<std::size_t>(found->nothing)];
    const auto name = [&](owl::NameId id) { return excerpt_.source.name(id); };
    for (std::size_t at = 0; at < challenges_.size(); ++at) {
      if (!is_open(at)) continue;
      const auto place =
          std::ranges::lower_bound(found->classes, excerpt_.source.name_of(*challenges_[at].of), {}, name);
      const auto number = static_cast<std::size_t>(place - found->classes.begin());
      if (found->representative[number] == empty) {
        answer(at, Verdict::no);
      } else if (!found->is_cut_off && find_unused(found->unused, excerpt_.copied, challenges_[at]) == nullptr) {
        answer(at, Verdict::yes);
      }
    }
  }

  void ask_beyond() {
    std::vector<owl::TermId> classes;
    std::vector<std::size_t> asked;
    for (std::size_t at = 0; at < challenges_.size(); ++at) {
      if (!is_open(at)) continue;
      asked.push_back(at);
      classes.push_back(*challenges_[at].of);
    }
    const auto clauses = clauses::clausify(excerpt_.source, std::nullopt, classes);
    if (!clauses) {
      for (const std::size_t at : asked) answers_[at].reason = clauses.error().text;
      return;
    }
    if (!ask_consequence(*clauses, asked, few_derived)) return;
    ask_tableau(*clauses, asked);
    if (is_open()) (void)ask_consequence(*clauses, asked, many_derived);
  }

  /// False if everything is answered at once. Reasons that are known already stay.
  bool ask_consequence(const clauses::ClauseSet& clauses, const std::vector<std::size_t>& asked,
                       consequence::Options limits) {
    limits.budget = budget_;
    const consequence::Closure closure = consequence::saturate(excerpt_.source, clauses, clauses.queries, limits);
    if (!closure.is_consistent) {
      answer_all_impossible();
      return false;
    }
    for (std::size_t query = 0; query < asked.size(); ++query) {
      if (!is_open(asked[query])) continue;
      const auto& above = closure.subsumers[query];
      if (std::ranges::find(above, clauses::nothing) != above.end()) {
        answer(asked[query], Verdict::no);
      } else if (closure.gaps.empty() &&
                 find_unused(clauses.unused, excerpt_.copied, challenges_[asked[query]]) == nullptr) {
        answer(asked[query], Verdict::yes);
      }
    }
    return true;
  }

  void ask_tableau(const clauses::ClauseSet& clauses, const std::vector<std::size_t>& asked) {
    hypertableau::Tableau tableau(excerpt_.source, clauses, {.budget = budget_});
    for (std::size_t query = 0; query < asked.size(); ++query) {
      Answer& answer = answers_[asked[query]];
      if (answer.verdict != Verdict::unknown) continue;
      answer = tableau.is_satisfiable({clauses.queries[query]});
      if (answer.verdict != Verdict::yes) continue;
      if (const auto* unused = find_unused(clauses.unused, excerpt_.copied, challenges_[asked[query]]))
        answer = {Verdict::unknown, describe_unused(excerpt_.source, unused->axiom, unused->construct)};
    }
  }

  [[nodiscard]] Answer ask_alone(const Challenge& asked) const {
    Excerpt world = excerpt_;
    for (const Statement& statement : asked.statements) world.add(statement);
    return is_consistent(world.source, budget_);
  }

  const Excerpt& excerpt_;
  std::span<const Challenge> challenges_;
  base::Budget* budget_;
  std::vector<Answer> answers_;
};

}  // namespace

std::vector<Answer> are_possible(const Excerpt& excerpt, std::span<const Challenge> challenges, base::Budget* budget) {
  return Decision(excerpt, challenges, budget).run();
}

}  // namespace geminga::reasoner
