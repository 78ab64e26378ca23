// Answers whether some axioms entail that one class is below another, with the cheapest engine that knows.
#ifndef GEMINGA_REASONING_EXPLANATION_EXPLAIN_ORACLE_HPP
#define GEMINGA_REASONING_EXPLANATION_EXPLAIN_ORACLE_HPP

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "reasoning/dl/hypertableau/tableau.hpp"
#include "reasoning/el/entailment.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::explanation {

/// How much the engines beyond the rules of EL may do. The bounds count work, so that the answer is the same
/// everywhere.
enum class Patience : std::uint8_t {
  of_a_person,  ///< who asked a program on a command line
  of_a_daemon,  ///< which has others to serve, on the same thread
};

/// Asks about one source, which must outlive it and may grow. Every yes is sound. After some questions that were too
/// hard, holds() only asks the rules.
class Oracle {
 public:
  explicit Oracle(const owl::Ontology& source, Patience patience = Patience::of_a_person)
      : source_(source), patience_(patience) {}

  /// By the rules of EL alone. They are so much cheaper than the rest that they are always asked first.
  [[nodiscard]] el::Entailed find_by_rules(std::span<const std::uint32_t> axioms, owl::TermId sub, owl::TermId super);
  /// By every engine. What an engine cannot decide within its limits counts as not entailed.
  [[nodiscard]] bool holds(std::span<const std::uint32_t> axioms, owl::TermId sub, owl::TermId super);

  /// The same by every engine, where a no must be certain, too.
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

 private:
  [[nodiscard]] Decision decide_by_models(std::span<const std::uint32_t> axioms, owl::TermId sub, owl::TermId super);

  const owl::Ontology& source_;
  Patience patience_;
  std::size_t work_ = 0;
  std::size_t undecided_ = 0;
};

}  // namespace geminga::explanation

#endif
