// Answers whether some axioms entail that one class is below another, with the cheapest engine that knows.
#ifndef GEMINGA_REASONER_EXPLAIN_ORACLE_HPP
#define GEMINGA_REASONER_EXPLAIN_ORACLE_HPP

#include <cstddef>
#include <cstdint>
#include <span>

#include "el/entailment.hpp"
#include "el/source.hpp"

namespace geminga::reasoner {

/// Asks about one source, which must outlive it and may grow. Every yes is sound. It counts its work.
class Oracle {
 public:
  explicit Oracle(const el::OntologySource& source) : source_(source) {}

  /// As far as the rules of EL carry; they are so much cheaper than the rest that they are always asked first.
  [[nodiscard]] el::Entailed find_by_rules(std::span<const std::uint32_t> axioms, el::TermId sub, el::TermId super);
  /// With every engine. What cannot be decided within an engine's limits counts as not entailed.
  [[nodiscard]] bool holds(std::span<const std::uint32_t> axioms, el::TermId sub, el::TermId super);

  /// Axioms that were asked about, over all questions: the same everywhere for the same questions.
  [[nodiscard]] std::size_t work() const { return work_; }
  /// A question was left undecided.
  [[nodiscard]] bool was_undecided() const { return was_undecided_; }

 private:
  const el::OntologySource& source_;
  std::size_t work_ = 0;
  bool was_undecided_ = false;
};

}  // namespace geminga::reasoner

#endif
