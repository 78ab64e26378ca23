#include "reasoning/dl/consequence/rules/centred_rules.hpp"

#include <algorithm>

#include "base/sorted.hpp"

namespace geminga::consequence {
namespace {

/// Exchanges the centre and neighbour 1.
void recentre(Atoms& atoms) {
  for (RuleAtom& atom : atoms) {
    if (is_role_atom(atom)) {
      atom.kind = atom.kind == LiteralKind::outgoing ? LiteralKind::incoming : LiteralKind::outgoing;
    } else {
      atom.first = atom.first <= 1 ? static_cast<std::uint8_t>(1 - atom.first) : atom.first;
      if (atom.kind == LiteralKind::equal) atom.second = atom.second <= 1 ? std::uint8_t(1 - atom.second) : atom.second;
    }
  }
}

[[nodiscard]] bool mentions(const Atoms& atoms, std::uint8_t variable) {
  return std::ranges::any_of(atoms, [&](const RuleAtom& atom) {
    return atom.first == variable || (atom.kind == LiteralKind::equal && atom.second == variable);
  });
}

[[nodiscard]] std::uint8_t greatest_variable(const Atoms& atoms) {
  std::uint8_t greatest = 0;
  for (const RuleAtom& atom : atoms) greatest = std::max({greatest, atom.first, atom.second});
  return greatest;
}

/// Whether all neighbours have the same single atom, and the head says that two of them are equal.
[[nodiscard]] bool is_symmetric(const Rule& rule) {
  if (rule.neighbours < 2 || rule.head.size() != rule.neighbours * (rule.neighbours - 1U) / 2) return false;
  std::size_t roles = 0;
  const RuleAtom* role = nullptr;
  for (const RuleAtom& atom : rule.body) {
    if (!is_role_atom(atom)) continue;
    if (role != nullptr && (atom.kind != role->kind || atom.predicate != role->predicate)) return false;
    role = &atom;
    ++roles;
  }
  return roles == rule.neighbours && std::ranges::all_of(rule.head, [](const RuleAtom& atom) {
           return atom.kind == LiteralKind::equal && atom.first != 0 && atom.second != 0 && atom.first != atom.second;
         });
}

}  // namespace

void CentredRules::add(Atoms body, Atoms head) {
  const std::uint8_t last = std::max(greatest_variable(body), greatest_variable(head));
  for (std::uint8_t variable = 1; variable <= last; ++variable) {
    const auto is_guard = [&](const RuleAtom& atom) { return is_role_atom(atom) && atom.first == variable; };
    if ((mentions(body, variable) || mentions(head, variable)) && std::ranges::none_of(body, is_guard)) {
      gaps_.emplace_back("a clause about what is no neighbour");
      return;
    }
  }
  bool speaks_of_centre = false;
  bool speaks_of_neighbours = false;
  for (const RuleAtom& atom : body) {
    if (is_role_atom(atom)) continue;
    (atom.first == 0 ? speaks_of_centre : speaks_of_neighbours) = true;
  }
  // A range, R(x,y) -> B(y), is also written at the neighbour, whose concepts are known there. Most often B is one of
  // them.
  const bool is_range =
      last == 1 && !speaks_of_centre && !head.empty() && !mentions(head, 0) && std::ranges::none_of(head, is_role_atom);
  if (last == 1 && !speaks_of_centre && (speaks_of_neighbours || is_range)) {
    recentre(body);
    recentre(head);
    return add_rule(std::move(body), std::move(head));
  }
  if (!speaks_of_neighbours) return add_rule(std::move(body), std::move(head));
  Atoms about_centre;
  for (const RuleAtom& atom : body) {
    if (atom.first == 0) about_centre.push_back(atom);
  }
  for (std::uint8_t variable = 1; variable <= last; ++variable) {
    Atoms about;
    for (RuleAtom atom : body) {
      if (atom.first != variable) continue;
      atom.first = 1;
      about.push_back(atom);
    }
    if (std::ranges::all_of(about, is_role_atom)) {
      for (RuleAtom atom : about) {
        atom.first = variable;
        about_centre.push_back(atom);
      }
      continue;
    }
    const bool is_role = mentions(head, variable);
    const std::uint32_t name = name_for(about, is_role);
    about_centre.push_back(is_role ? RuleAtom{LiteralKind::outgoing, variable, 0, name} : unary_atom(name));
  }
  add_rule(std::move(about_centre), std::move(head));
}

std::uint32_t CentredRules::name_for(const Atoms& about_neighbour, bool is_role) {
  Atoms key = about_neighbour;
  std::ranges::sort(key);
  const auto [entry, is_new] = names_.try_emplace({key, is_role}, 0);
  if (!is_new) return entry->second;
  entry->second = is_role ? role_count_++ : predicate_count_++;
  recentre(key);
  // For the neighbour, the old centre is variable 1.
  const RuleAtom name = is_role ? RuleAtom{LiteralKind::incoming, 1, 0, entry->second} : unary_atom(entry->second, 1);
  const std::uint32_t made = entry->second;
  add_rule(std::move(key), {name});
  return made;
}

void CentredRules::shorten(Atoms& body) {
  constexpr std::size_t longest = 32;
  while (static_cast<std::size_t>(std::ranges::count(body, std::uint8_t{0}, &RuleAtom::first)) > longest) {
    Atoms taken;
    Atoms left;
    for (const RuleAtom& atom : body) {
      (atom.first == 0 && taken.size() < longest ? taken : left).push_back(atom);
    }
    const std::uint32_t name = predicate_count_++;
    add_rule(std::move(taken), {unary_atom(name)});
    left.push_back(unary_atom(name));
    body = std::move(left);
  }
}

void CentredRules::add_rule(Atoms body, Atoms head) {
  base::sort_unique(body);
  shorten(body);
  base::sort_unique(head);
  // Neighbours are numbered without gaps, so that a rule has as many variables as its neighbours.
  std::vector<std::uint8_t> renamed(256, 0);
  std::uint8_t count = 0;
  const auto rename = [&](std::uint8_t& variable) {
    if (variable == 0) return;
    if (renamed[variable] == 0) renamed[variable] = ++count;
    variable = renamed[variable];
  };
  for (Atoms* atoms : {&body, &head}) {
    for (RuleAtom& atom : *atoms) {
      rename(atom.first);
      if (atom.kind == LiteralKind::equal) rename(atom.second);
    }
  }
  Rule rule{std::move(body), std::move(head), count, false};
  rule.is_ordered = is_symmetric(rule);
  rules_.push_back(std::move(rule));
}

void CentredRules::move_to(RuleSet& set) {
  base::sort_unique(rules_);
  set.rules = std::move(rules_);
  set.predicate_count = predicate_count_;
  set.role_count = role_count_;
  set.gaps.insert(set.gaps.end(), gaps_.begin(), gaps_.end());
}

}  // namespace geminga::consequence
