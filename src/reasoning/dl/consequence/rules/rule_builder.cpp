#include "reasoning/dl/consequence/rules/rule_builder.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reasoning/dl/clauses/counted_neighbours.hpp"
#include "reasoning/dl/consequence/rules/centred_rules.hpp"
#include "reasoning/dl/consequence/rules/expansions.hpp"
#include "reasoning/dl/consequence/rules/fact_rules.hpp"
#include "reasoning/dl/consequence/rules/gaps.hpp"
#include "reasoning/dl/consequence/rules/predicates.hpp"
#include "reasoning/dl/consequence/rules/value_rules.hpp"

namespace geminga::consequence {
namespace {

using clauses::AtomKind;
using clauses::number;

/// Adds the rules and expansions of clauses.
class ClauseRules {
 public:
  ClauseRules(const clauses::ClauseSet& clauses, const Predicates& predicates, Expansions& expansions,
              CentredRules& rules, std::vector<std::string>& gaps)
      : clauses_(clauses), predicates_(predicates), expansions_(expansions), rules_(rules), gaps_(gaps) {}

  /// Adds the expansions of the at-leasts, which are the first, and the rules of the at-mosts.
  void make_expansions();
  void add_clause(const clauses::Clause& clause);
  /// The predicates that the rules do not use fully.
  [[nodiscard]] const std::vector<std::uint32_t>& open() const { return open_; }

 private:
  /// Adds: an at-least and an at-most of a smaller number exclude each other.
  void exclude_each_other();
  /// Appends the atom in the form of this calculus. False: it is a role between two neighbours, which no rule can have.
  /// Sets `is_redundant` if the atom is false in a body or true in a head.
  [[nodiscard]] bool convert(const clauses::Atom& atom, bool is_head, Atoms& atoms, bool& is_redundant) const;

  const clauses::ClauseSet& clauses_;
  const Predicates& predicates_;
  Expansions& expansions_;
  CentredRules& rules_;
  std::vector<std::string>& gaps_;
  std::vector<std::uint32_t> open_;
};

void ClauseRules::make_expansions() {
  const auto role_of = [](const clauses::Role& role) {
    return RuleAtom{role.is_inverse ? LiteralKind::incoming : LiteralKind::outgoing, 1, 0, number(role.property)};
  };
  const auto data_role_of = [this](clauses::DataPropertyId property) {
    return RuleAtom{LiteralKind::outgoing, 1, 0, predicates_.data_role(property)};
  };
  const clauses::CountedNeighbours counted(clauses_, clauses::UsedAtMosts::inlined);
  std::uint32_t marker = predicates_.first_marker;
  const auto expand = [&](std::uint32_t needed, Atoms atoms) {
    if (needed > max_successors) open_.push_back(marker);
    static_cast<void>(expansions_.add(std::min(needed, max_successors), std::move(atoms)));
    return marker++;
  };
  for (const clauses::AtLeast& at_least : clauses_.at_leasts) {
    Atoms atoms{role_of(at_least.role)};
    if (at_least.filler != clauses::thing) atoms.push_back(predicates_.concept_atom(at_least.filler, 1));
    const std::uint32_t expanded = expand(counted.enough(at_least), std::move(atoms));
    if (at_least.filler == clauses::nothing) rules_.add({unary_atom(expanded)}, {});
  }
  for (const clauses::DataAtLeast& at_least : clauses_.data_at_leasts) {
    Atoms atoms{data_role_of(at_least.property)};
    const std::uint32_t range = number(at_least.range);
    if (range != 0) atoms.push_back(unary_atom(predicates_.range[range], 1));
    expand(counted.enough(at_least), std::move(atoms));
  }
  // The rules of the at-mosts would have too many variables.
  const clauses::CountedNeighbours all(clauses_, clauses::UsedAtMosts::all);
  marker = predicates_.first_at_most;
  const auto leave_out = [&](const auto& at_most) {
    if (all.may_exceed(at_most)) open_.push_back(marker);
    ++marker;
  };
  std::ranges::for_each(clauses_.at_mosts, leave_out);
  std::ranges::for_each(clauses_.data_at_mosts, leave_out);
  if (!open_.empty()) gaps_.emplace_back(number_gap);
  exclude_each_other();
}

//  >= n R.B, <= m R.B < F    >= n R.B, <= m R < F    where m < n
void ClauseRules::exclude_each_other() {
  std::size_t pairs = 0;
  const auto exclude = [&](std::uint32_t first, const auto& at_leasts, std::uint32_t first_at_most,
                           const auto& at_mosts, auto&& are_alike) {
    for (std::uint32_t most = 0; most < at_mosts.size(); ++most) {
      for (std::uint32_t least = 0; least < at_leasts.size(); ++least) {
        if (at_leasts[least].count <= at_mosts[most].count || !are_alike(at_leasts[least], at_mosts[most])) continue;
        if (++pairs > max_exclusive_numbers) return;
        rules_.add({unary_atom(first + least), unary_atom(first_at_most + most)}, {});
      }
    }
  };
  exclude(predicates_.first_marker, clauses_.at_leasts, predicates_.first_at_most, clauses_.at_mosts,
          [](const clauses::AtLeast& least, const clauses::AtMost& most) {
            return least.role == most.role && (least.filler == most.filler || most.filler == clauses::thing);
          });
  exclude(predicates_.first_marker + static_cast<std::uint32_t>(clauses_.at_leasts.size()), clauses_.data_at_leasts,
          predicates_.first_at_most + static_cast<std::uint32_t>(clauses_.at_mosts.size()), clauses_.data_at_mosts,
          [](const clauses::DataAtLeast& least, const clauses::DataAtMost& most) {
            return least.property == most.property && (least.range == most.range || number(most.range) == 0);
          });
}

bool ClauseRules::convert(const clauses::Atom& atom, bool is_head, Atoms& atoms, bool& is_redundant) const {
  const auto expansion = [&](std::uint32_t index, bool is_trivial) {
    if (is_trivial) is_redundant = true;
    atoms.push_back(unary_atom(predicates_.first_marker + index, atom.first));
  };
  switch (atom.kind) {
    case AtomKind::concept_of: {
      const RuleAtom made = predicates_.concept_atom(clauses::ConceptId{atom.predicate}, atom.first);
      if (made.predicate == (is_head ? predicates_.thing : predicates_.nothing)) is_redundant = true;
      if (made.predicate != predicates_.thing && made.predicate != predicates_.nothing) atoms.push_back(made);
      return true;
    }
    case AtomKind::role:
    case AtomKind::data_role: {
      const std::uint32_t role = atom.predicate + (atom.kind == AtomKind::data_role ? predicates_.first_data_role : 0);
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
        atoms.push_back(unary_atom(predicates_.range[atom.predicate], atom.first));
      }
      return true;
    case AtomKind::at_most:
      atoms.push_back(unary_atom(predicates_.first_at_most + atom.predicate, atom.first));
      return true;
    case AtomKind::data_at_most:
      atoms.push_back(
          unary_atom(predicates_.first_at_most + static_cast<std::uint32_t>(clauses_.at_mosts.size()) + atom.predicate,
                     atom.first));
      return true;
  }
  return false;
}

void ClauseRules::add_clause(const clauses::Clause& clause) {
  Atoms body;
  Atoms head;
  bool is_redundant = false;
  bool is_understood = true;
  for (const clauses::Atom& atom : clause.body) is_understood &= convert(atom, false, body, is_redundant);
  for (const clauses::Atom& atom : clause.head) is_understood &= convert(atom, true, head, is_redundant);
  if (is_redundant) return;
  if (!is_understood) {
    gaps_.emplace_back("a clause with a property between two neighbours");
    return;
  }
  rules_.add(std::move(body), std::move(head));
}

/// Notes which predicates are open, and which parts of the ontology the calculus cannot use fully.
void find_gaps(const clauses::ClauseSet& clauses, const UnsaidOfRanges& unsaid,
               std::span<const std::uint32_t> open_numbers, bool with_facts, std::uint32_t first_data_role,
               RuleSet& set) {
  set.is_open.assign(set.predicate_count, false);
  for (const std::uint32_t predicate : open_numbers) set.is_open[predicate] = true;
  for (const std::uint32_t range : unsaid.unclear) set.is_open[range] = true;
  for (const std::uint32_t nominal : set.nominal_of) set.is_open[nominal] = true;
  // A nominal matters beyond its own facts if a rule may conclude it.
  std::vector<bool> is_nominal(set.predicate_count, false);
  for (const std::uint32_t nominal : set.nominal_of) is_nominal[nominal] = true;
  const auto names_individual = [&](const clauses::Atom& atom) {
    return atom.kind == clauses::AtomKind::concept_of && is_nominal[set.predicate_of[atom.predicate]];
  };
  const auto is_filler = [&](const auto& restriction) {
    return is_nominal[set.predicate_of[number(restriction.filler)]];
  };
  if (std::ranges::any_of(
          clauses.clauses,
          [&](const clauses::Clause& clause) { return std::ranges::any_of(clause.head, names_individual); }) ||
      std::ranges::any_of(clauses.at_leasts, is_filler) || std::ranges::any_of(clauses.at_mosts, is_filler)) {
    set.gaps.emplace_back(nominal_gap);
  }
  if (with_facts && !clauses.keys.empty() && clauses.individuals.size() > 1) set.gaps.emplace_back(key_gap);
  if (with_facts && !clauses.rules.empty()) set.gaps.emplace_back(rule_gap);
  if (with_facts && clauses.apart.size() > max_apart) set.gaps.emplace_back(apart_gap);
  const bool has_links = with_facts && !clauses.role_facts.empty();
  if (has_links && std::ranges::any_of(set.rules, [](const Rule& rule) { return rule.head.size() > 1; })) {
    set.gaps.emplace_back(fact_gap);
  }
  // Values are counted as if there were always enough of them.
  if (!unsaid.is_finite) return;
  const bool counts = std::ranges::any_of(clauses.data_at_leasts, [](const auto& one) { return one.count > 1; });
  const bool compares = std::ranges::any_of(set.rules, [&](const Rule& rule) {
    std::vector<std::uint8_t> seen;
    for (const RuleAtom& atom : rule.body) {
      if (atom.kind != LiteralKind::outgoing || atom.predicate < first_data_role) continue;
      if (atom.predicate >= first_data_role + clauses.data_properties.size()) continue;
      if (std::ranges::find(seen, atom.first) != seen.end()) return true;
      seen.push_back(atom.first);
    }
    return false;
  });
  if (counts || compares) set.gaps.emplace_back(value_gap);
}

}  // namespace

RuleSet build_rules(const owl::Ontology& source, const clauses::ClauseSet& clauses, bool with_facts) {
  const GatheredFacts facts = with_facts ? gather_facts(clauses) : GatheredFacts();
  const Predicates predicates = number_predicates(clauses, facts.expansions, facts.values.size());
  Expansions expansions(predicates.first_marker, predicates.first_data_role);
  CentredRules rules(predicates.count, predicates.role_count);
  RuleSet set;
  ClauseRules of_clauses(clauses, predicates, expansions, rules, set.gaps);
  of_clauses.make_expansions();
  for (const clauses::Clause& clause : clauses.clauses) of_clauses.add_clause(clause);
  if (with_facts) add_fact_rules(clauses, facts, predicates, expansions, rules);
  const UnsaidOfRanges unsaid = add_value_rules(source, clauses, facts.values, predicates, rules);
  set.query_count = predicates.query_count;
  set.predicate_of = predicates.predicate_of;
  set.query_concepts = predicates.query_concepts;
  set.nominal_of = predicates.nominal_of;
  set.first_marker = predicates.first_marker;
  rules.move_to(set);
  expansions.move_to(set);
  set.gaps.insert(set.gaps.end(), unsaid.gaps.begin(), unsaid.gaps.end());
  find_gaps(clauses, unsaid, of_clauses.open(), with_facts, predicates.first_data_role, set);
  return set;
}

}  // namespace geminga::consequence
