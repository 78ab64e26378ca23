// How covers are found: from each at-least over the unions that its neighbours are in to the bounds of their
// alternatives.
#include "reasoning/dl/hypertableau/program/covers.hpp"

#include <algorithm>

#include "base/sorted.hpp"
#include "reasoning/dl/hypertableau/program/directions.hpp"

namespace geminga::hypertableau {

using clauses::Atom;
using clauses::AtomKind;
using clauses::centre;
using clauses::Clause;
using clauses::number;
using clauses::Variable;

namespace {

bool is_among(std::span<const std::uint32_t> some, std::span<const std::uint32_t> all) {
  return std::ranges::includes(all, some);
}

}  // namespace

Covers::Covers(const clauses::ClauseSet& set, std::span<const Clause> inclusions, std::span<const Bound> bounds)
    : bounds_(bounds), is_used_(bounds.size(), false) {
  for (std::uint32_t at = 0; at < bounds.size(); ++at) {
    const Bound& one = bounds[at];
    if (one.is_data || one.unless != no_predicate) continue;
    bounds_in_[direction_of(one.property, one.is_inverse)].push_back(at);
  }
  if (bounds_in_.empty()) return;
  roles_ = hierarchy_of_roles(set);
  concepts_ = hierarchy_of_concepts(set, inclusions);
  for (const Clause& clause : set.clauses) look(clause);
  if (said_.empty()) return;
  covers_.resize(set.at_leasts.size());
  for (std::size_t at = 0; at < covers_.size(); ++at) {
    if (looks_ < max_looks) find_covers(set.at_leasts[at], covers_[at]);
  }
  for (const std::vector<Cover>& all : covers_) {
    for (const Cover& cover : all) {
      for (const std::vector<Limit>& limits : cover.alternatives) {
        for (const Limit& limit : limits) {
          if (limit.bound != no_predicate) is_used_[limit.bound] = true;
        }
      }
    }
  }
  bounds_ = {};
}

// A clause about one thing is one about the neighbour; one about an edge is looked at from both ends.
void Covers::look(const Clause& clause) {
  const auto edge = std::ranges::find(clause.body, AtomKind::role, &Atom::kind);
  if (edge == clause.body.end()) {
    constexpr Variable no_node = 255;
    if (clause.body.size() != 1 || clause.head.size() != 1) look(clause, no_node, centre);
  } else if (edge->first != edge->second) {
    look(clause, edge->first, edge->second);
    look(clause, edge->second, edge->first);
  }
}

void Covers::look(const Clause& clause, Variable node, Variable neighbour) {
  Said said;
  for (const Atom& atom : clause.body) {
    if (atom.kind == AtomKind::concept_of && atom.first == node) {
      said.of_node.push_back(atom.predicate);
    } else if (atom.kind == AtomKind::concept_of && atom.first == neighbour) {
      said.of_neighbour.push_back(atom.predicate);
    } else if (atom.kind == AtomKind::role && said.direction == no_predicate && atom.first != atom.second) {
      said.direction = direction_of(atom.predicate, atom.first == neighbour);
    } else {
      return;
    }
  }
  for (const Atom& atom : clause.head) {
    if (atom.kind != AtomKind::concept_of || atom.first != neighbour) return;
    said.alternatives.push_back(atom.predicate);
  }
  base::sort_unique(said.of_neighbour);
  const auto id = static_cast<std::uint32_t>(said_.size());
  const bool has_concept = !said.of_neighbour.empty();
  const std::uint32_t key = has_concept ? said.of_neighbour.front() : said.direction;
  if (!has_concept && said.direction == no_predicate) {
    by_concept_[number(clauses::thing)].push_back(id);
  } else {
    (has_concept ? by_concept_ : by_direction_)[key].push_back(id);
  }
  said_.push_back(std::move(said));
}

std::vector<const Covers::Said*> Covers::said_of(const Asked& asked) {
  std::vector<const Said*> found;
  const auto add = [&](const std::map<std::uint32_t, std::vector<std::uint32_t>>& index, std::uint32_t key) {
    const auto at = index.find(key);
    if (at == index.end()) return;
    for (const std::uint32_t id : at->second) {
      ++looks_;
      const Said& said = said_[id];
      if (!is_among(said.of_neighbour, asked.concepts)) continue;
      if (said.direction == no_predicate || std::ranges::binary_search(asked.directions, said.direction))
        found.push_back(&said);
    }
  };
  for (const std::uint32_t direction : asked.directions) add(by_direction_, direction);
  for (const std::uint32_t id : asked.concepts) add(by_concept_, id);
  return found;
}

/// Adds what is said of neighbours in several concepts, or of all in a direction, whatever the node is in.
void Covers::add_joint(Asked& asked) {
  bool is_done = false;
  while (!is_done) {
    is_done = true;
    base::sort_unique(asked.concepts);
    std::vector<std::uint32_t> joint;
    for (const Said* said : said_of(asked)) {
      if (said->of_node.empty() && said->alternatives.size() == 1) joint.push_back(said->alternatives.front());
    }
    for (const std::uint32_t id : joint) {
      if (std::ranges::binary_search(asked.concepts, id)) continue;
      const std::vector<std::uint32_t> above = concepts_.all_above(id);
      asked.concepts.insert(asked.concepts.end(), above.begin(), above.end());
      is_done = false;
    }
  }
}

std::vector<Limit> Covers::limits_of(const Asked& asked) {
  std::vector<Limit> limits;
  for (const Said* said : said_of(asked)) {
    if (said->alternatives.empty()) limits.push_back({0, no_predicate, said->of_node});
  }
  for (const std::uint32_t direction : asked.directions) {
    const auto found = bounds_in_.find(direction);
    if (found == bounds_in_.end()) continue;
    for (const std::uint32_t bound : found->second) {
      ++looks_;
      const std::uint32_t filler = bounds_[bound].filler;
      if (filler == no_predicate || std::ranges::binary_search(asked.concepts, filler))
        limits.push_back({bounds_[bound].count, bound, {}});
    }
  }
  std::ranges::stable_sort(limits, {}, &Limit::count);
  return limits;
}

bool Covers::add_limits(const Asked& asked, std::uint32_t alternative, int depth, Cover& cover) {
  constexpr int most_depth = 3;
  constexpr std::size_t most_alternatives = 64;
  if (cover.alternatives.size() == most_alternatives) return false;
  Asked part{asked.directions, concepts_.all_above(alternative)};
  part.concepts.insert(part.concepts.end(), asked.concepts.begin(), asked.concepts.end());
  add_joint(part);
  std::vector<Limit> limits = limits_of(part);
  if (!limits.empty()) {
    cover.alternatives.push_back(std::move(limits));
    return true;
  }
  if (depth == most_depth) return false;
  for (const Said* said : said_of(part)) {
    if (said->direction != no_predicate || said->alternatives.size() < 2) continue;
    const std::size_t before = cover.alternatives.size();
    if (std::ranges::all_of(said->alternatives,
                            [&](std::uint32_t id) { return add_limits(asked, id, depth + 1, cover); }))
      return true;
    cover.alternatives.resize(before);
  }
  return false;
}

void Covers::find_covers(const clauses::AtLeast& at_least, std::vector<Cover>& found) {
  Asked asked{roles_.all_above(direction_of(number(at_least.role.property), at_least.role.is_inverse)),
              concepts_.all_above(number(at_least.filler))};
  const bool may_be_limited = std::ranges::any_of(asked.directions, [this](std::uint32_t direction) {
    return bounds_in_.contains(direction) || by_direction_.contains(direction);
  });
  if (!may_be_limited) return;
  asked.concepts.push_back(number(clauses::thing));
  add_joint(asked);
  for (const Said* said : said_of(asked)) {
    if (said->alternatives.empty() || found.size() == max_covers || looks_ >= max_looks) continue;
    Cover cover{said->of_node, {}};
    const bool is_covered = std::ranges::all_of(
        said->alternatives, [&](std::uint32_t alternative) { return add_limits(asked, alternative, 0, cover); });
    const auto is_enough = [&](const std::vector<Limit>& limits) { return limits.front().count >= at_least.count; };
    if (is_covered && std::ranges::none_of(cover.alternatives, is_enough)) found.push_back(std::move(cover));
  }
}

}  // namespace geminga::hypertableau
