// How at-mosts are recognised in clauses, and their numbers added up.
#include "reasoning/dl/clauses/counted_neighbours.hpp"

#include <algorithm>

namespace geminga::clauses {
namespace {

bool is_equality(const Atom& atom) { return atom.kind == AtomKind::equal || atom.kind == AtomKind::data_equal; }

bool is_edge(const Atom& atom) { return atom.kind == AtomKind::role || atom.kind == AtomKind::data_role; }

/// The neighbour that the atom is about, or the centre.
Variable neighbour_of(const Atom& atom) { return std::max(atom.first, atom.second); }

}  // namespace

CountedNeighbours::CountedNeighbours(const ClauseSet& set, UsedAtMosts used)
    : first_data_(static_cast<std::uint32_t>(set.properties.size()) * 2) {
  is_plain_ = std::ranges::none_of(set.concepts, [](const Concept& one) { return one.kind == ConceptKind::nominal; });
  above_.resize(first_data_ + set.data_properties.size());
  for (const Clause& clause : set.clauses) {
    note_hierarchy(clause);
    note_at_most(clause);
  }
  if (used == UsedAtMosts::all) {
    for (const AtMost& one : set.at_mosts) {
      note_family({direction_of(one.role), {{AtomKind::concept_of, centre, centre, number(one.filler)}}}, one.count);
    }
    for (const DataAtMost& one : set.data_at_mosts) {
      note_family({direction_of(one.property), {{AtomKind::data_range, centre, centre, number(one.range)}}}, one.count);
    }
  }
  sum_up();
  count_asked(set);
}

std::optional<CountedNeighbours::Direction> CountedNeighbours::direction_of(const Atom& atom) const {
  if (atom.kind == AtomKind::data_role) return direction_of(DataPropertyId{atom.predicate});
  if (atom.kind != AtomKind::role || atom.first == atom.second) return std::nullopt;
  return direction_of(Role{PropertyId{atom.predicate}, atom.first != centre});
}

// R(x,y) in a body and S(x,y) in the head: an R-neighbour may become an S-neighbour.
void CountedNeighbours::note_hierarchy(const Clause& clause) {
  for (const Atom& head : clause.head) {
    const auto to = direction_of(head);
    if (!to) continue;
    for (const Atom& body : clause.body) {
      const auto from = direction_of(body);
      if (!from || neighbour_of(body) != neighbour_of(head)) continue;
      above_[*from].push_back(*to);
      if (head.kind == AtomKind::role && body.kind == AtomKind::role) above_[*from ^ 1U].push_back(*to ^ 1U);
    }
  }
}

//   guard(x), R(x,y1), B(y1), ..., R(x,yn+1), B(yn+1) -> alternatives(x) or y1=y2 or y1=y3 or ...
// counts n neighbours. With an equality of another form, nothing is known.
void CountedNeighbours::note_at_most(const Clause& clause) {
  const auto equalities = static_cast<std::size_t>(std::ranges::count_if(clause.head, is_equality));
  if (equalities == 0) return;
  std::vector<std::vector<Atom>> neighbours;
  const auto note = [&](Atom atom, bool is_head) {
    const Variable at = neighbour_of(atom);
    if (at == centre) return;
    if (neighbours.size() < at) neighbours.resize(at);
    if (atom.first == at) atom.first = 1;
    if (atom.second == at) atom.second = is_head ? 2 : 1;
    if (is_head && atom.first == 1) atom.second = 2;  // so that B(y) in a head is another atom than B(y) in a body
    neighbours[at - 1].push_back(atom);
  };
  for (const Atom& atom : clause.body) note(atom, false);
  for (const Atom& atom : clause.head) {
    if (!is_equality(atom)) {
      note(atom, true);
    } else if (atom.first == centre || atom.second == centre) {
      is_plain_ = false;
    }
  }
  const std::size_t count = neighbours.size();
  if (count < 2 || equalities != count * (count - 1) / 2) is_plain_ = false;
  for (std::vector<Atom>& one : neighbours) std::ranges::sort(one);
  if (!std::ranges::all_of(neighbours, [&](const auto& one) { return one == neighbours.front(); })) is_plain_ = false;
  if (!is_plain_) return;
  for (const Atom& atom : clause.body) {
    if (neighbour_of(atom) != 1 || !is_edge(atom)) continue;
    if (const auto direction = direction_of(atom)) {
      return note_family({*direction, neighbours.front()}, static_cast<std::uint32_t>(count - 1));
    }
  }
  is_plain_ = false;
}

void CountedNeighbours::note_family(Family family, std::uint32_t count) {
  std::uint32_t& most = families_[std::move(family)];
  most = std::max(most, count);
}

void CountedNeighbours::sum_up() {
  sums_.assign(above_.size(), 0);
  for (const auto& [family, count] : families_) {
    sums_[family.first] += count;
    if (family.first < first_data_) sum_of_roles_ += count;
  }
}

std::vector<CountedNeighbours::Direction> CountedNeighbours::reached(Direction start) const {
  std::vector<Direction> found = {start};
  std::vector<bool> is_found(above_.size(), false);
  is_found[start] = true;
  for (std::size_t at = 0; at < found.size(); ++at) {
    for (const Direction next : above_[found[at]]) {
      if (!is_found[next]) found.push_back(next);
      is_found[next] = true;
    }
  }
  return found;
}

std::uint64_t CountedNeighbours::counted_in(Direction start) const {
  std::uint64_t sum = 0;
  for (const Direction direction : reached(start)) sum += sums_[direction];
  return sum;
}

void CountedNeighbours::count_asked(const ClauseSet& set) {
  has_links_ = !set.role_facts.empty() || !set.data_facts.empty();
  asked_.assign(above_.size(), 0);
  const auto ask = [this](Direction start, std::uint32_t count) {
    for (const Direction direction : reached(start)) asked_[direction] += count;
  };
  std::uint64_t anywhere = 0;  // see enough()
  for (const AtLeast& one : set.at_leasts) {
    const Direction direction = direction_of(one.role);
    if (counted_in(direction ^ 1U) > 0) {
      anywhere += one.count;
    } else {
      ask(direction, one.count);
    }
  }
  for (const DataAtLeast& one : set.data_at_leasts) ask(direction_of(one.property), one.count);
  for (Direction direction = 0; direction < first_data_; ++direction) asked_[direction] += anywhere;
}

// Two more neighbours are the node itself and the node that it was made for.
bool CountedNeighbours::may_exceed(const AtMost& at_most) const {
  return !is_plain_ || has_links_ || asked_[direction_of(at_most.role)] + 2 > at_most.count;
}

bool CountedNeighbours::may_exceed(const DataAtMost& at_most) const {
  return !is_plain_ || has_links_ || asked_[direction_of(at_most.property)] > at_most.count;
}

std::uint32_t CountedNeighbours::enough(std::uint32_t count, std::uint64_t counted) const {
  return is_plain_ ? static_cast<std::uint32_t>(std::min<std::uint64_t>(count, counted + 1)) : count;
}

std::uint32_t CountedNeighbours::enough(const AtLeast& at_least) const {
  if (at_least.count < 2) return at_least.count;
  const Direction direction = direction_of(at_least.role);
  // If an at-most of the neighbour counts the node itself, the edge between them may get further roles.
  const bool is_counted_back = counted_in(direction ^ 1U) > 0;
  return enough(at_least.count, is_counted_back ? sum_of_roles_ : counted_in(direction));
}

std::uint32_t CountedNeighbours::enough(const DataAtLeast& at_least) const {
  if (at_least.count < 2) return at_least.count;
  return enough(at_least.count, counted_in(direction_of(at_least.property)));
}

}  // namespace geminga::clauses
