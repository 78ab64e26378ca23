// The rules for functional properties and for R Self; the legend is in saturation.hpp.
#include <algorithm>

#include "el/saturation.hpp"

namespace geminga::el {

std::uint32_t Saturation::require_together(const std::vector<ExprId>& atoms) {
  if (atoms.size() == 1) return require(atoms.front());
  const auto [known, is_new] = context_of_some_.try_emplace(atoms, static_cast<std::uint32_t>(contexts_.size()));
  if (!is_new) return known->second;
  const std::uint32_t created = known->second;
  Context& self = contexts_.emplace_back();
  self.root = bottom_expr;
  self.together = atoms;
  conclusions_ += atoms.size();
  start(created, atoms);
  start(created, {{top_expr}});
  return created;
}

std::vector<ExprId> Saturation::atoms_of(std::uint32_t context) const {
  const Context& self = contexts_[context];
  return self.together.empty() ? std::vector<ExprId>{self.root} : self.together;
}

void Saturation::process_functional(std::uint32_t context, Link link) {
  for (const RoleId super : index_.roles().supers(link.role)) {
    const auto holds_here = [&](ExprId id) { return contexts_[context].subsumers.contains(number(id)); };
    if (index_.is_functional(super) || std::ranges::any_of(index_.functional_in(super), holds_here)) {
      group_successor(context, super, link);
      process_functional_self(context, super);
    }
  }
}

//  C -R1-> D1   C -R2-> D2
//  ------------------------------------- [S is functional in C, R1 <* S, R2 <* S]
//  C -R1-> D1 and D2   C -R2-> D1 and D2
void Saturation::group_successor(std::uint32_t context, RoleId functional, Link link) {
  if (!index_.roles().is_sub_role(link.role, functional)) return;
  std::vector<FunctionalGroup>& groups = contexts_[context].groups;
  auto group = std::ranges::find(groups, functional, &FunctionalGroup::functional);
  if (group == groups.end()) {
    groups.push_back({functional, link.context, {link.role}});
    return;
  }
  const bool is_new_role = std::ranges::find(group->roles, link.role) == group->roles.end();
  if (is_new_role) group->roles.push_back(link.role);
  std::vector<ExprId> together = atoms_of(group->successor);
  const std::size_t known = together.size();
  for (const ExprId atom : atoms_of(link.context)) together.push_back(atom);
  std::ranges::sort(together);
  together.erase(std::unique(together.begin(), together.end()), together.end());
  if (together.size() == known && !is_new_role) return;
  const std::vector<RoleId> roles = group->roles;
  const std::uint32_t successor = require_together(together);
  group->successor = successor;
  for (const RoleId role : roles) add_link(context, role, successor);
}

//  C < R Self   C -R'-> D
//  ---------------------- [S is functional in C, R <* S, R' <* S]
//  C < D
void Saturation::process_functional_self(std::uint32_t context, RoleId functional) {
  const Context& self = contexts_[context];
  const bool has_self =
      std::ranges::any_of(self.selfs, [&](RoleId role) { return index_.roles().is_sub_role(role, functional); });
  const auto group = std::ranges::find(self.groups, functional, &FunctionalGroup::functional);
  if (!has_self || group == self.groups.end()) return;
  for (const ExprId atom : atoms_of(group->successor)) add_derived_atom(context, atom);
}

void Saturation::add_self(std::uint32_t context, RoleId role) {
  Context& self = contexts_[context];
  if (self.is_unsatisfiable || std::ranges::find(self.selfs, role) != self.selfs.end()) return;
  self.selfs.push_back(role);
  ++conclusions_;
  enqueue(context);
}

void Saturation::process_self(std::uint32_t context, RoleId role) {
  //  C < R Self
  //  ---------- [R <* S, S Self occurs negatively]
  //  C < S Self
  for (const RoleId super : index_.roles().supers(role)) {
    const ExprId negative = index_.negative_self(super);
    if (negative != bottom_expr) add_subsumer(context, negative);
  }

  //  C < R Self    C < R Self
  //  ----------    ---------- [E is the range of R]
  //  C -R-> C      C < E
  add_link(context, role, context);
  for (const RoleId super : index_.roles().supers(role)) {
    if (index_.may_be_functional(super)) process_functional_self(context, super);
  }
  if (index_.range_of(role) != top_expr) add_derived_atom(context, index_.representative(index_.range_of(role)));

  //  C < R Self   C < S Self
  //  ----------------------- [R o S SubPropertyOf R']
  //  C < R' Self
  const auto compose_selfs = [&](RoleId first, RoleId second) {
    for (const Composition& rule : index_.roles().compositions(first)) {
      if (rule.second == second) add_self(context, rule.result);
    }
  };
  const std::uint32_t done = contexts_[context].selfs_done;
  for (std::uint32_t at = 0; at < done; ++at) {
    const RoleId other = contexts_[context].selfs[at];
    compose_selfs(role, other);
    if (other != role) compose_selfs(other, role);
  }
}

}  // namespace geminga::el
