// Adds up what the clauses ask for, one level of neighbours more in each round.
#include "reasoning/dl/hypertableau/program/burdens.hpp"

#include <algorithm>

namespace geminga::hypertableau {

using clauses::Atom;
using clauses::AtomKind;
using clauses::centre;
using clauses::Clause;
using clauses::number;

namespace {

/// The levels of neighbours that are counted.
constexpr int levels = 4;

std::uint32_t bounded(std::uint64_t burden) {
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(burden, Burdens::most));
}

bool is_range(const Clause& clause) {
  return clause.body.size() == 1 && clause.head.size() == 1 && clause.body[0].kind == AtomKind::role &&
         clause.body[0].first != clause.body[0].second && clause.head[0].kind == AtomKind::concept_of;
}

}  // namespace

Burdens::Burdens(const clauses::ClauseSet& set, const Domains& domains, const Denials& denials)
    : of_concept_(domains.concept_count(), 0),
      of_at_least_(set.at_leasts.size(), 1),
      ranges_(2 * set.properties.size()) {
  for (const Clause& clause : set.clauses) {
    if (!is_range(clause)) continue;
    const bool is_of_second = clause.head[0].first == clause.body[0].second;
    ranges_[2 * std::size_t{clause.body[0].predicate} + (is_of_second ? 0 : 1)].push_back(clause.head[0].predicate);
  }
  for (int level = 0; level < levels; ++level) {
    weigh_at_leasts(set, domains);
    std::vector<std::uint64_t> sums(of_concept_.size(), 0);
    for (const Clause& clause : set.clauses) look(clause, sums);
    for (const Clause& clause : domains.clauses()) look(clause, sums);
    std::ranges::transform(sums, of_concept_.begin(), bounded);
  }
  weigh_at_leasts(set, domains);
  of_concept_beside_ = of_concept_;
  for (const Clause& clause : set.clauses) look_beside(clause);
  of_at_least_beside_ = of_at_least_;
  for (std::size_t index = 0; index < of_at_least_.size(); ++index) {
    const clauses::AtLeast& one = set.at_leasts[index];
    if (one.count == 1 && denials.is_denial(number(one.filler))) of_at_least_beside_[index] = 0;
  }
}

// A(x), R(x,y) -> H(y): the neighbour is there, and is asked for H.
void Burdens::look_beside(const Clause& clause) {
  if (clause.body.size() != 2 || clause.head.empty()) return;
  const auto looking = std::ranges::find(clause.body, AtomKind::concept_of, &Atom::kind);
  const auto edge = std::ranges::find(clause.body, AtomKind::role, &Atom::kind);
  if (looking == clause.body.end() || edge == clause.body.end() || edge->first == edge->second) return;
  std::uint64_t least = most;
  for (const Atom& atom : clause.head) {
    if (atom.kind == AtomKind::equal || atom.first == looking->first) return;
    least = std::min(least, std::uint64_t{1} + burden_of(atom));
  }
  std::uint32_t& sum = of_concept_beside_[looking->predicate];
  sum = bounded(sum + least);
}

void Burdens::weigh_at_leasts(const clauses::ClauseSet& set, const Domains& domains) {
  for (std::uint32_t index = 0; index < of_at_least_.size(); ++index) {
    const clauses::AtLeast& one = set.at_leasts[index];
    std::uint64_t neighbour = std::uint64_t{1} + of_concept_[number(one.filler)];
    for (const std::uint32_t id : ranges_[2 * std::size_t{number(one.role.property)} + (one.role.is_inverse ? 1 : 0)])
      neighbour += of_concept_[id];
    std::uint64_t all = one.count * std::min<std::uint64_t>(neighbour, most);
    for (const std::uint32_t id : domains.of_at_least(index)) all += of_concept_[id];
    of_at_least_[index] = bounded(all);
  }
}

void Burdens::look(const Clause& clause, std::vector<std::uint64_t>& sums) const {
  const bool is_of_one = clause.body.size() == 1 && clause.body[0].kind == AtomKind::concept_of && !clause.head.empty();
  if (!is_of_one) return;
  std::uint64_t least = most;
  for (const Atom& atom : clause.head) least = std::min(least, burden_of(atom));
  sums[clause.body[0].predicate] += least;
}

std::uint64_t Burdens::burden_of(const Atom& atom) const {
  if (atom.kind == AtomKind::concept_of) return of_concept_[atom.predicate];
  return atom.kind == AtomKind::at_least ? of_at_least_[atom.predicate] : 0;
}

}  // namespace geminga::hypertableau
