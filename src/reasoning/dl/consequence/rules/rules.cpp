#include "reasoning/dl/consequence/rules/rules.hpp"

#include <algorithm>

#include "base/sorted.hpp"

namespace geminga::consequence {
namespace {

/// Whether it is a rule such as R(x,y) -> S(x,y).
[[nodiscard]] bool is_inclusion(const Rule& rule) {
  return rule.body.size() == 1 && rule.head.size() == 1 && is_role_atom(rule.body[0]) && is_role_atom(rule.head[0]) &&
         rule.body[0].first == rule.head[0].first;
}

}  // namespace

Rules::Rules(RuleSet rule_set) : rule_set_(std::move(rule_set)) {
  for (const Expansion& expansion : rule_set_.expansions) {
    marker_of_.insert(marker_of_.end(), expansion.count,
                      static_cast<std::uint32_t>(&expansion - rule_set_.expansions.data()));
  }
  is_nominal_.resize(rule_set_.predicate_count);
  for (const std::uint32_t nominal : rule_set_.nominal_of) is_nominal_[nominal] = true;
  take_out_inclusions();
  drop_pure();
  expand_heads();
  index();
}

void Rules::take_out_inclusions() {
  std::vector<std::pair<std::uint32_t, RuleAtom>> pairs;
  for (const Rule& rule : rule_set_.rules) {
    if (!is_inclusion(rule)) continue;
    const bool is_turned = rule.body[0].kind != rule.head[0].kind;
    pairs.push_back({rule.body[0].predicate,
                     {is_turned ? LiteralKind::incoming : LiteralKind::outgoing, 0, 0, rule.head[0].predicate}});
  }
  std::erase_if(rule_set_.rules, is_inclusion);
  inclusions_ = base::Rows<RuleAtom>(rule_set_.role_count, pairs);
  inclusions_.sort_unique();
}

void Rules::mark_used() {
  is_used_unary_.assign(rule_set_.predicate_count, false);
  is_used_role_.assign(rule_set_.role_count, false);
  supers_.assign(rule_set_.role_count, {});
  has_supers_.assign(rule_set_.role_count, false);
  for (const Rule& rule : rule_set_.rules) {
    for (const RuleAtom& atom : rule.body) {
      (atom.kind == LiteralKind::unary ? is_used_unary_ : is_used_role_)[atom.predicate] = true;
    }
  }
}

const std::vector<RuleAtom>& Rules::supers(std::uint32_t role) {
  std::vector<RuleAtom>& found = supers_[role];
  if (has_supers_[role]) return found;
  has_supers_[role] = true;
  std::vector<RuleAtom> reached{{LiteralKind::outgoing, 0, 0, role}};
  std::vector<bool> is_reached(rule_set_.role_count * std::size_t{2}, false);
  is_reached[role * std::size_t{2}] = true;
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const RuleAtom current = reached[next];
    if (is_used_role_[current.predicate]) found.push_back(current);
    for (RuleAtom above : inclusions_[current.predicate]) {
      if (current.kind == LiteralKind::incoming) {
        above.kind = above.kind == LiteralKind::incoming ? LiteralKind::outgoing : LiteralKind::incoming;
      }
      const std::size_t key = above.predicate * std::size_t{2} + (above.kind == LiteralKind::incoming ? 1 : 0);
      if (is_reached[key]) continue;
      is_reached[key] = true;
      reached.push_back(above);
    }
  }
  std::ranges::sort(found);
  return found;
}

bool Rules::is_used(const RuleAtom& atom) {
  switch (atom.kind) {
    case LiteralKind::unary: {
      if (atom.predicate < rule_set_.query_count || is_used_unary_[atom.predicate] ||
          rule_set_.is_open[atom.predicate]) {
        return true;
      }
      const Expansion* const made = expansion(atom.predicate);
      return made != nullptr &&
             std::ranges::any_of(made->atoms, [this](const RuleAtom& part) { return is_used(part); });
    }
    case LiteralKind::outgoing:
    case LiteralKind::incoming:
    case LiteralKind::reflexive:
      return !supers(atom.predicate).empty();
    default:
      return true;
  }
}

void Rules::drop_pure() {
  for (std::size_t before = 0; before != rule_set_.rules.size();) {
    before = rule_set_.rules.size();
    mark_used();
    std::erase_if(rule_set_.rules, [this](const Rule& rule) {
      return std::ranges::any_of(rule.head, [this](const RuleAtom& atom) { return !is_used(atom); });
    });
  }
}

std::vector<std::vector<RuleAtom>> Rules::expanded(const std::vector<RuleAtom>& head) {
  std::vector<std::vector<RuleAtom>> heads{{}};
  for (const RuleAtom& atom : head) {
    std::vector<RuleAtom> choices;
    if (is_role_atom(atom) || atom.kind == LiteralKind::reflexive) {
      for (const RuleAtom& above : supers(atom.predicate)) {
        RuleAtom choice = atom;
        choice.predicate = above.predicate;
        if (is_role_atom(atom) && above.kind == LiteralKind::incoming) {
          choice.kind = atom.kind == LiteralKind::incoming ? LiteralKind::outgoing : LiteralKind::incoming;
        }
        choices.push_back(choice);
      }
    } else {
      choices.push_back(atom);
    }
    std::vector<std::vector<RuleAtom>> longer;
    for (const auto& begun : heads) {
      for (const RuleAtom& choice : choices) {
        longer.push_back(begun);
        longer.back().push_back(choice);
      }
    }
    heads = std::move(longer);
  }
  return heads;
}

void Rules::expand_heads() {
  std::vector<Rule> rules;
  for (Rule& rule : rule_set_.rules) {
    for (auto& head : expanded(rule.head)) {
      Rule made = rule;
      base::sort_unique(head);
      made.head = std::move(head);
      rules.push_back(std::move(made));
    }
  }
  base::sort_unique(rules);
  rule_set_.rules = std::move(rules);
  for (Expansion& expansion : rule_set_.expansions) {
    std::vector<RuleAtom> atoms;
    for (const RuleAtom& atom : expansion.atoms) {
      if (!is_used(atom)) continue;
      for (const auto& made : expanded({atom})) atoms.push_back(made[0]);
    }
    base::sort_unique(atoms);
    expansion.atoms = std::move(atoms);
  }
}

void Rules::index() {
  std::vector<std::pair<std::uint32_t, Literal>> told;
  std::vector<std::pair<std::uint32_t, Occurrence>> unary_occurrences;
  roles_.resize(rule_set_.role_count * std::size_t{2});
  reflexive_.resize(rule_set_.role_count);
  is_unary_trigger_.assign(rule_set_.predicate_count, false);
  for (std::uint32_t number = 0; number < rule_set_.rules.size(); ++number) {
    const Rule& rule = rule_set_.rules[number];
    if (rule.body.empty()) always_.push_back(number);
    const bool is_told = rule.body.size() == 1 && rule.body[0].kind == LiteralKind::unary && rule.head.size() == 1 &&
                         rule.head[0].kind == LiteralKind::unary && rule.neighbours == 0;
    if (is_told) {
      is_unary_trigger_[rule.body[0].predicate] = true;
      told.emplace_back(rule.body[0].predicate, unary(rule.head[0].predicate, x_term));
      continue;
    }
    for (std::uint32_t at = 0; at < rule.body.size(); ++at) {
      const RuleAtom& atom = rule.body[at];
      const Occurrence occurrence{number, at};
      if (atom.kind == LiteralKind::unary) {
        is_unary_trigger_[atom.predicate] = true;
        unary_occurrences.emplace_back(atom.predicate, occurrence);
      } else if (atom.kind == LiteralKind::reflexive) {
        reflexive_[atom.predicate].push_back(occurrence);
      } else {
        roles_[atom.predicate * std::size_t{2} + (atom.kind == LiteralKind::incoming ? 1 : 0)].push_back(occurrence);
      }
    }
  }
  for (std::size_t i = 0; i < rule_set_.expansions.size(); ++i) {
    is_unary_trigger_[rule_set_.first_marker + i] = true;
  }
  for (const std::uint32_t nominal : rule_set_.nominal_of) is_unary_trigger_[nominal] = true;
  told_ = base::Rows<Literal>(rule_set_.predicate_count, told);
  told_.sort_unique();
  unary_ = base::Rows<Occurrence>(rule_set_.predicate_count, unary_occurrences);
}

}  // namespace geminga::consequence
