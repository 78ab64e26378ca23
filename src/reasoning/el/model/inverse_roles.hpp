// What inverses make of a link: further links between the same two, and what the end of it learns of its beginning.
//
// Legend as in indexed_ontology.hpp. R(x,y) says S(y,x) where S is told to be an inverse of R or of something above it.
// So what x is in may put y into `S some D`, through words of S that go back along links: the automaton of S with
// inverses says which (Horrocks, Kutz, Sattler: The Even More Irresistible SROIQ, 2006).
#ifndef GEMINGA_REASONING_EL_MODEL_INVERSE_ROLES_HPP
#define GEMINGA_REASONING_EL_MODEL_INVERSE_ROLES_HPP

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/el/index/implied_roles.hpp"
#include "reasoning/el/index/indexed_ontology.hpp"
#include "reasoning/el/index/open_parts.hpp"
#include "reasoning/owl/automaton.hpp"
#include "reasoning/owl/role_box.hpp"

namespace geminga::el {

/// x -R-> y, where something is recognised as `S some D`.
struct Learning {
  RoleId role{};             ///< S
  bool filler = false;       ///< y is in S some D where x is in D
  bool further = false;      ///< y is in S some D where x is
  bool recognises = false;   ///< x is in S some D where y is in D
  bool carries = false;      ///< x is in S some D where y is
  bool enters_part = false;  ///< a walk along the link may be within a word in y, where no other begins
  bool is_partial = false;   ///< y may tell x of a part of a word, which no expression stands for
};

/// Calls `visit` with each expression that the end of a link learns. `subsumers` are those of the beginning of the
/// link, and `fillers` those of them that have existential rules.
template <typename Visit>
void visit_taught(const IndexedOntology& index, std::span<const Learning> all, std::span<const ExprId> fillers,
                  std::span<const std::uint32_t> subsumers, Visit&& visit) {
  for (const Learning& learning : all) {
    if (learning.filler) {
      for (const ExprId filler : fillers) {
        const auto rules = index.existentials(filler);
        for (auto rule = std::ranges::lower_bound(rules, learning.role, {}, &ExistentialRule::role);
             rule != rules.end() && rule->role == learning.role; ++rule) {
          visit(rule->existential);
        }
      }
    }
    if (!learning.further) continue;
    for (const std::uint32_t expr : subsumers) {
      if (expr >= index.size() || index.expr(ExprId{expr}).kind != ExprKind::existential) continue;
      if (index.expr(ExprId{expr}).first == static_cast<std::uint32_t>(learning.role)) visit(ExprId{expr});
    }
  }
}

/// By the role of a link, what its ends learn of each other.
class InverseRoles {
 public:
  /// Requires that inclusions and chains between inverses have been told between the roles themselves
  /// (RoleChains::mirror).
  InverseRoles(const IndexedOntology& index, std::span<const InverseInclusion> inverses);

  [[nodiscard]] std::span<const ImpliedRole> implied(RoleId role) const {
    return implied_[static_cast<std::size_t>(role)];
  }
  [[nodiscard]] std::span<const Learning> learning(RoleId role) const {
    return learning_[static_cast<std::size_t>(role)];
  }
  /// Whether the end of a link learns something of its beginning.
  [[nodiscard]] bool tells_end(RoleId role) const { return tells_end_[static_cast<std::size_t>(role)]; }
  /// Whether learning() says all that the end of a link learns.
  [[nodiscard]] bool is_known(RoleId role) const { return is_known_[static_cast<std::size_t>(role)]; }
  /// The roles of whose range the beginning of a link must be.
  [[nodiscard]] std::span<const RoleId> ranges_of_beginning(RoleId role) const {
    return ranges_[static_cast<std::size_t>(role)];
  }

 private:
  void learn(RoleId heard, const owl::Automaton& automaton, bool is_existential, const owl::RoleBox& box);
  void learn(RoleId link, RoleId heard, const owl::Automaton& automaton, bool is_existential);

  const IndexedOntology& index_;
  std::vector<std::vector<ImpliedRole>> implied_;
  std::vector<std::vector<Learning>> learning_;
  std::vector<bool> tells_end_;
  std::vector<bool> is_known_;
  std::vector<std::vector<RoleId>> ranges_;
  std::vector<std::vector<owl::Role>>
      forward_;  ///< by role: canonical roles from a link's beginning to its end, ascending
  std::vector<std::vector<owl::Role>> backward_;  ///< and from its end to its beginning
};

}  // namespace geminga::el

#endif
