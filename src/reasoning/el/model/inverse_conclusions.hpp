// Conclusions that a context draws from its successors because inverses tell these of the context.
#ifndef GEMINGA_REASONING_EL_MODEL_INVERSE_CONCLUSIONS_HPP
#define GEMINGA_REASONING_EL_MODEL_INVERSE_CONCLUSIONS_HPP

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/interner.hpp"
#include "reasoning/el/closure/saturation.hpp"
#include "reasoning/el/model/inverse_roles.hpp"
#include "reasoning/el/model/limits.hpp"

namespace geminga::el {

/// Pairs of a context and an expression that it is in, ascending, without doubles. All of them follow (Lemma 7).
using InverseConclusions = std::vector<std::pair<std::uint32_t, ExprId>>;

/// Looks at each link of a saturation as a successor context: the context at its end, with what it learns of the
/// beginning of the link. Successor contexts that learn the same are one.
class SuccessorContexts {
 public:
  SuccessorContexts(const IndexedOntology& index, const Saturation& saturation, const InverseRoles& roles,
                    const SuccessorLimits& limits);

  /// The conclusions that the saturation lacks.
  [[nodiscard]] InverseConclusions conclude();
  /// True if the budget was spent before all links were looked at.
  [[nodiscard]] bool is_cut_off() const { return is_cut_off_; }

 private:
  struct Successor {
    std::uint32_t context = 0;
    ExprId learned{};
    std::uint32_t begin = 0;  ///< in grown_
    std::uint32_t end = 0;
  };

  [[nodiscard]] std::vector<std::vector<Link>> links_that_teach();
  [[nodiscard]] std::span<const ExprId> find_grown(std::uint32_t context, ExprId learned);
  void grow(Successor& successor);
  void add(Successor& successor, ExprId expr);
  void add_conjunctions(Successor& successor, ExprId expr);
  [[nodiscard]] bool is_in(std::uint32_t context, ExprId expr) const {
    return saturation_.contexts()[context].subsumers.contains(number(expr));
  }
  [[nodiscard]] std::span<const ExprId> grown(const Successor& successor) const {
    return std::span(grown_).subspan(successor.begin, successor.end - successor.begin);
  }
  [[nodiscard]] bool spend(std::size_t steps);

  const IndexedOntology& index_;
  const Saturation& saturation_;
  const InverseRoles& roles_;
  SuccessorLimits limits_;
  base::BudgetUse use_;
  std::vector<Successor> successors_;
  base::NumberTable table_;
  std::vector<ExprId> grown_;
  bool is_cut_off_ = false;
};

}  // namespace geminga::el

#endif
