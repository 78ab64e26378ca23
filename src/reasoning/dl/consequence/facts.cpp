// Facts and values as rules, and the parts of an ontology that the calculus cannot use fully.
#include <algorithm>

#include "reasoning/dl/consequence/closure.hpp"
#include "reasoning/dl/consequence/rule_builder.hpp"
#include "reasoning/dl/consequence/values.hpp"

namespace geminga::consequence {

using clauses::number;

void RuleBuilder::gather_facts() {
  for (const clauses::RoleFact& fact : clauses_.role_facts) {
    if (fact.first == fact.second) continue;
    const std::uint32_t role = number(fact.property);
    links_[{number(fact.first), number(fact.second)}].push_back({LiteralKind::outgoing, 1, 0, role});
    links_[{number(fact.second), number(fact.first)}].push_back({LiteralKind::incoming, 1, 0, role});
  }
  for (const clauses::DataFact& fact : clauses_.data_facts) {
    const auto position = static_cast<std::uint32_t>(clauses_.data_ranges.size() + fact_values_.size());
    fact_values_.try_emplace(fact.value, position);
  }
}

//  B(a)             becomes  {a} < B
//  R(a,b), S(b,a)   become   {a} < some (R and S-).{b}  and  {b} < some (R- and S).{a}
//  R(a,a)           becomes  {a} < R Self
//  U(a,v)           becomes  {a} < some U.{v}
//  a = b            becomes  {a} < {b}  and  {b} < {a}
//  a is not b       becomes  {a} and {b} < F
// Everything between two individuals is one successor, so that their roles meet there.
void RuleBuilder::add_facts() {
  const auto nominal = [this](clauses::IndividualId individual) {
    return RuleAtom{LiteralKind::unary, 0, 0, result_.nominal_of[number(individual)]};
  };
  for (const clauses::ConceptFact& fact : clauses_.concept_facts) {
    if (fact.of == clauses::thing) continue;
    add({nominal(fact.individual)}, fact.of == clauses::nothing ? Atoms{} : Atoms{concept_atom(fact.of, 0)});
  }
  for (const clauses::RoleFact& fact : clauses_.role_facts) {
    if (fact.first == fact.second) {
      add({nominal(fact.first)}, {{LiteralKind::reflexive, 0, 0, number(fact.property)}});
    }
  }
  for (const auto& [pair, roles] : links_) {
    Atoms atoms = roles;
    atoms.push_back({LiteralKind::unary, 1, 0, result_.nominal_of[pair.second]});
    const std::uint32_t marker = add_expansion(1, std::move(atoms));
    add({nominal(clauses::IndividualId{pair.first})}, {{LiteralKind::unary, 0, 0, marker}});
  }
  for (const clauses::DataFact& fact : clauses_.data_facts) {
    const std::uint32_t marker =
        add_expansion(1, {{LiteralKind::outgoing, 1, 0, data_role_base_ + number(fact.property)},
                          {LiteralKind::unary, 1, 0, range_predicate_[fact_values_.at(fact.value)]}});
    add({nominal(fact.individual)}, {{LiteralKind::unary, 0, 0, marker}});
  }
  for (const clauses::Equality& equality : clauses_.equalities) {
    if (equality.is_negated) {
      add({nominal(equality.first), nominal(equality.second)}, {});
    } else {
      add({nominal(equality.first)}, {nominal(equality.second)});
      add({nominal(equality.second)}, {nominal(equality.first)});
    }
  }
}

//  D < D1 or ... or Dn   [D is their union]        D < Di   [D is their intersection]
//  D < F           [D has no value]
//  D and E < F     [D and E have none in common]
//  {v} < Bi  or  {v} < Ci,  Bi and Ci < F    for each bit i of v's number: two values differ in one of them
void RuleBuilder::add_values() {
  std::vector<clauses::DataRange> ranges(clauses_.data_ranges.begin(), clauses_.data_ranges.end());
  ranges.resize(ranges.size() + fact_values_.size());
  for (const auto& [value, position] : fact_values_) ranges[position] = {value, false};
  if (ranges.size() <= 2) return;
  const std::vector<RangeParts> apart = take_apart(source_, clauses_.datatype_definitions, ranges);
  while (range_predicate_.size() < ranges.size()) range_predicate_.push_back(result_.predicate_count++);
  const ValueConflicts conflicts = conflicts_of(source_, clauses_.datatype_definitions, ranges, apart);
  const auto range = [this](std::size_t position) {
    return RuleAtom{LiteralKind::unary, 0, 0, range_predicate_[position]};
  };
  for (const RangeParts& parts : apart) {
    Atoms heads;
    for (const std::size_t part : parts.parts) heads.push_back(range(part));
    if (parts.is_union) {
      add({range(parts.range)}, heads);
    } else {
      for (const RuleAtom& head : heads) add({range(parts.range)}, {head});
    }
  }
  for (const std::size_t empty : conflicts.empty) add({range(empty)}, {});
  for (const auto& [first, second] : conflicts.disjoint) add({range(first), range(second)}, {});
  const std::uint32_t greatest = conflicts.value_number.empty() ? 0 : std::ranges::max(conflicts.value_number);
  for (std::uint32_t bit = 0; greatest > 1 && (greatest >> bit) != 0; ++bit) {
    const RuleAtom zero{LiteralKind::unary, 0, 0, result_.predicate_count++};
    const RuleAtom one{LiteralKind::unary, 0, 0, result_.predicate_count++};
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      if (conflicts.value_number[i] == 0) continue;
      add({range(i)}, {((conflicts.value_number[i] >> bit) & 1) != 0 ? one : zero});
    }
    add({zero, one}, {});
  }
  is_finite_ = conflicts.is_finite;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (conflicts.is_unclear[i]) unclear_.push_back(range_predicate_[i]);
  }
  result_.gaps.insert(result_.gaps.end(), conflicts.gaps.begin(), conflicts.gaps.end());
}

void RuleBuilder::find_gaps() {
  result_.is_open.assign(result_.predicate_count, false);
  for (const std::uint32_t range : unclear_) result_.is_open[range] = true;
  for (const std::uint32_t nominal : result_.nominal_of) result_.is_open[nominal] = true;
  // A nominal matters beyond its own facts if a rule may conclude it.
  std::vector<bool> is_nominal(result_.predicate_count, false);
  for (const std::uint32_t nominal : result_.nominal_of) is_nominal[nominal] = true;
  const auto names_individual = [&](const clauses::Atom& atom) {
    return atom.kind == clauses::AtomKind::concept_of && is_nominal[result_.predicate_of[atom.predicate]];
  };
  const auto is_filler = [&](const auto& restriction) {
    return is_nominal[result_.predicate_of[number(restriction.filler)]];
  };
  if (std::ranges::any_of(
          clauses_.clauses,
          [&](const clauses::Clause& clause) { return std::ranges::any_of(clause.head, names_individual); }) ||
      std::ranges::any_of(clauses_.at_leasts, is_filler) || std::ranges::any_of(clauses_.at_mosts, is_filler)) {
    result_.gaps.emplace_back(nominal_gap);
  }
  if (with_facts_ && !clauses_.keys.empty() && clauses_.individuals.size() > 1) result_.gaps.emplace_back(key_gap);
  const bool has_links = with_facts_ && !clauses_.role_facts.empty();
  if (has_links && std::ranges::any_of(result_.rules, [](const Rule& rule) { return rule.head.size() > 1; })) {
    result_.gaps.emplace_back(fact_gap);
  }
  // Values are counted as if there were always enough of them.
  if (!is_finite_) return;
  const bool counts = std::ranges::any_of(clauses_.data_at_leasts, [](const auto& one) { return one.count > 1; });
  const bool compares = std::ranges::any_of(result_.rules, [this](const Rule& rule) {
    std::vector<std::uint8_t> seen;
    for (const RuleAtom& atom : rule.body) {
      if (atom.kind != LiteralKind::outgoing || atom.predicate < data_role_base_) continue;
      if (atom.predicate >= data_role_base_ + clauses_.data_properties.size()) continue;
      if (std::ranges::find(seen, atom.first) != seen.end()) return true;
      seen.push_back(atom.first);
    }
    return false;
  });
  if (counts || compares) result_.gaps.emplace_back(value_gap);
}

}  // namespace geminga::consequence
