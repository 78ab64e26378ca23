// What is in a union and in none of its parts, and which of them it may be.
#include <algorithm>

#include "reasoning/el/model/model_check.hpp"

namespace geminga::el {
namespace {

constexpr unsigned max_depth = 500;                      // unions within unions
constexpr std::size_t max_steps = std::size_t{1} << 27;  // subsumers looked at

}  // namespace

/// Whether a part has all that the element has, so that the element may be one of the part.
bool ModelCheck::may_be(std::uint32_t context, std::uint32_t part) {
  const Context& element = saturation_.contexts()[context];
  const Context& other = saturation_.contexts()[part];
  if (other.is_unsatisfiable || is_failing_[part]) return false;
  steps_ += element.subsumers.size();
  for (std::uint32_t at = 0; at < element.subsumers.size(); ++at) {
    const std::uint32_t subsumer = element.subsumers[at];
    if (subsumer < index_.size() && !is_plain_[subsumer] && !other.subsumers.contains(subsumer)) return false;
  }
  return true;
}

/// Calls with each part that the element may be, until one call returns true, and whether it did.
template <typename Visit>
bool ModelCheck::visit_parts(std::uint32_t context, Visit&& visit) {
  return std::ranges::any_of(parts_of_[union_of_[context]], [&](std::uint32_t part) {
    if (steps_ > max_steps || saturation_.find(ExprId{part}) == nullptr) return false;
    const std::uint32_t at = saturation_.number_of(ExprId{part});
    return may_be(context, at) && visit(at);
  });
}

void ModelCheck::index_unions() {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> wholes;
  for (const OpenUnion& open : open_.unions) {
    wholes.emplace_back(number(index_.representative(open.whole)), static_cast<std::uint32_t>(parts_of_.size()));
    std::vector<std::uint32_t> parts;
    for (const ExprId part : open.parts) parts.push_back(number(index_.representative(part)));
    std::ranges::sort(parts);
    parts_of_.push_back(std::move(parts));
  }
  unions_of_ = base::Rows<std::uint32_t>(index_.size(), wholes);
  is_plain_.resize(index_.size());
  for (std::uint32_t id = 0; id < index_.size(); ++id) {
    const std::uint8_t others = index_.rule_bits(ExprId{id}) & ~static_cast<std::uint8_t>(RuleBits::above);
    is_plain_[id] = index_.is_atom(ExprId{id}) && !index_.is_nominal(ExprId{id}) && others == 0 &&
                    index_.universals(ExprId{id}).empty() && unions_of_[id].empty();
  }
  for (const auto* counts : {&open_.at_most, &open_.at_least}) {
    for (const OpenCount& count : *counts) is_plain_[number(index_.representative(count.whole))] = false;
  }
}

//  x in X   [X < C or D]
void ModelCheck::find_union(std::uint32_t context) {
  const auto& subsumers = saturation_.contexts()[context].subsumers;
  for (std::uint32_t at = 0; at < subsumers.size() && union_of_[context] == none; ++at) {
    for (const std::uint32_t which : unions_of_[subsumers[at]]) {
      const std::vector<std::uint32_t>& parts = parts_of_[which];
      const auto is_part = [&](std::uint32_t subsumer) { return std::ranges::binary_search(parts, subsumer); };
      if (!std::ranges::any_of(subsumers.items(), is_part)) union_of_[context] = which;
    }
  }
}

/// Whether a link may lead to some part instead, so that its source learns nothing new.
bool ModelCheck::can_lead_to_a_part(Link from, std::uint32_t context, unsigned depth) {
  if (depth > max_depth || steps_ > max_steps) return false;
  const bool is_heard = is_heard_[static_cast<std::size_t>(from.role)];
  return visit_parts(context, [&](std::uint32_t part) {
    if (union_of_[part] != none) return can_lead_to_a_part(from, part, depth + 1);
    if (is_heard && !is_link_satisfied(from.context, from.role, part, false)) return false;
    return is_implied_satisfied(from.context, from.role, part) && knows_what_it_learns(from.context, from.role, part);
  });
}

// A part that fails later is no part to lead to, so all links are tested again until nothing else fails.
void ModelCheck::test_links_to_unions() {
  std::size_t failing = 0;
  const auto count = [&] { return static_cast<std::size_t>(std::ranges::count(is_failing_, true)); };
  do {
    follow();
    spread_to_successors();
    failing = count();
    for (std::uint32_t at = 0; at < union_of_.size(); ++at) {
      if (union_of_[at] == none || is_failing_[at]) continue;
      for (const Link link : saturation_.contexts()[at].backward.items()) {
        if (is_failing_[link.context] || saturation_.contexts()[link.context].is_unsatisfiable) continue;
        if (!can_lead_to_a_part(link, at, 0)) fail(link.context);
      }
    }
  } while (count() != failing);
}

bool ModelCheck::is_root_settled(std::uint32_t context, unsigned depth) {
  if (is_failing_[context]) return false;
  if (union_of_[context] == none) return true;
  if (roots_[context] == Root::unknown) {
    roots_[context] = Root::busy;
    roots_[context] = has_nothing_more(context, depth) ? Root::settled : Root::open;
  }
  return roots_[context] == Root::settled;
}

/// Whether what is above all parts that the element may be is above the element.
bool ModelCheck::has_nothing_more(std::uint32_t context, unsigned depth) {
  if (depth > max_depth) return false;
  std::vector<ExprId> common;
  bool is_first = true;
  return visit_parts(context, [&](std::uint32_t part) {
    if (!is_root_settled(part, depth + 1)) return false;
    const auto found = above_.of(saturation_.contexts()[part].root);
    steps_ += found.size();
    if (is_first) {
      for (const ExprId atom : found) {
        if (is_class_[number(atom)]) common.push_back(atom);
      }
      (void)above_.of(saturation_.contexts()[context].root);
      std::erase_if(common, [&](ExprId atom) { return above_.contains(atom); });
      is_first = false;
    } else {
      std::erase_if(common, [&](ExprId atom) { return !above_.contains(atom); });
    }
    return common.empty();
  });
}

}  // namespace geminga::el
