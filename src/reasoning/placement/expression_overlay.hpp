// The contexts of one expression, laid over a base that never changes.
//
// A new context links into the base. The contexts there are saturated, so that every conclusion is drawn when the link
// is made, and nothing is added to the base. The rules are those of el/closure/rules.hpp, and the legend is that of
// el/closure/saturation.hpp. X stands for a context of the overlay.
#ifndef GEMINGA_REASONING_PLACEMENT_EXPRESSION_OVERLAY_HPP
#define GEMINGA_REASONING_PLACEMENT_EXPRESSION_OVERLAY_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "reasoning/el/closure/rules.hpp"
#include "reasoning/placement/expression_base.hpp"
#include "reasoning/placement/expression_shape.hpp"

namespace geminga::placement {

/// The atoms and shapes whose conjunction a context of the overlay stands for, ascending. Numbers of shapes follow
/// those of the base's expressions.
using Seeds = std::vector<std::uint32_t>;

struct OverlayContext {
  Seeds seeds;
  bool is_unsatisfiable = false;
  base::GrowingSet<std::uint32_t> subsumers;
  std::uint32_t subsumers_done = 0;
  base::GrowingSet<el::Link> forward;
  std::uint32_t forward_done = 0;
  std::vector<el::Link> backward;       ///< from contexts of the overlay
  std::vector<el::ExprId> propagating;  ///< subsumers with existential rules
  std::vector<el::RoleId> selfs;
  std::uint32_t selfs_done = 0;
  std::vector<el::FunctionalGroup> groups;
  std::vector<el::RoleId> functional;       ///< at most one successor, by a shape
  base::GrowingSet<std::uint32_t> derived;  ///< atoms that were asserted or derived
  std::vector<ShapeId> universals;          ///< `R only C`
  std::vector<ShapeId> negations;           ///< shapes that must not hold
};

class ExpressionOverlay : private el::Rules<ExpressionOverlay> {
 public:
  ExpressionOverlay(const ExpressionBase& base, const ShapeReader& shapes);

  /// The context of the conjunction of these shapes, which may be one of the base. run() draws its conclusions.
  std::uint32_t require(std::span<const ShapeId> together);
  /// The context of another context's seeds, which may be in another overlay, and of a shape.
  std::uint32_t require_with(Seeds seeds, ShapeId shape);
  [[nodiscard]] Seeds seeds_of(std::uint32_t context) const;
  /// Applies the rules until none can fire. False if the limit was reached; what was derived is right all the same.
  bool run();
  /// Makes a context unsatisfiable. run() draws the conclusions.
  void add_bottom(std::uint32_t context);

  [[nodiscard]] const ExpressionBase& base() const { return base_; }
  /// The number of contexts. Those of the base come first.
  [[nodiscard]] std::uint32_t context_count() const { return base_count_ + static_cast<std::uint32_t>(own_.size()); }
  [[nodiscard]] std::span<const OverlayContext> own() const { return own_; }
  [[nodiscard]] std::uint32_t base_count() const { return base_count_; }
  [[nodiscard]] bool is_unsatisfiable(std::uint32_t context) const;
  /// True if more may follow for an expression that has an instance.
  [[nodiscard]] bool is_conditional() const { return is_conditional_; }
  [[nodiscard]] std::size_t work() const { return work_; }
  /// All atoms above a context: representatives, ascending.
  [[nodiscard]] std::vector<el::ExprId> atoms_above(std::uint32_t context) const;

 private:
  friend class el::Rules<ExpressionOverlay>;
  [[nodiscard]] OverlayContext& own(std::uint32_t context) { return own_[context - base_count_]; }
  [[nodiscard]] bool is_own(std::uint32_t context) const { return context >= base_count_; }
  [[nodiscard]] std::span<const el::Link> forward_of(std::uint32_t context) const;
  [[nodiscard]] std::span<const el::ExprId> propagating_of(std::uint32_t context) const;
  void add_seed(Seeds& seeds, ShapeId shape) const;
  std::uint32_t context_of(Seeds seeds);
  std::uint32_t context_of_atom(el::ExprId atom);
  void enqueue(std::uint32_t context);
  void process(std::uint32_t context);
  void assert_shape(std::uint32_t context, ShapeId shape);
  void add_successor(std::uint32_t context, el::RoleId role, ShapeId filler);
  void process_subsumer(std::uint32_t context, el::ExprId subsumer);
  void process_nominal(std::uint32_t context, el::ExprId nominal);
  void process_link(std::uint32_t context, el::Link link);
  void apply_universal(std::uint32_t context, ShapeId universal, el::Link link);

  // A closure for el::Rules, of contexts of the overlay.
  static constexpr bool inherits = false;
  void add_subsumer(std::uint32_t context, el::ExprId subsumer);
  void add_atom(std::uint32_t context, el::ExprId atom);
  void add_link(std::uint32_t from, el::RoleId role, std::uint32_t to);
  void add_self(std::uint32_t context, el::RoleId role);
  void add_loop(std::uint32_t context, el::RoleId role);
  void add_filler(std::uint32_t context, el::ExprId subsumer);
  void add_member(std::uint32_t context, std::uint32_t seed);
  [[nodiscard]] bool add_mark(std::uint32_t context, std::uint32_t mark) { return own(context).subsumers.insert(mark); }
  [[nodiscard]] std::uint32_t successor_of(std::uint32_t /*context*/, const el::LinkRule& link) {
    return context_of_atom(link.target);
  }
  [[nodiscard]] bool is_functional_in(std::uint32_t context, el::RoleId role);
  [[nodiscard]] Seeds members_of(std::uint32_t context) const { return seeds_of(context); }
  [[nodiscard]] std::uint32_t require_together(const Seeds& seeds) { return context_of(seeds); }
  [[nodiscard]] const auto& subsumers(std::uint32_t context) { return own(context).subsumers; }
  [[nodiscard]] const auto& selfs(std::uint32_t context) { return own(context).selfs; }
  [[nodiscard]] std::uint32_t selfs_done(std::uint32_t context) { return own(context).selfs_done; }
  [[nodiscard]] const auto& forward(std::uint32_t context) { return own(context).forward; }
  /// Links that are not processed yet may be met, too.
  [[nodiscard]] std::size_t forward_done(std::uint32_t context) { return own(context).forward.size(); }
  [[nodiscard]] std::vector<el::FunctionalGroup>& groups(std::uint32_t context) { return own(context).groups; }
  /// An overlay is limited by conclusions, not by premises.
  void count_work(std::size_t /*premises*/) {}

  const ExpressionBase& base_;
  const ShapeReader& shapes_;
  std::uint32_t base_count_;
  std::uint32_t size_;  ///< of the index: seeds from here on are shapes
  std::vector<OverlayContext> own_;
  std::map<Seeds, std::uint32_t> context_of_seeds_;
  std::vector<std::uint32_t> queue_;
  std::size_t work_ = 0;
  bool is_conditional_ = false;
};

}  // namespace geminga::placement

#endif
