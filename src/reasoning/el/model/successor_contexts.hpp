// What a successor is in beyond its context, because inverses tell it of what leads to it.
//
// The model that is tested is a tree in which every link of a context leads to a copy of its own of another context. A
// copy is in what its context is in and in what it learns of its source; what follows from that for the copy alone is
// closed here, so that a class of which only a successor is an instance ("the finger that is part of some hand") costs
// nothing. A copy may grow by subsumers that stand for themselves. Where more would follow, a new successor, a clash,
// something that its source has not, nothing is known of the source.
//
// Nothing is missed: let every copy be in what its context is in and in what it has grown by. Walks along the words of
// a property S go from copy to copy, along links and against them. A walk down is one of the links of a context, which
// are closed. A walk that begins up, from a copy to its source, goes on as a walk of its own in the source
// (InverseRoles::is_known), so the copy is in `S some D` if the source is in D or in `S some D`: which it has learned.
// A walk that comes down to a copy reaches what that has grown by: which its source must be in already. So no rule has
// a conclusion that is not drawn.
#ifndef GEMINGA_REASONING_EL_MODEL_SUCCESSOR_CONTEXTS_HPP
#define GEMINGA_REASONING_EL_MODEL_SUCCESSOR_CONTEXTS_HPP

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "base/interner.hpp"
#include "base/rows.hpp"
#include "reasoning/el/closure/saturation.hpp"
#include "reasoning/el/model/inverse_roles.hpp"
#include "reasoning/el/model/limits.hpp"

namespace geminga::el {

class SuccessorContexts {
 public:
  /// What a context may learn.
  enum class Growth : std::uint8_t { free, not_needed, forbidden };
  /// What the contexts of a saturation say of growing.
  struct Growing {
    std::vector<bool> may_grow;  ///< by expression: it has no rules but those that are looked at here
    std::function<Growth(std::uint32_t context, ExprId learned)> growth;
    /// Whether a copy of the one may have a successor in the other.
    std::function<bool(std::uint32_t from, RoleId role, std::uint32_t to)> may_lead_to;
  };
  SuccessorContexts(const IndexedOntology& index, const Saturation& saturation, const InverseRoles& roles,
                    Growing growing, const SuccessorLimits& limits = {});

  /// What follows for a context from what its successors learn of it: it is in the expression.
  using Derived = std::vector<std::pair<std::uint32_t, ExprId>>;
  [[nodiscard]] Derived derived() const;

  /// Adds the contexts of whose successors more is not known. Where it does, more may be failing than before.
  [[nodiscard]] bool spread(std::vector<bool>& failing);

  /// Whether the budget was spent before all was looked at. Then nothing is known of any context.
  [[nodiscard]] bool is_cut_off() const { return is_cut_off_; }

 private:
  /// One thing that copies of a context learn, and what they grow by for it.
  struct Copy {
    std::uint32_t context = 0;
    ExprId learned{};
    std::uint32_t begin = 0;  ///< in grown_
    std::uint32_t end = 0;
    bool is_open = false;    ///< more follows than is looked at
    bool has_links = false;  ///< it has successors that its context has not
  };
  struct NewLink {
    std::uint32_t copy = 0;
    Link link;
  };
  static constexpr std::uint32_t none = base::NumberTable::none;

  /// Counts work, and whether it may go on.
  void spend(std::size_t steps);
  void index_links();
  void learn_of_contexts();
  [[nodiscard]] std::uint32_t find(std::uint32_t context, ExprId learned) const;
  std::uint32_t learn(std::uint32_t context, ExprId learned);
  void grow(std::uint32_t copy);
  void add(std::uint32_t copy, ExprId expr);
  void add_above(std::uint32_t copy, ExprId expr);
  void add_link(std::uint32_t copy, const LinkRule& rule);
  void recognise(std::uint32_t copy, Link link);
  void add_conjunctions(std::uint32_t copy, ExprId expr);
  void teach_all();
  void teach_successors(std::uint32_t copy);
  void teach_new_successors();
  void meet();
  void meet_at(std::span<const std::uint32_t> copies);
  void look_back();
  [[nodiscard]] bool is_in(std::uint32_t context, ExprId expr) const {
    return saturation_.contexts()[context].subsumers.contains(number(expr));
  }
  [[nodiscard]] bool has_grown(std::uint32_t copy, ExprId expr) const;
  [[nodiscard]] std::span<const ExprId> grown(std::uint32_t copy) const {
    return std::span(grown_).subspan(copies_[copy].begin, copies_[copy].end - copies_[copy].begin);
  }
  template <typename IsIn>
  [[nodiscard]] bool tells_nothing_new(std::uint32_t copy, RoleId link, IsIn&& is_in_source) const;

  const IndexedOntology& index_;
  const Saturation& saturation_;
  const InverseRoles& roles_;
  Growing growing_;
  SuccessorLimits limits_;
  base::BudgetUse use_;
  base::Rows<Link> forward_;  ///< by context: links whose end learns something
  std::vector<Copy> copies_;
  base::NumberTable table_;
  std::vector<ExprId> grown_;
  struct Lesson {
    std::uint32_t source = 0;  ///< a copy
    RoleId role{};
    std::uint32_t copy = 0;
  };
  std::vector<Lesson> lessons_;
  std::vector<NewLink> new_links_;  ///< ascending by copy
  /// Properties of which a copy is within a word that no expression stands for.
  std::vector<std::pair<std::uint32_t, RoleId>> parts_;  ///< ascending by copy
  bool is_over_limit_ = false;
  bool is_cut_off_ = false;  ///< it was the budget
  bool is_spread_ = false;
};

}  // namespace geminga::el

#endif
