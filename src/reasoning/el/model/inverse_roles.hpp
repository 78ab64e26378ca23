// Inverses of roles: the further links that a link implies, and the expressions that its ends learn of each other.
//
// Legend as in expressions.hpp. R(x,y) says S(y,x) where S is told to be an inverse of R or of a role above R. So
// a subsumer of x may put y into `S some D`, through words of S that go back along links. The automaton of S with
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

/// Conclusions from a link x -R-> y about expressions `S some D` that are recognised.
struct Learning {
  RoleId role{};            ///< S
  bool filler = false;      ///< x in D puts y into S some D
  bool further = false;     ///< x in S some D puts y into S some D
  bool recognises = false;  ///< y in D puts x into S some D
  bool carries = false;     ///< y in S some D puts x into S some D
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

/// By the role of a link, what it implies and what its ends learn of each other.
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
  /// True if the end of a link learns something of its beginning.
  [[nodiscard]] bool tells_end(RoleId role) const { return tells_end_[static_cast<std::size_t>(role)]; }
  /// True if learning() says all that the end of a link learns.
  [[nodiscard]] bool is_known(RoleId role) const { return is_known_[static_cast<std::size_t>(role)]; }
  /// True if the end of some link learns the existential only because the beginning is in it.
  [[nodiscard]] bool hands_on(ExprId existential) const;
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
  /// By role S: whether a link has `further` of S, and whether it always has `filler` with it.
  enum class HandsOn : std::uint8_t { nothing, also_told, only_further };
  std::vector<HandsOn> hands_on_;
  std::vector<bool> is_known_;
  std::vector<std::vector<RoleId>> ranges_;
  std::vector<std::vector<owl::Role>> forward_;   ///< by role: canonical roles along a link, ascending
  std::vector<std::vector<owl::Role>> backward_;  ///< and against it
};

}  // namespace geminga::el

#endif
