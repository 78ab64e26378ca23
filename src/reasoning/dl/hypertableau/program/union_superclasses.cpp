// Goes down from each filler, and through a union once all its alternatives are reached.
#include "reasoning/dl/hypertableau/program/union_superclasses.hpp"

#include <algorithm>

#include "base/sorted.hpp"

namespace geminga::hypertableau {

using clauses::Atom;
using clauses::AtomKind;
using clauses::centre;
using clauses::Clause;

UnionSuperclasses::UnionSuperclasses(const clauses::ClauseSet& set, std::span<const std::uint32_t> fillers)
    : told_below_(set.concepts.size()), in_unions_(set.concepts.size()), found_for_(set.concepts.size(), 0) {
  if (fillers.empty()) return;
  for (const Clause& clause : set.clauses) look(clause);
  if (unions_.empty()) return;
  for (const std::uint32_t filler : fillers) find_below(filler);
}

void UnionSuperclasses::look(const Clause& clause) {
  const auto is_concept = [](const Atom& atom) { return atom.kind == AtomKind::concept_of && atom.first == centre; };
  if (clause.body.size() != 1 || clause.head.empty() || !is_concept(clause.body.front()) ||
      !std::ranges::all_of(clause.head, is_concept))
    return;
  const std::uint32_t low = clause.body.front().predicate;
  if (clause.head.size() == 1) return told_below_[clause.head.front().predicate].push_back(low);
  std::vector<std::uint32_t> alternatives;
  for (const Atom& atom : clause.head) alternatives.push_back(atom.predicate);
  base::sort_unique(alternatives);
  for (const std::uint32_t id : alternatives) in_unions_[id].push_back(static_cast<std::uint32_t>(unions_.size()));
  unions_.push_back({low, static_cast<std::uint32_t>(alternatives.size())});
}

void UnionSuperclasses::find_below(std::uint32_t filler) {
  ++fillers_;
  std::vector<std::uint32_t> found;
  const auto reach = [&](std::uint32_t id) {
    ++looks_;
    if (found_for_[id] == fillers_) return false;
    found_for_[id] = fillers_;
    found.push_back(id);
    return true;
  };
  reach(filler);
  std::vector<std::uint32_t> begun;
  for (std::size_t at = 0; at < found.size() && looks_ < max_looks; ++at) {
    const std::uint32_t id = found[at];
    for (const std::uint32_t low : told_below_[id]) reach(low);
    for (const std::uint32_t of : in_unions_[id]) {
      ++looks_;
      Union& one = unions_[of];
      if (one.below++ == 0) begun.push_back(of);
      if (one.below != one.alternatives || !reach(one.concept_id)) continue;
      clauses_.push_back(
          {{{AtomKind::concept_of, centre, centre, one.concept_id}}, {{AtomKind::concept_of, centre, centre, filler}}});
    }
  }
  for (const std::uint32_t of : begun) unions_[of].below = 0;
}

}  // namespace geminga::hypertableau
