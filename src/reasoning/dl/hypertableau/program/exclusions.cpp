// Exclusions that are told of the things above count for those below.
#include "reasoning/dl/hypertableau/program/exclusions.hpp"

#include <algorithm>
#include <cstddef>

#include "base/sorted.hpp"

namespace geminga::hypertableau {
namespace {

using clauses::Atom;
using clauses::AtomKind;
using clauses::centre;
using clauses::Clause;

/// All that is told of something above, ascending.
std::vector<std::uint32_t> told_above(const std::vector<std::vector<std::uint32_t>>& told, Hierarchy& hierarchy,
                                      std::uint32_t start) {
  std::vector<std::uint32_t> result;
  for (const std::uint32_t above : hierarchy.all_above(start))
    result.insert(result.end(), told[above].begin(), told[above].end());
  base::sort_unique(result);
  return result;
}

}  // namespace

ConceptExclusions::ConceptExclusions(const clauses::ClauseSet& set, Hierarchy& hierarchy)
    : hierarchy_(hierarchy), told_(set.concepts.size()), unions_(set.concepts.size()) {
  for (const Clause& clause : set.clauses) look(clause);
}

std::vector<std::uint32_t> ConceptExclusions::of(std::uint32_t id) {
  std::vector<std::uint32_t> result = told_of(id);
  for (const std::uint32_t above : hierarchy_.all_above(id)) {
    for (const std::vector<std::uint32_t>& alternatives : unions_[above]) {
      std::vector<std::uint32_t> common = told_of(alternatives.front());
      for (std::size_t at = 1; at < alternatives.size() && !common.empty(); ++at) {
        const std::vector<std::uint32_t> next = told_of(alternatives[at]);
        std::erase_if(common, [&](std::uint32_t one) { return !std::ranges::binary_search(next, one); });
      }
      result.insert(result.end(), common.begin(), common.end());
    }
  }
  base::sort_unique(result);
  return result;
}

void ConceptExclusions::look(const Clause& clause) {
  const auto is_concept = [](const Atom& atom) { return atom.kind == AtomKind::concept_of && atom.first == centre; };
  if (!std::ranges::all_of(clause.body, is_concept) || !std::ranges::all_of(clause.head, is_concept)) return;
  if (clause.body.size() == 2 && clause.head.empty()) {
    told_[clause.body[0].predicate].push_back(clause.body[1].predicate);
    told_[clause.body[1].predicate].push_back(clause.body[0].predicate);
  } else if (clause.body.size() == 1 && clause.head.size() > 1) {
    std::vector<std::uint32_t>& alternatives = unions_[clause.body.front().predicate].emplace_back();
    for (const Atom& atom : clause.head) alternatives.push_back(atom.predicate);
  }
}

std::vector<std::uint32_t> ConceptExclusions::told_of(std::uint32_t id) { return told_above(told_, hierarchy_, id); }

RoleExclusions::RoleExclusions(const clauses::ClauseSet& set, Hierarchy& hierarchy) : hierarchy_(hierarchy) {
  const auto first_data = static_cast<std::uint32_t>(set.properties.size()) * 2;
  told_.resize(first_data + set.data_properties.size());
  for (const Clause& clause : set.clauses) {
    if (clause.body.size() != 2 || !clause.head.empty()) continue;
    const Atom& one = clause.body.front();
    const Atom& other = clause.body.back();
    if (one.kind == AtomKind::data_role && other.kind == AtomKind::data_role) {
      if (one.first == other.first && one.second == other.second)
        add(first_data + one.predicate, first_data + other.predicate);
    } else if (one.kind == AtomKind::role && other.kind == AtomKind::role && one.first != one.second) {
      const bool are_alike = one.first == other.first && one.second == other.second;
      if (!are_alike && (one.first != other.second || one.second != other.first)) continue;
      // R(x,y), S(x,y) or S(y,x) -> false, and the same of the inverses.
      const std::uint32_t turn = are_alike ? 0U : 1U;
      add(one.predicate * 2, (other.predicate * 2) ^ turn);
      add(one.predicate * 2 + 1, (other.predicate * 2 + 1) ^ turn);
    }
  }
}

std::vector<std::uint32_t> RoleExclusions::of(std::uint32_t direction) {
  return told_above(told_, hierarchy_, direction);
}

void RoleExclusions::add(std::uint32_t one, std::uint32_t other) {
  told_[one].push_back(other);
  told_[other].push_back(one);
}

}  // namespace geminga::hypertableau
