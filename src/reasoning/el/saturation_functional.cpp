// The rules for functional properties; the legend is in saturation.hpp.
#include <algorithm>

#include "reasoning/el/saturation_worker.hpp"

namespace geminga::el {

std::uint32_t SaturationWorker::require_together(const std::vector<ExprId>& atoms) {
  if (atoms.size() == 1) return require(atoms.front());
  const std::scoped_lock lock(shared_.together_mutex);  // in ontologies with functional properties only
  const auto [known, is_new] = shared_.context_of_some.try_emplace(atoms, 0);
  if (!is_new) return known->second;
  const std::uint32_t created = contexts_.add();
  known->second = created;
  contexts_[created].root = bottom_expr;
  contexts_[created].together.own() = atoms;
  conclusions_ += atoms.size();
  shared_.merged_atoms += atoms.size();
  if (shared_.merged_atoms > shared_.limits.merged_atoms) {
    shared_.is_over_merged = true;
    shared_.is_over_limit = true;
  }
  std::vector<ExprId> above = atoms;
  above.push_back(top_expr);
  start(created, above);
  return created;
}

std::vector<ExprId> SaturationWorker::atoms_of(std::uint32_t context) const {
  const Context& self = contexts_[context];
  return self.together.empty() ? std::vector<ExprId>{self.root} : self.together.get();
}

void SaturationWorker::process_functional(std::uint32_t context, Link link) {
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
void SaturationWorker::group_successor(std::uint32_t context, RoleId functional, Link link) {
  if (!index_.roles().is_sub_role(link.role, functional)) return;
  std::vector<FunctionalGroup>& groups = contexts_[context].groups.own();
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
  work_.add(together.size());
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
void SaturationWorker::process_functional_self(std::uint32_t context, RoleId functional) {
  const Context& self = contexts_[context];
  const bool has_self =
      std::ranges::any_of(self.selfs, [&](RoleId role) { return index_.roles().is_sub_role(role, functional); });
  const auto group = std::ranges::find(self.groups.get(), functional, &FunctionalGroup::functional);
  if (!has_self || group == self.groups.get().end()) return;
  for (const ExprId atom : atoms_of(group->successor)) add_derived_atom(context, atom);
}

}  // namespace geminga::el
