// The subsumptions between named classes that are lost with axioms that are taken out.
#ifndef GEMINGA_ONTOLOGY_REPAIR_LOSS_HPP
#define GEMINGA_ONTOLOGY_REPAIR_LOSS_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/budget.hpp"
#include "ontology/repair/unwanted.hpp"
#include "reasoning/owl/source.hpp"
#include "reasoning/taxonomy/classification.hpp"

namespace geminga::ontology {

/// The most subsumptions of an ontology whose losses are counted.
inline constexpr std::size_t max_compared_subsumptions = 4'000'000;

/// The subsumptions between different classes that can have instances, without those of owl:Thing: ascending.
struct Closure {
  std::vector<Subsumption> pairs;
  std::vector<bool> is_empty;  ///< by class: it can have no instance
};

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
  std::unordered_map<std::string_view, std::uint32_t> numbers_;  ///< of classes, by IRI
};

/// For each closure the subsumptions that it lacks and the whole ontology or another closure has: those of classes that
/// can have instances in it.
[[nodiscard]] std::vector<std::vector<Subsumption>> lost_in(const Closure& whole, std::span<const Closure> closures);

/// Those of the lost subsumptions that follow from no other one and what is kept, up to so many.
[[nodiscard]] std::vector<Subsumption> telling(const std::vector<Subsumption>& lost, const Closure& kept,
                                               std::size_t most);

}  // namespace geminga::ontology

#endif
