// Entailments from few axioms, asked of the cheapest engine that can decide.
#ifndef GEMINGA_REASONING_EXPLANATION_EXPLAIN_ORACLE_HPP
#define GEMINGA_REASONING_EXPLANATION_EXPLAIN_ORACLE_HPP

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "base/budget.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"
#include "reasoning/el/entailment.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::explanation {

/// The bound of the engines beyond the rules of EL. It counts work, so that the answer is the same everywhere.
enum class Patience : std::uint8_t {
  of_a_person,  ///< for a command line
  of_a_daemon,  ///< for a daemon, which serves others on the same thread
};

/// Asks about one source, which must outlive it and may grow. Every yes is sound. After some questions that were too
/// hard, holds() asks the rules only. Once the budget is spent, nothing is found to hold.
class Oracle {
 public:
  /// The budget is borrowed; null: no limit beside patience.
  explicit Oracle(const owl::Ontology& source, Patience patience = Patience::of_a_person,
                  base::Budget* budget = nullptr)
      : source_(source), patience_(patience), budget_(budget) {}

  /// The answer of the rules of EL alone, which are much cheaper than the other engines.
  [[nodiscard]] el::Entailed find_by_rules(std::span<const std::uint32_t> axioms, owl::TermId sub, owl::TermId super);
  /// The answer of every engine. A question that no engine decides within its limits counts as not entailed.
  [[nodiscard]] bool holds(std::span<const std::uint32_t> axioms, owl::TermId sub, owl::TermId super);

  /// The answer of every engine, in which a no is certain, too.
  struct Decision {
    hypertableau::Verdict verdict = hypertableau::Verdict::unknown;
    std::string reason{};      ///< of unknown: one line for a user
    bool is_too_hard = false;  ///< of unknown: a limit ended the search
  };
  [[nodiscard]] Decision decide(std::span<const std::uint32_t> axioms, owl::TermId sub, owl::TermId super);

  /// The number of axioms that were asked about in all questions. The same everywhere for the same questions.
  [[nodiscard]] std::size_t work() const { return work_; }
  /// The number of questions that stayed undecided.
  [[nodiscard]] std::size_t undecided_count() const { return undecided_; }
  [[nodiscard]] bool is_spent() const { return budget_ != nullptr && budget_->is_spent(); }

 private:
  [[nodiscard]] Decision decide_beyond_rules(std::span<const std::uint32_t> axioms, owl::TermId sub, owl::TermId super);

  /// Counts the axioms of a question. False if the budget is spent.
  bool count(std::size_t work);

  const owl::Ontology& source_;
  Patience patience_;
  base::Budget* budget_;
  std::size_t work_ = 0;
  std::size_t undecided_ = 0;
  std::size_t first_turn_ = 0;  ///< the first bound of the next question to the engines beyond the rules
  bool derives_first_ = false;  ///< in the next question; otherwise a model is built first
};

}  // namespace geminga::explanation

#endif
