// The subsumptions between named classes that are lost with axioms that are taken out.
#ifndef GEMINGA_ONTOLOGY_REPAIR_LOSS_HPP
#define GEMINGA_ONTOLOGY_REPAIR_LOSS_HPP

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/budget.hpp"
#include "ontology/loading/closure.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::ontology {

/// Compares what follows from an ontology with what follows from parts of it. Borrows the source and the budget.
class Losses {
 public:
  /// `classes` are those of the compiled form of the source.
  Losses(const owl::Ontology& source, const compiled::Ontology& ontology, base::Budget& budget);

  /// The subsumptions that follow without these axioms of the source, ascending. Nothing if there are too many
  /// subsumptions or the budget is spent.
  [[nodiscard]] std::optional<Closure> closure_without(std::span<const std::uint32_t> removed);

 private:
  const owl::Ontology& source_;
  base::Budget& budget_;
  ClassNumbers numbers_;
};

/// For each closure the subsumptions that it lacks and the whole ontology or another closure has: those of classes that
/// can have instances in it.
[[nodiscard]] std::vector<std::vector<Subsumption>> lost_in(const Closure& whole, std::span<const Closure> closures);

}  // namespace geminga::ontology

#endif
