// Ends of links are narrowed while the closure rests, all that are found at once.
#include "reasoning/el/closure/ranges.hpp"

#include <algorithm>
#include <utility>

namespace geminga::el {

RangeTest::RangeTest(SharedNodes& shared, InheritanceWorker& worker, std::span<const OpenRange> ranges)
    : shared_(shared),
      nodes_(shared.contexts),
      worker_(worker),
      index_(shared.index),
      ranges_of_(shared.index.roles().count()),
      is_reached_(shared.contexts.size(), false) {
  for (std::uint32_t role = 0; role < ranges_of_.size(); ++role) {
    for (const OpenRange& open : ranges) {
      if (index_.roles().is_sub_role(RoleId{role}, open.role))
        ranges_of_[role].push_back(index_.representative(open.range));
    }
  }
}

bool RangeTest::passes() {
  reach(shared_.find(index_.representative(top_expr)));
  for (const ExprId seed : shared_.seeds) reach(shared_.find(seed));
  find_links();
  while (narrow_ends()) {
    worker_.run_alone();
    news_.clear();
    if (shared_.has_ended() || !take_news()) return false;
    find_links();
  }
  return is_news_harmless();
}

void RangeTest::reach(std::uint32_t node) {
  if (node == no_node || is_reached_[node] || nodes_[node].is_unsatisfiable) return;
  is_reached_[node] = true;
  reached_.push_back(node);
}

/// Finds the links of all elements, which the seeds and the ends of links are. Nodes that nothing satisfiable leads to
/// are there or not depending on the order of the work, and do not count.
void RangeTest::find_links() {
  is_reached_.resize(nodes_.size(), false);
  const auto size = static_cast<std::uint32_t>(index_.size());
  const auto reach_atom = [&](ExprId atom) {
    if (!index_.needs_no_context(atom)) return reach(shared_.find(atom));
    for (const ExprId only : index_.frontier(atom)) reach(shared_.find(only));
  };
  while (!reached_.empty()) {
    const std::uint32_t at = reached_.back();
    reached_.pop_back();
    is_reached_[at] = true;
    const Node& node = nodes_[at];
    if (node.is_existential()) {
      ends_[node.filler].links.push_back(at);
      reach(node.filler);
    } else if (node.root != no_node) {
      for (const ExprId above : index_.frontier(ExprId{node.root})) reach(shared_.find(above));
    }
    for (const std::uint32_t above : node.above) {
      if (above < size) {
        reach_atom(ExprId{above});
      } else {
        reach(above - size);
      }
    }
  }
}

/// False if all links end in their ranges.
bool RangeTest::narrow_ends() {
  bool is_any_narrowed = false;
  for (auto& [at, end] : ends_) {
    if (end.links_narrowed == end.links.size()) continue;
    const std::vector<ExprId> missing = missing_ranges(at, end);
    if (end.narrowed == no_node && missing.empty()) {
      end.links_narrowed = end.links.size();
      continue;
    }
    is_any_narrowed = true;
    narrow(at, end, missing);
  }
  return is_any_narrowed;
}

std::vector<ExprId> RangeTest::missing_ranges(std::uint32_t at, const End& end) {
  std::vector<ExprId> missing;
  for (std::size_t link = end.links_narrowed; link < end.links.size(); ++link) {
    for (const ExprId range : ranges_of_[nodes_[end.links[link]].root]) {
      const auto is_range = [&](ExprId other) { return other == range; };
      if (std::ranges::none_of(missing, is_range) && std::ranges::none_of(end.ranges, is_range))
        missing.push_back(range);
    }
  }
  if (missing.empty()) return missing;
  find_above(at);
  std::erase_if(missing, [&](ExprId range) { return seen_for_[number(range)] == search_; });
  return missing;
}

/// Marks all that is above a node of an atom as seen by this search.
void RangeTest::find_above(std::uint32_t node) {
  const auto size = static_cast<std::uint32_t>(index_.size());
  seen_for_.resize(size + nodes_.size(), 0);
  ++search_;
  std::vector<std::uint32_t> open;
  const auto reach = [&](std::uint32_t above) {
    if (seen_for_[above] == search_) return;
    seen_for_[above] = search_;
    open.push_back(above);
  };
  reach(nodes_[node].root);
  reach(number(index_.representative(top_expr)));
  while (!open.empty()) {
    const std::uint32_t from = open.back();
    open.pop_back();
    std::uint32_t of = from - size;
    if (from < size) {
      for (const ExprId above : index_.told_atoms(ExprId{from})) reach(number(above));
      of = shared_.find(ExprId{from});
    }
    if (of == no_node) continue;
    for (const std::uint32_t above : nodes_[of].above) reach(above);
  }
}

void RangeTest::narrow(std::uint32_t at, End& end, std::span<const ExprId> missing) {
  if (end.narrowed == no_node) {
    end.narrowed = worker_.add_below(at);
    end.links_narrowed = 0;
  }
  if (!missing.empty()) reached_.push_back(end.narrowed);
  for (const ExprId range : missing) {
    worker_.put_below(end.narrowed, range);
    end.ranges.push_back(range);
    end.links_narrowed = 0;  // the links that the node has told already must hear more
  }
  for (; end.links_narrowed < end.links.size(); ++end.links_narrowed) {
    const std::uint32_t link = end.links[end.links_narrowed];
    known_.push_back({link, nodes_[link].items.size(), nodes_[link].above.size()});
    worker_.lead_to(link, end.narrowed);
  }
}

/// Collects the new items of the links that were narrowed. False if one of them has news that may not be harmless.
bool RangeTest::take_news() {
  for (const Known& known : known_) {
    const Node& node = nodes_[known.link];
    if (node.is_unsatisfiable) return false;
    const auto before = std::span(node.above.data(), known.above);
    const auto later = std::span(node.above.data(), node.above.size()).subspan(known.above);
    const auto is_new = [&](std::uint32_t above) { return std::ranges::find(before, above) == before.end(); };
    if (std::ranges::any_of(later, is_new)) return false;
    for (const std::uint32_t item : node.items.items().subspan(known.items)) {
      constexpr auto conjunctions = static_cast<std::uint8_t>(RuleBits::conjunctions);
      if (item >= index_.size() || index_.is_atom(ExprId{item})) return false;
      if ((index_.rule_bits(ExprId{item}) & ~conjunctions) != 0) return false;
      news_[item].push_back(known.link);
    }
  }
  return true;
}

std::uint32_t RangeTest::vertex_of(std::uint32_t node) const {
  const bool is_of_atom = !nodes_[node].is_existential() && nodes_[node].root != no_node;
  return is_of_atom ? nodes_[node].root : static_cast<std::uint32_t>(index_.size()) + node;
}

/// Finds all that is right below each expression, and below each node behind the expressions. Unsatisfiable nodes have
/// nothing above them.
base::Rows<std::uint32_t> RangeTest::find_below() const {
  const auto size = static_cast<std::uint32_t>(index_.size());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  // above, below
  for (std::uint32_t id = 0; id < size; ++id) {
    for (const ExprId above : index_.told_atoms(ExprId{id})) pairs.emplace_back(number(above), id);
  }
  for (std::uint32_t at = 0; at < nodes_.size(); ++at) {
    for (const std::uint32_t above : nodes_[at].above) pairs.emplace_back(above, vertex_of(at));
  }
  return {size + nodes_.size(), pairs};
}

//  X is new at `R some N`, and only conjunctions of X with atoms have rules: nothing below both `R some N` and such an
//  atom shows that no rule fires
bool RangeTest::is_news_harmless() const {
  constexpr std::size_t max_partners = 64;  // each is looked for in the whole closure; rules are used where X has more
  if (news_.empty()) return true;
  const base::Rows<std::uint32_t> below = find_below();
  const auto all_below = [&](std::vector<std::uint32_t> open) {
    std::vector<bool> is_below(below.row_count(), false);
    for (const std::uint32_t first : open) is_below[first] = true;
    while (!open.empty()) {
      const std::uint32_t from = open.back();
      open.pop_back();
      for (const std::uint32_t next : below[from]) {
        if (!is_below[next]) open.push_back(next);
        is_below[next] = true;
      }
    }
    // Nothing is noted to be below owl:Thing.
    if (is_below[number(index_.representative(top_expr))]) is_below.assign(below.row_count(), true);
    return is_below;
  };
  for (const auto& [item, links] : news_) {
    std::vector<std::uint32_t> heard;
    for (const std::uint32_t link : links) heard.push_back(vertex_of(link));
    const std::vector<bool> hears = all_below(heard);
    const std::span<const ConjunctionRule> rules = index_.conjunctions(ExprId{item});
    if (rules.size() > max_partners) return false;
    for (const ConjunctionRule& rule : rules) {
      if (!index_.is_atom(rule.partner)) return false;
      const std::vector<bool> has_partner = all_below({number(rule.partner)});
      for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
        const std::uint32_t vertex = vertex_of(node);
        if (is_reached_[node] && hears[vertex] && has_partner[vertex]) return false;
      }
    }
  }
  return true;
}

}  // namespace geminga::el
