// The rules of OWL 2 EL that all closures share, each written once, in logic notation beside its code.
//
// A closure says what a context is. Saturation has a context for each concept. Inheritance has a node, which takes over
// the items of the nodes above it. ExpressionOverlay (placement) has contexts of one expression over a closed base.
// Each closure says where a conclusion is noted and when the rules are applied to it. ../README.md lists which rule is
// where, and which rules belong to one closure alone.
//
// Legend: as in saturation.hpp. C is a context or a node of the closure; C -R-> D is a link that the closure keeps.
#ifndef GEMINGA_REASONING_EL_CLOSURE_RULES_HPP
#define GEMINGA_REASONING_EL_CLOSURE_RULES_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/sorted.hpp"
#include "reasoning/el/closure/context.hpp"
#include "reasoning/el/index/indexed_ontology.hpp"

namespace geminga::el {

/// Calls `then` with each negative existential of the filler that a link of the role shows.
template <typename Then>
void for_each_existential(const IndexedOntology& index, RoleId role, ExprId filler, Then then) {
  // A general class may be the filler of thousands of existentials, of which a link concerns a handful.
  constexpr std::size_t max_scanned = 8;
  const Roles& roles = index.roles();
  const std::span<const ExistentialRule> rules = index.existentials(filler);
  if (rules.size() <= max_scanned) {
    for (const ExistentialRule& rule : rules) {
      if (roles.is_sub_role(role, rule.role)) then(rule.existential);
    }
    return;
  }
  for (const RoleId super : roles.supers(role)) {
    for (auto rule = std::ranges::lower_bound(rules, super, {}, &ExistentialRule::role);
         rule != rules.end() && rule->role == super; ++rule) {
      then(rule->existential);
    }
  }
}

/// The base of a closure, which gives itself as Closure and makes this a friend. The calls between the two are bound at
/// compile time, so that sharing the rules costs nothing. A closure has:
///
///   inherits                 true if a context takes over all subsumers of the contexts that are told to be above it
///   add_subsumer(C, D)       notes C < D
///   add_atom(C, A)           notes C < A of an atom, which need not have rules
///   add_bottom(C)            notes C < F
///   add_link(C, R, D)        notes C -R-> D
///   add_self(C, R)           notes C < R Self
///   add_loop(C, R)           notes the link from C to itself that C < R Self implies
///   add_filler(C, D)         remembers that D is the filler of negative existentials, and calls propagate() with D for
///                            the links that end in C
///   add_mark(C, mark)        adds a number that is no expression's to the subsumers; false if it was there
///   successor_of(C, rule)    the context at the end of the link of C that a LinkRule demands
///   is_unsatisfiable(C)      true if C < F is noted
///   subsumers(C)             the set of the noted D in C < D; a reference that add_subsumer() leaves valid
///   selfs(C), selfs_done(C)  the noted R of C < R Self, and how many of them apply_self() was called for
///   count_work(n)            counts n premises that were looked at
///
/// and, if it calls apply_functional() or functional_link():
///
///   forward(C), forward_done(C)  the links that begin in C, and how many of them functional_link() was called for
///   groups(C)                the FunctionalGroups of C
///   members_of(C)            the atoms of C, as numbers or enumerators, ascending
///   require_together(all)    the context of several atoms together
///   add_member(C, one)       notes that C is below one atom
template <typename Closure>
class Rules {
  friend Closure;
  explicit Rules(const IndexedOntology& index) : index_(index) {}

 protected:
  /// Applies all rules with the premise C < D, where D was concluded for C itself.
  void apply(std::uint32_t context, ExprId subsumer) {
    const std::uint8_t rules = index_.rule_bits(subsumer);

    //  C < D
    //  ----- [D < F is told]
    //  C < F
    if (has(rules, RuleBits::bottom)) return closure().add_bottom(context);

    //  C < D
    //  ----- [D < E is told]; of an atom D the taxonomy knows it, of others it must be noted
    //  C < E
    if (has(rules, RuleBits::above)) {
      if (!index_.is_atom(subsumer)) {
        for (const ExprId above : index_.told_atoms(subsumer)) closure().add_atom(context, above);
      } else if constexpr (!Closure::inherits) {
        for (const ExprId above : index_.frontier(subsumer)) closure().add_subsumer(context, above);
      }
    }

    //  C < D
    //  -------- [D < R some E is told]
    //  C -R-> E
    if (has(rules, RuleBits::links)) {
      for (const LinkRule& link : index_.links(subsumer)) {
        closure().add_link(context, link.role, closure().successor_of(context, link));
      }
    }
    if (has(rules, RuleBits::conjunctions)) apply_conjunctions(context, subsumer);
    apply_to_inherited(context, subsumer, rules);
  }

  /// Applies the rules of D, `rules`, that C must apply again if it has D from a node above, because their other
  /// premise may be C's own; all such rules but conjunctions.
  void apply_to_inherited(std::uint32_t context, ExprId subsumer, std::uint8_t rules) {
    //  C < D
    //  ---------- [D < R Self is told]
    //  C < R Self
    if (has(rules, RuleBits::selfs)) {
      for (const RoleId role : index_.selfs(subsumer)) closure().add_self(context, role);
    }
    if (has(rules, RuleBits::existentials)) closure().add_filler(context, subsumer);
    if (has(rules, RuleBits::disjointness)) apply_disjointness(context, subsumer);
  }

  //  C < D   C < E
  //  ------------- [D and E occurs negatively]
  //  C < D and E
  void apply_conjunctions(std::uint32_t context, ExprId subsumer) {
    // The shorter list is walked and the other one searched: names like "disease" are in thousands of conjunctions. A
    // conjunction is filed with both conjuncts, so that the shorter list of rules can be searched.
    const auto& subsumers = closure().subsumers(context);
    const std::span<const ConjunctionRule> rules = index_.conjunctions(subsumer);
    closure().count_work(std::min<std::size_t>(rules.size(), subsumers.size()));
    if (rules.size() <= std::size_t{subsumers.size()} * 2) {
      for (const ConjunctionRule& rule : rules) {
        if (subsumers.contains(number(rule.partner))) closure().add_subsumer(context, rule.conjunction);
      }
      return;
    }
    for (std::size_t at = 0; at < subsumers.size(); ++at) {
      const ExprId partner{subsumers[at]};
      if (number(partner) >= index_.size() || !index_.has_rules(partner, RuleBits::conjunctions)) continue;
      const std::span<const ConjunctionRule> of_partner = index_.conjunctions(partner);
      const bool is_shorter = of_partner.size() < rules.size();
      const std::span<const ConjunctionRule> searched = is_shorter ? of_partner : rules;
      const ExprId wanted = is_shorter ? subsumer : partner;
      for (auto rule = std::ranges::lower_bound(searched, wanted, {}, &ConjunctionRule::partner);
           rule != searched.end() && rule->partner == wanted; ++rule) {
        closure().add_subsumer(context, rule->conjunction);
      }
    }
  }

  //  C < D   C < E
  //  ------------- [D and E are different members of one disjointness axiom]
  //  C < F
  void apply_disjointness(std::uint32_t context, ExprId subsumer) {
    if (closure().is_unsatisfiable(context)) return;
    for (const std::uint32_t axiom : index_.disjointness(subsumer)) {
      // The axiom's mark says that one member is there. It is never inherited: two contexts above may have their marks
      // from the same member.
      const std::uint32_t mark = static_cast<std::uint32_t>(index_.size()) + axiom;
      if (!closure().add_mark(context, mark)) return closure().add_bottom(context);
    }
  }

  //  C -R-> D   D < E
  //  ---------------- [S some E occurs negatively, R <* S]; `link` is R and C, `filler` is E
  //  C < S some E
  void propagate(Link link, ExprId filler) {
    for_each_existential(index_, link.role, filler, [&](ExprId found) { closure().add_subsumer(link.context, found); });
  }

  //  C -R-> D   D -S-> E
  //  ------------------- [R o S SubPropertyOf R']
  //  C -R'-> E
  void compose(std::uint32_t from, RoleId first, RoleId second, std::uint32_t to) {
    for (const RoleId result : index_.roles().composed(first, second)) {
      closure().add_composed_link(from, first, second, result, to);
    }
  }

  /// A closure may have a function of its own.
  void add_composed_link(std::uint32_t from, RoleId, RoleId, RoleId result, std::uint32_t to) {
    closure().add_link(from, result, to);
  }

  /// Applies all rules with the premise C < R Self.
  void apply_self(std::uint32_t context, RoleId role) {
    //  C < R Self
    //  ---------- [R <* S, S Self occurs negatively]
    //  C < S Self
    for (const RoleId super : index_.roles().supers(role)) {
      const ExprId negative = index_.negative_self(super);
      if (negative != bottom_expr) closure().add_subsumer(context, negative);
    }

    //  C < R Self    C < R Self
    //  ----------    ---------- [E is the range of R]
    //  C -R-> C      C < E
    closure().add_loop(context, role);
    if (index_.range_of(role) != top_expr) {
      closure().add_atom(context, index_.representative(index_.range_of(role)));
    }

    //  C < R Self   C < S Self
    //  ----------------------- [R o S SubPropertyOf R']
    //  C < R' Self
    for (std::uint32_t at = 0; at < closure().selfs_done(context); ++at) {
      const RoleId other = closure().selfs(context)[at];
      compose_selfs(context, role, other);
      if (other != role) compose_selfs(context, other, role);
    }
  }

  //  C < D   C -R-> E
  //  ---------------- [D has at most one S, R <* S]; here the first premise is new
  //  E is the one S successor, as below
  void apply_functional(std::uint32_t context, ExprId subsumer) {
    for (const RoleId functional : index_.functional_roles(subsumer)) {
      const std::size_t known = closure().forward_done(context);
      for (std::size_t at = 0; at < known && !closure().is_unsatisfiable(context); ++at) {
        group_successor(context, functional, closure().forward(context)[at]);
      }
      functional_self(context, functional);
    }
  }

  /// As apply_functional(), if the link is new.
  void functional_link(std::uint32_t context, Link link) {
    for (const RoleId super : index_.roles().supers(link.role)) {
      if (!closure().is_functional_in(context, super)) continue;
      group_successor(context, super, link);
      functional_self(context, super);
    }
  }

  /// A closure may have a function of its own.
  [[nodiscard]] bool is_functional_in(std::uint32_t context, RoleId role) {
    const auto& subsumers = closure().subsumers(context);
    const auto holds_here = [&](ExprId id) { return subsumers.contains(number(id)); };
    return index_.is_functional(role) || std::ranges::any_of(index_.functional_in(role), holds_here);
  }

  //  C -R1-> D1   C -R2-> D2
  //  ------------------------------------- [S is functional in C, R1 <* S, R2 <* S]
  //  C -R1-> D1 and D2   C -R2-> D1 and D2
  void group_successor(std::uint32_t context, RoleId functional, Link link) {
    if (!index_.roles().is_sub_role(link.role, functional)) return;
    std::vector<FunctionalGroup>& groups = closure().groups(context);
    const auto group = std::ranges::find(groups, functional, &FunctionalGroup::functional);
    if (group == groups.end()) {
      groups.push_back({functional, link.context, {link.role}});
      return;
    }
    const bool is_new_role = std::ranges::find(group->roles, link.role) == group->roles.end();
    if (is_new_role) group->roles.push_back(link.role);
    auto together = closure().members_of(group->successor);
    const std::size_t known = together.size();
    for (const auto member : closure().members_of(link.context)) together.push_back(member);
    closure().count_work(together.size());
    base::sort_unique(together);
    if (together.size() == known && !is_new_role) return;
    // A new context may move the others, and the groups with them.
    const std::vector<RoleId> roles = group->roles;
    const auto position = group - groups.begin();
    const std::uint32_t successor = closure().require_together(together);
    closure().groups(context)[static_cast<std::size_t>(position)].successor = successor;
    for (const RoleId role : roles) closure().add_link(context, role, successor);
  }

  //  C < R Self   C -R'-> D
  //  ---------------------- [S is functional in C, R <* S, R' <* S]
  //  C < D
  void functional_self(std::uint32_t context, RoleId functional) {
    const auto is_below = [&](RoleId role) { return index_.roles().is_sub_role(role, functional); };
    if (std::ranges::none_of(closure().selfs(context), is_below)) return;
    const std::vector<FunctionalGroup>& groups = closure().groups(context);
    const auto group = std::ranges::find(groups, functional, &FunctionalGroup::functional);
    if (group == groups.end()) return;
    for (const auto member : closure().members_of(group->successor)) closure().add_member(context, member);
  }

  const IndexedOntology& index_;

 private:
  [[nodiscard]] static bool has(std::uint8_t rules, RuleBits kind) {
    return (rules & static_cast<std::uint8_t>(kind)) != 0;
  }
  [[nodiscard]] Closure& closure() { return static_cast<Closure&>(*this); }

  void compose_selfs(std::uint32_t context, RoleId first, RoleId second) {
    for (const RoleId result : index_.roles().composed(first, second)) closure().add_self(context, result);
  }
};

}  // namespace geminga::el

#endif
