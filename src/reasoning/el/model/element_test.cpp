// The legend is in closure/saturation.hpp; x and y are elements, X is an expression that has no rules.
#include "reasoning/el/model/element_test.hpp"

#include <algorithm>
#include <span>

namespace geminga::el {

bool ElementTest::is_in(std::uint32_t context, ExprId atom) const {
  const ExprId representative = index_.representative(atom);
  return representative == index_.representative(top_expr) ||
         saturation_.contexts()[context].subsumers.contains(number(representative));
}

bool ElementTest::is_individual(std::uint32_t context) const {
  const Context& element = saturation_.contexts()[context];
  return index_.is_nominal(element.root) || !element.nominals.empty();
}

// An atom without rules is a subsumer of no context. A class of which no subsumer may be missing must be known to be
// below it. An element that is only a successor need only be below the atoms above it that have rules.
bool ElementTest::has(std::uint32_t context, ExprId atom, bool is_only_successor) {
  const ExprId representative = index_.representative(atom);
  const Context& element = saturation_.contexts()[context];
  if (is_in(context, representative)) return true;
  if (index_.is_active(representative)) return false;
  if (is_only_successor && !is_individual(context)) {
    return std::ranges::all_of(index_.frontier(representative), [&](ExprId above) { return is_in(context, above); });
  }
  if (!element.together.empty()) return false;
  (void)above_.gather(element.root);
  return above_.contains(representative);
}

// An expression that has no other rules than told superclasses is only a name for these: `S some D` that a link makes
// true, or the atom of a range.
bool ElementTest::has_what_is_told(std::uint32_t context, ExprId named, bool is_only_successor) {
  if (is_in(context, named)) return true;
  constexpr auto above = static_cast<std::uint8_t>(RuleBits::above);
  if ((index_.rule_bits(named) & ~above) != 0 || !index_.universals(named).empty()) return false;
  return std::ranges::all_of(index_.told_atoms(named),
                             [&](ExprId atom) { return has(context, atom, is_only_successor); });
}

bool ElementTest::is_implied_satisfied(std::uint32_t from, RoleId role, std::uint32_t to) {
  const auto implied = inverses_.implied(role);
  const auto is_heard = [&](const ImpliedRole& other) { return heard_.is_heard(other.role); };
  if (std::ranges::none_of(implied, is_heard)) return true;
  if (!inverses_.is_known(role) || !open_.is_mirrored) return false;
  const bool is_fit = std::ranges::all_of(implied, [&](const ImpliedRole& other) {
    if (!is_heard(other)) return true;
    return other.is_backward ? is_backward_link_satisfied(to, other.role, from)
                             : is_link_satisfied(from, other.role, to, false);
  });
  return is_fit && knows_what_it_learns(from, role, to) &&
         std::ranges::all_of(inverses_.ranges_of_beginning(role), [&](RoleId heard) {
           return has_what_is_told(from, index_.representative(index_.range_of(heard)), false);
         });
}

/// Whether a link from a successor back to its source adds nothing, except what the successor learns.
bool ElementTest::is_backward_link_satisfied(std::uint32_t from, RoleId role, std::uint32_t to) {
  const bool may_reach_further = index_.has_nominals() || index_.has_universals() || !open_.at_most.empty();
  if (heard_.is_composed(role) && may_reach_further) return false;
  return may_be_linked(from, role, to, true);
}

/// Whether the target is in everything that it learns of the source. Being in all that an existential is told to be
/// below is enough where no link hands the existential on.
bool ElementTest::knows_what_it_learns(std::uint32_t from, RoleId role, std::uint32_t to) {
  const Context& source = saturation_.contexts()[from];
  bool knows = true;
  visit_taught(index_, inverses_.learning(role), std::span(source.propagating.begin(), source.propagating.end()),
               source.subsumers.items(), [&](ExprId learned) {
                 knows = knows &&
                         (is_in(to, learned) || (!inverses_.hands_on(learned) && has_what_is_told(to, learned, true)));
               });
  return knows;
}

bool ElementTest::is_link_satisfied(std::uint32_t from, RoleId role, std::uint32_t to, bool is_backward) {
  if (heard_.is_composed(role) || !may_be_linked(from, role, to, is_backward)) return false;
  //  y < D   [S some D occurs negatively]; then x must be in S some D
  const Context& target = saturation_.contexts()[to];
  return std::ranges::all_of(target.propagating, [&](ExprId filler) {
    return std::ranges::all_of(index_.existentials(filler), [&](const ExistentialRule& rule) {
      return !index_.roles().is_sub_role(role, rule.role) || has_what_is_told(from, rule.existential, is_backward);
    });
  });
}

/// Whether a further link breaks nothing, leaving aside the expressions that the source is in because of it.
bool ElementTest::may_be_linked(std::uint32_t from, RoleId role, std::uint32_t to, bool is_backward) {
  const Roles& roles = index_.roles();
  const Context& source = saturation_.contexts()[from];
  if (index_.may_be_functional(role) || from == to) return false;
  for (const RoleId super : roles.supers(role)) {
    if (index_.negative_self(super) != bottom_expr) return false;  // the two may be one individual
    //  y in E   [E is the range of S]
    const ExprId range = index_.range_of(super);
    if (range != top_expr && !has_what_is_told(to, index_.representative(range), !is_backward)) return false;
  }
  for (const ExprId restricting : source.restricting) {
    for (const UniversalRule& rule : index_.universals(restricting)) {
      if (roles.is_sub_role(role, rule.role) && !has(to, rule.target, !is_backward)) return false;
    }
  }
  return std::ranges::none_of(open_.at_most, [&](const OpenCount& open) {
    return roles.is_sub_role(role, open.role) && is_in(from, open.whole);
  });
}

}  // namespace geminga::el
