// Told equivalents are found, and rules are sorted to the expressions that trigger them.
#include "reasoning/el/index/indexed_ontology.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/components.hpp"
#include "base/interner.hpp"

namespace geminga::el {

std::optional<IndexedOntology> IndexedOntology::sorted(FlatRules rules, std::size_t max_pairs) {
  IndexedOntology index;
  index.roles_ = std::move(rules.roles);
  index.exprs_ = std::move(rules.exprs);
  index.is_told_bottom_ = std::move(rules.is_told_bottom);
  index.range_atoms_ = std::move(rules.range_atoms);
  index.disjointness_count_ = rules.disjointness_count;
  index.keeps_link_targets_ = rules.keeps_link_targets;
  const std::vector<std::uint32_t> supers_first = index.find_representatives(rules.atoms_above);
  index.mark_representatives(rules.values);
  index.sort_told(rules);
  index.sort_negative(rules.is_negative);
  index.find_functional(std::move(rules.functional));
  index.find_nominals();
  index.find_active(rules.watched);
  if (!index.find_frontiers(supers_first, max_pairs)) return std::nullopt;
  index.find_rule_bits();
  index.find_link_roots();
  return index;
}

ExprId IndexedOntology::range_of(RoleId role) const {
  const auto place = static_cast<std::size_t>(role);
  return place < range_atoms_.size() ? range_atoms_[place] : top_expr;
}

ExprId IndexedOntology::negative_self(RoleId role) const {
  const auto place = static_cast<std::size_t>(role);
  return place < negative_selfs_.size() ? negative_selfs_[place] : bottom_expr;
}

std::vector<std::uint32_t> IndexedOntology::find_representatives(const Pairs<ExprId>& atoms_above) {
  const auto count = static_cast<std::uint32_t>(exprs_.size());
  Pairs<ExprId> edges;
  edges.reserve(atoms_above.size());
  for (const auto& pair : atoms_above) {
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
  return first_of;
}

void IndexedOntology::mark_representatives(std::span<const ExprId> values) {
  is_value_rep_.assign(exprs_.size(), false);
  for (const ExprId value : values) is_value_rep_[number(representative(value))] = true;
  is_nominal_rep_.assign(exprs_.size(), false);
  for (std::uint32_t id = 0; id < exprs_.size(); ++id) {
    const std::uint32_t first = number(representative_[id]);
    if (exprs_[id].kind == ExprKind::nominal) is_nominal_rep_[first] = true;
    if (is_told_bottom_[id]) is_told_bottom_[first] = true;
  }
}

template <typename Item>
base::Rows<Item> IndexedOntology::rows_of(Pairs<Item> pairs) const {
  for (auto& [row, item] : pairs) row = number(representative_[row]);
  return base::Rows<Item>(exprs_.size(), pairs);
}
// For indexed_ontology_merging.cpp.
template base::Rows<RoleId> IndexedOntology::rows_of(Pairs<RoleId> pairs) const;

void IndexedOntology::sort_told(FlatRules& rules) {
  for (auto& [row, item] : rules.atoms_above) item = representative(item);
  std::erase_if(rules.atoms_above, [&](const auto& pair) { return representative_[pair.first] == pair.second; });
  told_atoms_ = rows_of(std::move(rules.atoms_above));
  told_atoms_.sort_unique();
  for (auto& [row, item] : rules.links) item.target = representative(item.target);
  links_ = rows_of(std::move(rules.links));
  links_.sort_unique();
  selfs_ = rows_of(std::move(rules.selfs));
  selfs_.sort_unique();
  disjointness_ = rows_of(std::move(rules.disjoint));
  if (rules.universals.empty()) return;  // no octet for them: most ontologies have none
  for (auto& [row, item] : rules.universals) item.target = representative(item.target);
  universals_ = rows_of(std::move(rules.universals));
  universals_.sort_unique();
}

void IndexedOntology::sort_negative(const std::vector<bool>& is_negative) {
  Pairs<ConjunctionRule> conjunctions;
  Pairs<ExistentialRule> existentials;
  negative_selfs_.assign(roles_.count(), bottom_expr);
  for (std::uint32_t id = 0; id < exprs_.size(); ++id) {
    if (!is_negative[id]) continue;
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
  conjunctions_ = rows_of(std::move(conjunctions));
  existentials_ = rows_of(std::move(existentials));
  existentials_.sort_unique();
}

void IndexedOntology::find_active(std::span<const ExprId> watched) {
  is_active_.assign(exprs_.size(), false);
  for (std::uint32_t id = 0; id < exprs_.size(); ++id) {
    is_active_[id] = exprs_[id].kind > ExprKind::nominal || is_nominal_rep_[id] || is_told_bottom_[id] ||
                     !links_[id].empty() || !selfs_[id].empty() || !conjunctions_[id].empty() ||
                     !existentials_[id].empty() || !disjointness_[id].empty() || !functional_roles_[id].empty() ||
                     !universals_[id].empty();
  }
  for (const ExprId atom : watched) is_active_[number(representative(atom))] = true;
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

bool IndexedOntology::find_frontiers(std::span<const std::uint32_t> supers_first, std::size_t max_items) {
  frontier_begin_.assign(exprs_.size(), 0);
  frontier_count_.assign(exprs_.size(), 0);
  std::vector<std::uint32_t> seen_from(exprs_.size(), base::NumberTable::none);
  for (const std::uint32_t id : supers_first) {
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
