// Expressions are interned, and rules are sorted to the expressions that trigger them.
#include "reasoning/el/index/indexed_ontology.hpp"

#include <algorithm>
#include <iterator>

#include "base/components.hpp"
#include "base/sorted.hpp"

namespace geminga::el {
namespace {

std::uint64_t hash_of(const Expr& expr) {
  return base::mixed(base::mixed(static_cast<std::uint64_t>(expr.kind), expr.first), expr.second);
}

}  // namespace

IndexedOntology::IndexedOntology() {
  add({});  // T
  add({});  // F
}

ExprId IndexedOntology::add(const Expr& expr) {
  exprs_.push_back(expr);
  is_negative_.push_back(false);
  return ExprId{static_cast<std::uint32_t>(exprs_.size() - 1)};
}

ExprId IndexedOntology::add_nominal() { return add({ExprKind::nominal, 0, 0}); }

ExprId IndexedOntology::intern(const Expr& expr) {
  const std::uint64_t hash = hash_of(expr);
  const std::uint32_t found = table_.find(hash, [&](std::uint32_t filed) {
    return exprs_[filed].kind == expr.kind && exprs_[filed].first == expr.first && exprs_[filed].second == expr.second;
  });
  if (found != base::NumberTable::none) return ExprId{found};
  const ExprId id = add(expr);
  table_.insert(hash, number(id));
  return id;
}

ExprId IndexedOntology::conjunction(std::vector<ExprId> parts) {
  for (std::size_t at = 0; at < parts.size();) {
    const Expr expr = exprs_[number(parts[at])];
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

ExprId IndexedOntology::existential(RoleId role, ExprId filler) {
  if (filler == bottom_expr) return bottom_expr;
  return intern({ExprKind::existential, static_cast<std::uint32_t>(role), number(filler)});
}

ExprId IndexedOntology::self(RoleId role) { return intern({ExprKind::self, static_cast<std::uint32_t>(role), 0}); }

void IndexedOntology::add_told(ExprId sub, ExprId super) {
  if (sub != super && super != top_expr && sub != bottom_expr) told_.emplace_back(sub, super);
}

void IndexedOntology::mark_negative(ExprId id) {
  while (exprs_[number(id)].kind == ExprKind::conjunction && !is_negative_[number(id)]) {
    is_negative_[number(id)] = true;
    const ExprId last{exprs_[number(id)].second};
    if (exprs_[number(last)].kind != ExprKind::conjunction) is_negative_[number(last)] = true;
    id = ExprId{exprs_[number(id)].first};
  }
  is_negative_[number(id)] = true;
}

void IndexedOntology::add_disjoint(std::span<const ExprId> members) {
  for (const ExprId member : members) {
    disjoint_pairs_.emplace_back(number(member), static_cast<std::uint32_t>(disjointness_count_));
  }
  ++disjointness_count_;
}

void IndexedOntology::add_functional(ExprId id, RoleId role) { functional_pairs_.emplace_back(number(id), role); }

ExprId IndexedOntology::range_atom(RoleId role) {
  const auto index = static_cast<std::size_t>(role);
  if (range_atoms_.size() <= index) range_atoms_.resize(index + 1, top_expr);
  if (range_atoms_[index] == top_expr) range_atoms_[index] = add_atom();
  return range_atoms_[index];
}

void IndexedOntology::mark_data(RoleId role) {
  const auto place = static_cast<std::size_t>(role);
  if (is_data_role_.size() <= place) is_data_role_.resize(place + 1, false);
  is_data_role_[place] = true;
}

ExprId IndexedOntology::range_of(RoleId role) const {
  const auto index = static_cast<std::size_t>(role);
  return index < range_atoms_.size() ? range_atoms_[index] : top_expr;
}

ExprId IndexedOntology::negative_self(RoleId role) const {
  const auto index = static_cast<std::size_t>(role);
  return index < negative_selfs_.size() ? negative_selfs_[index] : bottom_expr;
}

bool IndexedOntology::finish(std::size_t max_pairs) {
  if (!roles_.close(std::min(max_pairs, max_role_pairs))) return false;
  inherit_ranges();
  flatten_told();
  find_representatives();
  sort_rules();
  find_functional();
  find_nominals();
  find_active();
  if (!find_frontiers(max_pairs)) return false;
  find_rule_bits();
  find_link_roots();
  return true;
}

void IndexedOntology::inherit_ranges() {
  if (range_atoms_.empty()) return;
  range_atoms_.resize(roles_.count(), top_expr);
  const std::vector<ExprId> own = range_atoms_;
  for (std::uint32_t role = 0; role < roles_.count(); ++role) {
    for (const RoleId super : roles_.supers(RoleId{role})) {
      const ExprId inherited = own[static_cast<std::size_t>(super)];
      if (super != RoleId{role} && inherited != top_expr) add_told(range_atom(RoleId{role}), inherited);
    }
  }
}

void IndexedOntology::flatten_told() {
  is_told_bottom_.assign(exprs_.size(), false);
  is_told_bottom_[number(bottom_expr)] = true;
  find_universal_targets();
  std::vector<ExprId> stack;
  // Link targets add atoms, and what is told of them, while this runs.
  for (std::size_t at = 0; at < told_.size(); ++at) {
    const auto [sub, super] = told_[at];
    flatten_one(sub, super, stack);
  }
  told_.clear();
  told_.shrink_to_fit();
  is_told_bottom_.resize(exprs_.size(), false);
}

void IndexedOntology::flatten_one(ExprId sub, ExprId super, std::vector<ExprId>& stack) {
  stack.push_back(super);
  while (!stack.empty()) {
    const ExprId id = stack.back();
    stack.pop_back();
    const Expr expr = exprs_[number(id)];
    switch (expr.kind) {
      case ExprKind::atom:
      case ExprKind::nominal:
        if (id == bottom_expr) {
          is_told_bottom_.resize(exprs_.size(), false);
          is_told_bottom_[number(sub)] = true;
        } else if (id != top_expr) {
          atom_pairs_.emplace_back(number(sub), id);
        }
        break;
      case ExprKind::conjunction:
        stack.push_back(ExprId{expr.first});
        stack.push_back(ExprId{expr.second});
        break;
      case ExprKind::existential: {
        const RoleId role{expr.first};
        const ExprId target = link_target(role, ExprId{expr.second});
        link_pairs_.emplace_back(number(sub), LinkRule{role, target, {}});
        const auto place = static_cast<std::size_t>(role);
        if (target != top_expr && place < is_data_role_.size() && is_data_role_[place]) values_.push_back(target);
        break;
      }
      case ExprKind::self:
        self_pairs_.emplace_back(number(sub), RoleId{expr.first});
        break;
    }
  }
}

ExprId IndexedOntology::link_target(RoleId role, ExprId filler) {
  // Ranges in EL (Baader, Brandt, Lutz 2008): what R leads to is in the range of R and of all its super roles, too.
  const ExprId range = range_of(role);
  return atom_of(range == top_expr ? filler : conjunction({filler, range}));
}

ExprId IndexedOntology::atom_of(ExprId target) {
  if (exprs_[number(target)].kind <= ExprKind::nominal) return target;
  if (target_atoms_.size() <= number(target)) target_atoms_.resize(exprs_.size(), top_expr);
  if (target_atoms_[number(target)] == top_expr) {
    const ExprId atom = add_atom();
    target_atoms_[number(target)] = atom;
    told_.emplace_back(atom, target);
  }
  return target_atoms_[number(target)];
}

void IndexedOntology::find_universal_targets() {
  for (auto& [atom, rule] : universals_told_) {
    rule.target = atom_of(rule.target);
    const auto place = static_cast<std::size_t>(rule.role);
    if (place < is_data_role_.size() && is_data_role_[place]) values_.push_back(rule.target);
  }
}

void IndexedOntology::find_representatives() {
  const auto count = static_cast<std::uint32_t>(exprs_.size());
  std::vector<std::pair<std::uint32_t, ExprId>> edges;
  edges.reserve(atom_pairs_.size());
  for (const auto& pair : atom_pairs_) {
    if (exprs_[pair.first].kind <= ExprKind::nominal) edges.push_back(pair);
  }
  const base::Rows<ExprId> up(count, edges);
  const base::Components components = base::find_components(count, [&](std::uint32_t node) { return up[node]; });
  representative_.assign(count, top_expr);
  std::vector<std::uint32_t> first_of(components.count, base::NumberTable::none);
  for (std::uint32_t id = 0; id < count; ++id) {
    std::uint32_t& first = first_of[components.component[id]];
    if (first == base::NumberTable::none) first = id;
    representative_[id] = ExprId{first};
  }
  supers_first_ = std::move(first_of);
  is_value_rep_.assign(count, false);
  for (const ExprId value : values_) is_value_rep_[number(representative_[number(value)])] = true;
  is_nominal_rep_.assign(count, false);
  for (std::uint32_t id = 0; id < count; ++id) {
    if (exprs_[id].kind == ExprKind::nominal) is_nominal_rep_[number(representative_[id])] = true;
    if (is_told_bottom_[id]) is_told_bottom_[number(representative_[id])] = true;
  }
}

template <typename Item>
base::Rows<Item> IndexedOntology::rows_of(std::vector<std::pair<std::uint32_t, Item>>& pairs) const {
  for (auto& [row, item] : pairs) row = number(representative_[row]);
  base::Rows<Item> rows(exprs_.size(), pairs);
  pairs.clear();
  pairs.shrink_to_fit();
  return rows;
}
// For indexed_ontology_merging.cpp.
template base::Rows<RoleId> IndexedOntology::rows_of(std::vector<std::pair<std::uint32_t, RoleId>>& pairs) const;

void IndexedOntology::sort_rules() {
  for (auto& [row, item] : atom_pairs_) item = representative_[number(item)];
  std::erase_if(atom_pairs_, [&](const auto& pair) { return representative_[pair.first] == pair.second; });
  told_atoms_ = rows_of(atom_pairs_);
  told_atoms_.sort_unique();
  for (auto& [row, item] : link_pairs_) item.target = representative_[number(item.target)];
  links_ = rows_of(link_pairs_);
  links_.sort_unique();
  selfs_ = rows_of(self_pairs_);
  selfs_.sort_unique();

  std::vector<std::pair<std::uint32_t, ConjunctionRule>> conjunctions;
  std::vector<std::pair<std::uint32_t, ExistentialRule>> existentials;
  negative_selfs_.assign(roles_.count(), bottom_expr);
  for (std::uint32_t id = 0; id < exprs_.size(); ++id) {
    if (!is_negative_[id]) continue;
    const Expr& expr = exprs_[id];
    if (expr.kind == ExprKind::conjunction) {
      const ExprId first = representative_[expr.first];
      const ExprId second = representative_[expr.second];
      conjunctions.push_back({number(first), {second, ExprId{id}}});
      if (first != second) conjunctions.push_back({number(second), {first, ExprId{id}}});
    } else if (expr.kind == ExprKind::existential) {
      existentials.push_back({number(representative_[expr.second]), {RoleId{expr.first}, ExprId{id}}});
    } else if (expr.kind == ExprKind::self) {
      negative_selfs_[expr.first] = ExprId{id};
      has_negative_self_ = true;
    }
  }
  std::ranges::sort(conjunctions, {}, [](const auto& pair) { return std::pair(pair.first, pair.second.partner); });
  conjunctions_ = rows_of(conjunctions);
  existentials_ = rows_of(existentials);
  existentials_.sort_unique();
  disjointness_ = rows_of(disjoint_pairs_);
  std::vector<std::pair<std::uint32_t, UniversalRule>> universals;
  for (const auto& [atom, rule] : universals_told_) {
    universals.push_back({number(atom), {rule.role, representative_[number(rule.target)]}});
  }
  if (!universals.empty()) universals_ = rows_of(universals);
  universals_.sort_unique();
}

void IndexedOntology::find_active() {
  is_active_.assign(exprs_.size(), false);
  for (std::uint32_t id = 0; id < exprs_.size(); ++id) {
    is_active_[id] = exprs_[id].kind > ExprKind::nominal || is_nominal_rep_[id] || is_told_bottom_[id] ||
                     !links_[id].empty() || !selfs_[id].empty() || !conjunctions_[id].empty() ||
                     !existentials_[id].empty() || !disjointness_[id].empty() || !functional_roles_[id].empty() ||
                     !universals_[id].empty();
  }
  for (const ExprId atom : watched_) is_active_[number(representative_[number(atom)])] = true;
}

bool IndexedOntology::is_told_below(ExprId sub, ExprId super) const {
  constexpr std::size_t max_looked_at = 64;
  std::vector<ExprId> seen = {sub};
  for (std::size_t at = 0; at < seen.size() && at < max_looked_at; ++at) {
    if (seen[at] == super) return true;
    for (const ExprId above : told_atoms(seen[at])) {
      if (std::ranges::find(seen, above) == seen.end()) seen.push_back(above);
    }
  }
  return false;
}

bool IndexedOntology::find_frontiers(std::size_t max_items) {
  frontier_begin_.assign(exprs_.size(), 0);
  frontier_count_.assign(exprs_.size(), 0);
  std::vector<std::uint32_t> seen_from(exprs_.size(), base::NumberTable::none);
  for (const std::uint32_t id : supers_first_) {
    if (exprs_[id].kind > ExprKind::nominal) continue;
    frontier_begin_[id] = static_cast<std::uint32_t>(frontier_items_.size());
    const auto reach = [&](ExprId super) {
      if (seen_from[number(super)] == id) return;
      seen_from[number(super)] = id;
      frontier_items_.push_back(super);
    };
    for (const ExprId super : told_atoms_[id]) {
      if (is_active_[number(super)]) {
        reach(super);
      } else {
        const std::uint32_t begin = frontier_begin_[number(super)];
        for (std::uint32_t at = 0; at < frontier_count_[number(super)]; ++at) reach(frontier_items_[begin + at]);
      }
    }
    if (frontier_items_.size() > max_items) return false;
    frontier_count_[id] = static_cast<std::uint32_t>(frontier_items_.size()) - frontier_begin_[id];
  }
  return true;
}

void IndexedOntology::find_rule_bits() {
  rule_bits_.assign(exprs_.size(), 0);
  for (std::uint32_t id = 0; id < exprs_.size(); ++id) {
    const bool is_atom = exprs_[id].kind <= ExprKind::nominal;
    const bool has[] = {is_told_bottom_[id],        is_atom ? frontier_count_[id] != 0 : !told_atoms_[id].empty(),
                        !links_[id].empty(),        !selfs_[id].empty(),
                        !conjunctions_[id].empty(), !existentials_[id].empty(),
                        !disjointness_[id].empty(), !functional_roles_[id].empty()};
    for (std::size_t bit = 0; bit < std::size(has); ++bit) {
      if (has[bit]) rule_bits_[id] = static_cast<std::uint8_t>(rule_bits_[id] | 1U << bit);
    }
  }
}

void IndexedOntology::find_link_roots() {
  for (LinkRule& link : links_.mutable_items()) {
    // The successor by a functional role may turn out to be the element itself, which then is in the target, too.
    link.root = may_be_functional(link.role) ? link.target : link_root(link.target);
  }
}

ExprId IndexedOntology::link_root(ExprId target) const {
  // An atom without rules, with at most one atom with rules above it, has the subsumers of that atom and needs no
  // context. Ontologies with nominals are excepted: a class that has an instance may turn out to equal a nominal.
  if (has_nominals_ || keeps_link_targets_ || !is_atom(target) || is_active(target) || frontier(target).size() > 1)
    return target;
  return frontier(target).empty() ? top_expr : frontier(target).front();
}

}  // namespace geminga::el
