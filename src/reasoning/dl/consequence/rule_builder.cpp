#include "reasoning/dl/consequence/rule_builder.hpp"

#include <algorithm>

#include "base/sorted.hpp"

namespace geminga::consequence {
namespace {

using clauses::AtomKind;
using clauses::number;

/// Exchanges the centre and neighbour 1.
void recentre(std::vector<RuleAtom>& atoms) {
  for (RuleAtom& atom : atoms) {
    if (is_role_atom(atom)) {
      atom.kind = atom.kind == LiteralKind::outgoing ? LiteralKind::incoming : LiteralKind::outgoing;
    } else {
      atom.first = atom.first <= 1 ? static_cast<std::uint8_t>(1 - atom.first) : atom.first;
      if (atom.kind == LiteralKind::equal) atom.second = atom.second <= 1 ? std::uint8_t(1 - atom.second) : atom.second;
    }
  }
}

[[nodiscard]] bool mentions(const std::vector<RuleAtom>& atoms, std::uint8_t variable) {
  return std::ranges::any_of(atoms, [&](const RuleAtom& atom) {
    return atom.first == variable || (atom.kind == LiteralKind::equal && atom.second == variable);
  });
}

[[nodiscard]] std::uint8_t greatest_variable(const std::vector<RuleAtom>& atoms) {
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

RuleBuilder::RuleBuilder(const owl::Ontology& source, const clauses::ClauseSet& clauses, bool with_facts)
    : source_(source), clauses_(clauses), with_facts_(with_facts) {}

RuleSet RuleBuilder::run() {
  if (with_facts_) gather_facts();
  number_predicates();
  make_expansions();
  for (const clauses::Clause& clause : clauses_.clauses) add_clause(clause);
  if (with_facts_) add_facts();
  add_values();
  base::sort_unique(result_.rules);
  find_gaps();
  return std::move(result_);
}

void RuleBuilder::number_predicates() {
  result_.predicate_of.resize(clauses_.concepts.size());
  std::uint32_t next = 0;
  for (const bool is_query : {true, false}) {
    for (std::size_t i = 0; i < clauses_.concepts.size(); ++i) {
      if ((clauses_.concepts[i].kind != clauses::ConceptKind::auxiliary) != is_query) continue;
      result_.predicate_of[i] = next++;
      if (is_query) result_.query_concepts.push_back(clauses::ConceptId{static_cast<std::uint32_t>(i)});
    }
    if (is_query) result_.query_count = next;
  }
  thing_ = result_.predicate_of[number(clauses::thing)];
  nothing_ = result_.predicate_of[number(clauses::nothing)];
  constexpr std::uint32_t none = 0xffffffffU;
  result_.nominal_of.assign(clauses_.individuals.size(), none);
  for (std::size_t i = 0; i < clauses_.concepts.size(); ++i) {
    if (clauses_.concepts[i].kind != clauses::ConceptKind::nominal) continue;
    result_.nominal_of[number(clauses_.concepts[i].individual)] = result_.predicate_of[i];
  }
  for (std::uint32_t& nominal : result_.nominal_of) {
    if (nominal == none) nominal = next++;
  }
  result_.first_marker = next;
  next += static_cast<std::uint32_t>(clauses_.at_leasts.size() + clauses_.data_at_leasts.size() + links_.size() +
                                     (with_facts_ ? clauses_.data_facts.size() : 0));
  at_most_base_ = next;
  next += static_cast<std::uint32_t>(clauses_.at_mosts.size() + clauses_.data_at_mosts.size());
  const std::size_t ranges = clauses_.data_ranges.size() + fact_values_.size();
  for (std::size_t i = 0; i < ranges; ++i) range_predicate_.push_back(next++);
  result_.predicate_count = next;
  data_role_base_ = static_cast<std::uint32_t>(clauses_.properties.size());
  result_.role_count = data_role_base_ + static_cast<std::uint32_t>(clauses_.data_properties.size());
}

std::uint32_t RuleBuilder::add_expansion(std::uint32_t count, Atoms atoms) {
  Expansion& expansion = result_.expansions.emplace_back();
  const bool is_value = std::ranges::any_of(
      atoms, [this](const RuleAtom& atom) { return is_role_atom(atom) && atom.predicate >= data_role_base_; });
  if (count > max_functions - functions_) {
    result_.gaps.push_back("more than " + std::to_string(max_functions) + " successors are named");
  } else {
    expansion = {functions_, count, std::move(atoms), is_value};
    functions_ += count;
  }
  return result_.first_marker + static_cast<std::uint32_t>(result_.expansions.size() - 1);
}

void RuleBuilder::make_expansions() {
  const auto role_of = [](const clauses::Role& role) {
    return RuleAtom{role.is_inverse ? LiteralKind::incoming : LiteralKind::outgoing, 1, 0, number(role.property)};
  };
  const auto data_role_of = [this](clauses::DataPropertyId property) {
    return RuleAtom{LiteralKind::outgoing, 1, 0, data_role_base_ + number(property)};
  };
  for (const clauses::AtLeast& at_least : clauses_.at_leasts) {
    Atoms atoms{role_of(at_least.role)};
    if (at_least.filler != clauses::thing) atoms.push_back(concept_atom(at_least.filler, 1));
    const std::uint32_t marker = add_expansion(at_least.count, std::move(atoms));
    if (at_least.filler == clauses::nothing) add({{LiteralKind::unary, 0, 0, marker}}, {});
  }
  for (const clauses::DataAtLeast& at_least : clauses_.data_at_leasts) {
    Atoms atoms{data_role_of(at_least.property)};
    const std::uint32_t range = number(at_least.range);
    if (range != 0) atoms.push_back({LiteralKind::unary, 1, 0, range_predicate_[range]});
    static_cast<void>(add_expansion(at_least.count, std::move(atoms)));
  }
  std::uint32_t marker = at_most_base_;
  for (const clauses::AtMost& at_most : clauses_.at_mosts) {
    add_at_most(marker++, at_most.count, role_of(at_most.role), concept_atom(at_most.filler, 0).predicate);
  }
  for (const clauses::DataAtMost& at_most : clauses_.data_at_mosts) {
    const std::uint32_t range = number(at_most.range);
    if (range != 1)
      add_at_most(marker, at_most.count, data_role_of(at_most.property), range == 0 ? thing_ : range_predicate_[range]);
    ++marker;
  }
}

void RuleBuilder::add_at_most(std::uint32_t marker, std::uint32_t count, RuleAtom role, std::uint32_t filler) {
  if (filler == nothing_) return;
  if (count > max_at_most) {
    result_.gaps.push_back("at most " + std::to_string(count) + " of a property");
    return;
  }
  Atoms body{{LiteralKind::unary, 0, 0, marker}};
  Atoms head;
  for (std::uint32_t i = 1; i <= count + 1; ++i) {
    const auto variable = static_cast<std::uint8_t>(i);
    role.first = variable;
    body.push_back(role);
    if (filler != thing_) body.push_back({LiteralKind::unary, variable, 0, filler});
    for (std::uint32_t j = 1; j < i; ++j) {
      head.push_back({LiteralKind::equal, static_cast<std::uint8_t>(j), variable, 0});
    }
  }
  add(std::move(body), std::move(head));
}

RuleAtom RuleBuilder::concept_atom(clauses::ConceptId of, std::uint8_t variable) const {
  return {LiteralKind::unary, variable, 0, result_.predicate_of[number(of)]};
}

bool RuleBuilder::convert(const clauses::Atom& atom, bool is_head, Atoms& atoms, bool& is_redundant) const {
  const auto expansion = [&](std::uint32_t index, bool is_trivial) {
    if (is_trivial) is_redundant = true;
    atoms.push_back({LiteralKind::unary, atom.first, 0, result_.first_marker + index});
  };
  switch (atom.kind) {
    case AtomKind::concept_of: {
      const RuleAtom made = concept_atom(clauses::ConceptId{atom.predicate}, atom.first);
      if (made.predicate == (is_head ? thing_ : nothing_)) is_redundant = true;
      if (made.predicate != thing_ && made.predicate != nothing_) atoms.push_back(made);
      return true;
    }
    case AtomKind::role:
    case AtomKind::data_role: {
      const std::uint32_t role = atom.predicate + (atom.kind == AtomKind::data_role ? data_role_base_ : 0);
      if (atom.first == atom.second) {
        atoms.push_back({LiteralKind::reflexive, atom.first, 0, role});
      } else if (atom.first == clauses::centre) {
        atoms.push_back({LiteralKind::outgoing, atom.second, 0, role});
      } else {
        atoms.push_back({LiteralKind::incoming, atom.first, 0, role});
      }
      return atom.first == clauses::centre || atom.second == clauses::centre || atom.first == atom.second;
    }
    case AtomKind::equal:
    case AtomKind::data_equal:
      if (atom.first == atom.second) is_redundant = true;
      atoms.push_back({LiteralKind::equal, std::min(atom.first, atom.second), std::max(atom.first, atom.second), 0});
      return true;
    case AtomKind::at_least:
      expansion(atom.predicate, clauses_.at_leasts[atom.predicate].count == 0);
      return true;
    case AtomKind::data_at_least:
      expansion(static_cast<std::uint32_t>(clauses_.at_leasts.size()) + atom.predicate,
                clauses_.data_at_leasts[atom.predicate].count == 0);
      return true;
    case AtomKind::data_range:
      if (atom.predicate == (is_head ? 0U : 1U)) is_redundant = true;
      if (atom.predicate > 1) {
        atoms.push_back({LiteralKind::unary, atom.first, 0, range_predicate_[atom.predicate]});
      }
      return true;
    case AtomKind::at_most:
      atoms.push_back({LiteralKind::unary, atom.first, 0, at_most_base_ + atom.predicate});
      return true;
    case AtomKind::data_at_most:
      atoms.push_back({LiteralKind::unary, atom.first, 0,
                       at_most_base_ + static_cast<std::uint32_t>(clauses_.at_mosts.size()) + atom.predicate});
      return true;
  }
  return false;
}

void RuleBuilder::add_clause(const clauses::Clause& clause) {
  Atoms body;
  Atoms head;
  bool is_redundant = false;
  bool is_understood = true;
  for (const clauses::Atom& atom : clause.body) is_understood &= convert(atom, false, body, is_redundant);
  for (const clauses::Atom& atom : clause.head) is_understood &= convert(atom, true, head, is_redundant);
  if (is_redundant) return;
  if (!is_understood) {
    result_.gaps.emplace_back("a clause with a property between two neighbours");
    return;
  }
  add(std::move(body), std::move(head));
}

void RuleBuilder::add(Atoms body, Atoms head) {
  const std::uint8_t last = std::max(greatest_variable(body), greatest_variable(head));
  for (std::uint8_t variable = 1; variable <= last; ++variable) {
    const auto is_guard = [&](const RuleAtom& atom) { return is_role_atom(atom) && atom.first == variable; };
    if ((mentions(body, variable) || mentions(head, variable)) && std::ranges::none_of(body, is_guard)) {
      result_.gaps.emplace_back("a clause about what is no neighbour");
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
    about_centre.push_back(is_role ? RuleAtom{LiteralKind::outgoing, variable, 0, name}
                                   : RuleAtom{LiteralKind::unary, 0, 0, name});
  }
  add_rule(std::move(about_centre), std::move(head));
}

std::uint32_t RuleBuilder::name_for(const Atoms& about_neighbour, bool is_role) {
  Atoms key = about_neighbour;
  std::ranges::sort(key);
  const auto [entry, is_new] = names_.try_emplace({key, is_role}, 0);
  if (!is_new) return entry->second;
  entry->second = is_role ? result_.role_count++ : result_.predicate_count++;
  recentre(key);
  // For the neighbour, the old centre is variable 1.
  const RuleAtom name = is_role ? RuleAtom{LiteralKind::incoming, 1, 0, entry->second}
                                : RuleAtom{LiteralKind::unary, 1, 0, entry->second};
  const std::uint32_t made = entry->second;
  add_rule(std::move(key), {name});
  return made;
}

void RuleBuilder::shorten(Atoms& body) {
  constexpr std::size_t longest = 32;
  while (static_cast<std::size_t>(std::ranges::count(body, std::uint8_t{0}, &RuleAtom::first)) > longest) {
    Atoms taken;
    Atoms left;
    for (const RuleAtom& atom : body) {
      (atom.first == 0 && taken.size() < longest ? taken : left).push_back(atom);
    }
    const std::uint32_t name = result_.predicate_count++;
    add_rule(std::move(taken), {{LiteralKind::unary, 0, 0, name}});
    left.push_back({LiteralKind::unary, 0, 0, name});
    body = std::move(left);
  }
}

void RuleBuilder::add_rule(Atoms body, Atoms head) {
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
  result_.rules.push_back(std::move(rule));
}

}  // namespace geminga::consequence
