// The closure of the rules: one context for each concept, with its subsumers and the links that end in it.
//
// The calculus is that of ELK (Kazakov, Kroetzsch, Simancik: The Incredible ELK, 2014) with three changes. Only
// expressions that have rules enter a context; the taxonomy finds the others in the told hierarchy. Told equivalents
// are one expression. Nominals are exact (worlds.hpp).
//
// Legend: C D E contexts and expressions, R S roles, C < D "C SubClassOf D", R <* S the role hierarchy,
// C -R-> D "everything in C has an R successor in D", T owl:Thing, F owl:Nothing, {a} a nominal; a rule's premises
// stand above the line, its conclusion below, its side condition in brackets.
#ifndef GEMINGA_REASONING_EL_CLOSURE_SATURATION_HPP
#define GEMINGA_REASONING_EL_CLOSURE_SATURATION_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "reasoning/el/closure/conclusions.hpp"
#include "reasoning/el/closure/context.hpp"
#include "reasoning/el/closure/limits.hpp"
#include "reasoning/el/index/indexed_ontology.hpp"

namespace geminga::el {

class SaturationWorker;

/// Saturates contexts on demand. One thread may use it; the index may be shared.
class Saturation {
 public:
  explicit Saturation(const IndexedOntology& index, const SaturationLimits& limits);
  Saturation(const IndexedOntology& index, std::size_t max_conclusions)
      : Saturation(index, SaturationLimits{.conclusions = max_conclusions}) {}
  Saturation(const Saturation&) = delete;
  Saturation& operator=(const Saturation&) = delete;
  ~Saturation();

  /// The context of an atom that is its own representative; makes it if there is none.
  std::uint32_t require(ExprId root);
  /// Adds a subsumer that the rules do not find. The next run() draws the conclusions.
  void conclude(std::uint32_t context, ExprId expr);
  /// States that the context has an instance in every model.
  void require_nonempty(std::uint32_t context);
  /// Applies rules until none can fire or the ontology is found inconsistent. False over a limit. The conclusions do
  /// not depend on the number of threads, except those about a context before it is known to be unsatisfiable, and the
  /// numbers of contexts. Ontologies with nominals are saturated by one thread.
  bool run(unsigned threads = 1);

  [[nodiscard]] bool is_consistent() const { return !shared_.is_inconsistent; }
  [[nodiscard]] bool is_over_limit() const { return shared_.is_over_limit; }
  /// True if run() ended because too many successors of functional properties had to be merged.
  [[nodiscard]] bool is_over_merged() const { return shared_.is_over_merged; }
  /// True if run() ended because the budget was spent.
  [[nodiscard]] bool is_cut_off() const { return shared_.is_cut_off; }
  [[nodiscard]] const ContextStore& contexts() const { return shared_.contexts; }
  /// The context of an atom, or null if it was never required.
  [[nodiscard]] const Context* find(ExprId root) const;
  /// The number of an atom's context. Requires that there is one.
  [[nodiscard]] std::uint32_t number_of(ExprId root) const { return shared_.context_of[number(root)] - 2; }
  [[nodiscard]] std::size_t conclusion_count() const;
  [[nodiscard]] std::size_t link_count() const;

 private:
  SharedContexts shared_;
  std::vector<std::unique_ptr<SaturationWorker>> workers_;  ///< their arenas hold the contents of contexts
};

}  // namespace geminga::el

#endif
