// The meeting of two saturated contexts: whether an element can be in both, decided from their conclusions if possible.
//
// Rules with one premise, and rules whose premises are both in one of the contexts, have fired there. An element of
// both has more conclusions only by rules with a premise from each: conjunctions, disjointness, functional properties,
// reflexive restrictions (Self), and individuals. If no such rule can fire, it has the conclusions of both and no more,
// and it is possible. So most complements need no context of their own (expression_members.cpp): on SOMA 0.2 ms instead
// of 14.
#ifndef GEMINGA_REASONING_PLACEMENT_EXPRESSION_MEETING_HPP
#define GEMINGA_REASONING_PLACEMENT_EXPRESSION_MEETING_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/placement/expression_overlay.hpp"

namespace geminga::placement {

enum class Meeting : std::uint8_t {
  possible,    ///< an element can be in both
  impossible,  ///< no element can
  unknown,     ///< the rules must be applied to a context of both
};

/// One context, of the base or of an overlay, to be compared with others.
class MeetingPoint {
 public:
  /// The context must be saturated and satisfiable. The overlay must outlive this and make no more contexts meanwhile.
  MeetingPoint(const ExpressionOverlay& overlay, std::uint32_t context);

  /// Compares it with a satisfiable context of the base.
  [[nodiscard]] Meeting with(std::uint32_t other);

 private:
  struct Side {
    std::span<const std::uint32_t> subsumers;
    std::span<const el::RoleId> selfs;
    bool is_plain = true;  ///< only the rules that are looked at here matter
    bool has_functional_rules = false;
    bool has_functional_links = false;  ///< has links of a role that may be functional
  };
  [[nodiscard]] Side side_of(std::uint32_t context) const;
  [[nodiscard]] Side looked_through(Side side, std::span<const el::Link> forward) const;
  [[nodiscard]] bool are_selfs_same(const Side& one, const Side& other) const;
  [[nodiscard]] bool has_new_conjunction(std::uint32_t subsumer, std::uint32_t other) const;
  [[nodiscard]] bool is_excluded(std::uint32_t subsumer) const;

  const ExpressionOverlay& overlay_;
  const ExpressionBase& base_;
  const el::IndexedOntology& index_;
  Side own_;
  std::vector<bool> holds_;               ///< by expression: this point has it
  std::vector<std::uint32_t> member_of_;  ///< by axiom of disjointness: the member that this point has
  std::vector<std::uint32_t> seen_in_;    ///< by expression: the last other context that has it
};

}  // namespace geminga::placement

#endif
