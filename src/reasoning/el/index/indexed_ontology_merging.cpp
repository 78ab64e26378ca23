// The rules that may make two elements one: functional properties and nominals.
#include <algorithm>
#include <utility>

#include "reasoning/el/index/indexed_ontology.hpp"

namespace geminga::el {

void IndexedOntology::find_functional(Pairs<RoleId> told) {
  is_functional_.assign(roles_.count(), false);
  if (told.empty()) return;
  Pairs<ExprId> by_role;
  std::vector<bool> is_used(roles_.count(), false);
  for (const auto& [id, role] : told) {
    is_used[static_cast<std::size_t>(role)] = true;
    if (ExprId{id} == top_expr) {
      is_functional_[static_cast<std::size_t>(role)] = true;
    } else {
      by_role.emplace_back(static_cast<std::uint32_t>(role), representative_[id]);
    }
  }
  std::erase_if(told, [](const auto& pair) { return ExprId{pair.first} == top_expr; });
  functional_in_ = base::Rows<ExprId>(roles_.count(), by_role);
  functional_roles_ = rows_of(std::move(told));
  may_be_functional_.assign(roles_.count(), false);
  for (std::uint32_t role = 0; role < roles_.count(); ++role) {
    may_be_functional_[role] = std::ranges::any_of(
        roles_.supers(RoleId{role}), [&](RoleId super) { return is_used[static_cast<std::size_t>(super)]; });
  }
}

void IndexedOntology::forget_merging() {
  universals_ = {};
  may_be_functional_.clear();
  is_functional_.assign(roles_.count(), false);
  functional_in_ = {};
  functional_roles_ = {};
}

void IndexedOntology::find_nominals() {
  // Individuals that nothing leads to need no rules for nominals: each is a class that has an instance.
  for (std::uint32_t id = 0; id < exprs_.size() && !has_nominals_; ++id) {
    const auto is_nominal_rep = [&](ExprId expr) { return is_nominal_rep_[number(expr)]; };
    has_nominals_ = std::ranges::any_of(told_atoms_[id], is_nominal_rep) ||
                    std::ranges::any_of(links_[id], is_nominal_rep, &LinkRule::target) ||
                    std::ranges::any_of(universals_[id], is_nominal_rep, &UniversalRule::target) ||
                    (is_nominal_rep_[id] && (!existentials_[id].empty() || !conjunctions_[id].empty())) ||
                    (is_nominal_rep_[id] && representative_[id] != ExprId{id});
  }
}

}  // namespace geminga::el
