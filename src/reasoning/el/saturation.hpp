// The closure of the rules: one context a concept, with everything that subsumes it and the links that end in it.
//
// The calculus is that of ELK (Kazakov, Kroetzsch, Simancik: The Incredible ELK, 2014) with three changes: only
// expressions that have rules enter a context (what merely stands above in the told hierarchy is found again by the
// taxonomy), told equivalents are one expression, and nominals are exact (nominals.hpp).
//
// Legend: C D E contexts and expressions, R S roles, C < D "C SubClassOf D", R <* S the role hierarchy,
// C -R-> D "everything in C has an R successor in D", T owl:Thing, F owl:Nothing, {a} a nominal; a rule's premises
// stand above the line, its conclusion below, its side condition in brackets.
#ifndef GEMINGA_REASONING_EL_SATURATION_HPP
#define GEMINGA_REASONING_EL_SATURATION_HPP

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "reasoning/el/context.hpp"
#include "reasoning/el/indexed_ontology.hpp"
#include "reasoning/el/limits.hpp"

namespace geminga::el {

class SaturationWorker;

/// What the workers of one saturation share.
struct Saturating {
  Saturating(const IndexedOntology& of, const SaturationLimits& within);

  const IndexedOntology& index;
  SaturationLimits limits;
  bool keeps_forward;  ///< all forward links, not only those that chains want
  ContextStore contexts;
  std::vector<std::atomic<std::uint32_t>> context_of;  ///< by atom: no_context, claimed_context, or the number and 2
  std::mutex together_mutex;                           ///< guards the next two
  std::map<std::vector<ExprId>, std::uint32_t> context_of_some;
  std::size_t merged_atoms = 0;
  std::atomic<bool> is_inconsistent = false;
  std::atomic<bool> is_over_limit = false;
  std::atomic<bool> is_over_merged = false;  ///< it was the limit of merged atoms
  std::atomic<bool> is_cut_off = false;      ///< it was the budget

  static constexpr std::uint32_t no_context = 0;
  static constexpr std::uint32_t claimed_context = 1;

  [[nodiscard]] bool has_ended() const {
    return is_inconsistent.load(std::memory_order_relaxed) || is_over_limit.load(std::memory_order_relaxed);
  }
};

/// Saturates contexts on demand. To be used by one thread; the index may be shared.
class Saturation {
 public:
  explicit Saturation(const IndexedOntology& index, const SaturationLimits& limits);
  Saturation(const IndexedOntology& index, std::size_t max_conclusions)
      : Saturation(index, SaturationLimits{.conclusions = max_conclusions}) {}
  Saturation(const Saturation&) = delete;
  Saturation& operator=(const Saturation&) = delete;
  ~Saturation();

  /// Asks for the context of an atom that is its own representative.
  std::uint32_t require(ExprId root);
  /// Says that what is in a context is in an expression, of which the rules do not find it; for the next run().
  void conclude(std::uint32_t context, ExprId expr);
  /// Says that a context has an instance in every model.
  void require_nonempty(std::uint32_t context);
  /// Applies rules until none is left to fire, or the ontology is found inconsistent. False over a limit. What is
  /// derived does not depend on the number of threads, but for what an unsatisfiable context had derived before it was
  /// known to be one, and the numbers of contexts. Where there are nominals, one thread does it.
  bool run(unsigned threads = 1);

  [[nodiscard]] bool is_consistent() const { return !shared_.is_inconsistent; }
  [[nodiscard]] bool is_over_limit() const { return shared_.is_over_limit; }
  /// Whether run() ended because too many successors of functional properties had to be merged.
  [[nodiscard]] bool is_over_merged() const { return shared_.is_over_merged; }
  /// Whether run() ended because the budget was spent.
  [[nodiscard]] bool is_cut_off() const { return shared_.is_cut_off; }
  [[nodiscard]] const ContextStore& contexts() const { return shared_.contexts; }
  /// The context of an atom, or null where nobody asked for it.
  [[nodiscard]] const Context* find(ExprId root) const;
  /// The number of an atom's context; there must be one.
  [[nodiscard]] std::uint32_t number_of(ExprId root) const { return shared_.context_of[number(root)] - 2; }
  [[nodiscard]] std::size_t conclusion_count() const;
  [[nodiscard]] std::size_t link_count() const;

 private:
  Saturating shared_;
  std::vector<std::unique_ptr<SaturationWorker>> workers_;  ///< their arenas hold what contexts know, so they are kept
};

}  // namespace geminga::el

#endif
