#include "reasoning/el/index/index_builder.hpp"

#include <algorithm>
#include <utility>

#include "base/sorted.hpp"

namespace geminga::el {
namespace {

std::uint64_t hash_of(const Expr& expr) {
  return base::mixed(base::mixed(static_cast<std::uint64_t>(expr.kind), expr.first), expr.second);
}

}  // namespace

IndexBuilder::IndexBuilder() {
  add({});  // T
  add({});  // F
}

ExprId IndexBuilder::add(const Expr& expr) {
  rules_.exprs.push_back(expr);
  rules_.is_negative.push_back(false);
  return ExprId{static_cast<std::uint32_t>(rules_.exprs.size() - 1)};
}

ExprId IndexBuilder::intern(const Expr& expr) {
  const std::uint64_t hash = hash_of(expr);
  const std::uint32_t found = table_.find(hash, [&](std::uint32_t filed) { return rules_.exprs[filed] == expr; });
  if (found != base::NumberTable::none) return ExprId{found};
  const ExprId id = add(expr);
  table_.insert(hash, number(id));
  return id;
}

ExprId IndexBuilder::conjunction(std::vector<ExprId> parts) {
  for (std::size_t at = 0; at < parts.size();) {
    const Expr expr = rules_.exprs[number(parts[at])];
    if (expr.kind != ExprKind::conjunction) {
      ++at;
      continue;
    }
    parts[at] = ExprId{expr.first};
    parts.push_back(ExprId{expr.second});
  }
  std::erase(parts, top_expr);
  if (parts.empty()) return top_expr;
  base::sort_unique(parts);
  if (parts.front() == bottom_expr) return bottom_expr;
  ExprId result = parts.front();
  for (std::size_t at = 1; at < parts.size(); ++at) {
    result = intern({ExprKind::conjunction, number(result), number(parts[at])});
  }
  return result;
}

ExprId IndexBuilder::existential(RoleId role, ExprId filler) {
  if (filler == bottom_expr) return bottom_expr;
  return intern({ExprKind::existential, static_cast<std::uint32_t>(role), number(filler)});
}

ExprId IndexBuilder::self(RoleId role) { return intern({ExprKind::self, static_cast<std::uint32_t>(role), 0}); }

void IndexBuilder::add_told(ExprId sub, ExprId super) {
  if (sub != super && super != top_expr && sub != bottom_expr) told_.emplace_back(sub, super);
}

void IndexBuilder::mark_negative(ExprId id) {
  while (rules_.exprs[number(id)].kind == ExprKind::conjunction && !rules_.is_negative[number(id)]) {
    rules_.is_negative[number(id)] = true;
    const ExprId last{rules_.exprs[number(id)].second};
    if (rules_.exprs[number(last)].kind != ExprKind::conjunction) rules_.is_negative[number(last)] = true;
    id = ExprId{rules_.exprs[number(id)].first};
  }
  rules_.is_negative[number(id)] = true;
}

void IndexBuilder::add_disjoint(std::span<const ExprId> members) {
  for (const ExprId member : members) {
    rules_.disjoint.emplace_back(number(member), static_cast<std::uint32_t>(rules_.disjointness_count));
  }
  ++rules_.disjointness_count;
}

ExprId IndexBuilder::range_atom(RoleId role) {
  const auto place = static_cast<std::size_t>(role);
  if (rules_.range_atoms.size() <= place) rules_.range_atoms.resize(place + 1, top_expr);
  if (rules_.range_atoms[place] == top_expr) rules_.range_atoms[place] = add_atom();
  return rules_.range_atoms[place];
}

void IndexBuilder::mark_data(RoleId role) {
  const auto place = static_cast<std::size_t>(role);
  if (is_data_role_.size() <= place) is_data_role_.resize(place + 1, false);
  is_data_role_[place] = true;
}

ExprId IndexBuilder::range_of(RoleId role) const {
  const auto place = static_cast<std::size_t>(role);
  return place < rules_.range_atoms.size() ? rules_.range_atoms[place] : top_expr;
}

bool IndexBuilder::is_data_role(RoleId role) const {
  const auto place = static_cast<std::size_t>(role);
  return place < is_data_role_.size() && is_data_role_[place];
}

std::optional<IndexedOntology> IndexBuilder::finish(std::size_t max_pairs) {
  if (!roles().close(std::min(max_pairs, max_role_pairs))) return std::nullopt;
  inherit_ranges();
  flatten_told();
  // Large ontologies have millions of expressions: what only the builder needs goes before rules are sorted.
  table_ = {};
  told_ = {};
  target_atoms_ = {};
  return IndexedOntology::sorted(std::move(rules_), max_pairs);
}

void IndexBuilder::inherit_ranges() {
  if (rules_.range_atoms.empty()) return;
  rules_.range_atoms.resize(roles().count(), top_expr);
  const std::vector<ExprId> own = rules_.range_atoms;
  for (std::uint32_t role = 0; role < roles().count(); ++role) {
    for (const RoleId super : roles().supers(RoleId{role})) {
      const ExprId inherited = own[static_cast<std::size_t>(super)];
      if (super != RoleId{role} && inherited != top_expr) add_told(range_atom(RoleId{role}), inherited);
    }
  }
}

void IndexBuilder::flatten_told() {
  rules_.is_told_bottom.assign(rules_.exprs.size(), false);
  rules_.is_told_bottom[number(bottom_expr)] = true;
  find_universal_targets();
  std::vector<ExprId> stack;
  // Link targets add atoms, and what is told of them, while this runs.
  for (std::size_t at = 0; at < told_.size(); ++at) {
    const auto [sub, super] = told_[at];
    flatten_one(sub, super, stack);
  }
  rules_.is_told_bottom.resize(rules_.exprs.size(), false);
}

void IndexBuilder::flatten_one(ExprId sub, ExprId super, std::vector<ExprId>& stack) {
  stack.push_back(super);
  while (!stack.empty()) {
    const ExprId id = stack.back();
    stack.pop_back();
    const Expr expr = rules_.exprs[number(id)];
    switch (expr.kind) {
      case ExprKind::atom:
      case ExprKind::nominal:
        if (id == bottom_expr) {
          rules_.is_told_bottom.resize(rules_.exprs.size(), false);
          rules_.is_told_bottom[number(sub)] = true;
        } else if (id != top_expr) {
          rules_.atoms_above.emplace_back(number(sub), id);
        }
        break;
      case ExprKind::conjunction:
        stack.push_back(ExprId{expr.first});
        stack.push_back(ExprId{expr.second});
        break;
      case ExprKind::existential:
        add_link(sub, RoleId{expr.first}, ExprId{expr.second});
        break;
      case ExprKind::self:
        rules_.selfs.emplace_back(number(sub), RoleId{expr.first});
        break;
    }
  }
}

void IndexBuilder::add_link(ExprId sub, RoleId role, ExprId filler) {
  // Ranges in EL (Baader, Brandt, Lutz 2008): what R leads to is in the range of R and of all its super roles, too.
  const ExprId range = range_of(role);
  const ExprId target = atom_of(range == top_expr ? filler : conjunction({filler, range}));
  rules_.links.emplace_back(number(sub), LinkRule{role, target, {}});
  if (target != top_expr && is_data_role(role)) rules_.values.push_back(target);
}

ExprId IndexBuilder::atom_of(ExprId target) {
  if (rules_.exprs[number(target)].kind <= ExprKind::nominal) return target;
  if (target_atoms_.size() <= number(target)) target_atoms_.resize(rules_.exprs.size(), top_expr);
  if (target_atoms_[number(target)] == top_expr) {
    const ExprId atom = add_atom();
    target_atoms_[number(target)] = atom;
    told_.emplace_back(atom, target);
  }
  return target_atoms_[number(target)];
}

void IndexBuilder::find_universal_targets() {
  for (auto& [atom, rule] : rules_.universals) {
    rule.target = atom_of(rule.target);
    if (is_data_role(rule.role)) rules_.values.push_back(rule.target);
  }
}

}  // namespace geminga::el
