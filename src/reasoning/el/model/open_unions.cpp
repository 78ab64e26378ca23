// The parts of a union are tried one by one, within limits of depth and steps.
#include "reasoning/el/model/open_unions.hpp"

#include <algorithm>
#include <utility>

namespace geminga::el {
namespace {

constexpr unsigned max_depth = 500;                      // unions within unions
constexpr std::size_t max_steps = std::size_t{1} << 27;  // subsumers looked at

}  // namespace

OpenUnions::OpenUnions(const IndexedOntology& index, const Saturation& saturation, const OpenParts& open,
                       std::span<const ExprId> classes)
    : index_(index),
      saturation_(saturation),
      union_of_(saturation.contexts().size(), none),
      answers_(saturation.contexts().size(), Answer::unknown),
      is_class_(index.size(), false),
      above_(index, saturation) {
  for (const ExprId named : classes) is_class_[number(named)] = true;
  index_unions(open);
  find_plain(open);
  for (std::uint32_t at = 0; at < union_of_.size(); ++at) {
    if (!saturation.contexts()[at].is_unsatisfiable) union_of_[at] = find_union(at);
  }
}

void OpenUnions::index_unions(const OpenParts& open) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> wholes;
  for (const OpenUnion& one : open.unions) {
    wholes.emplace_back(number(index_.representative(one.whole)), static_cast<std::uint32_t>(parts_of_.size()));
    std::vector<std::uint32_t> parts;
    for (const ExprId part : one.parts) parts.push_back(number(index_.representative(part)));
    std::ranges::sort(parts);
    parts_of_.push_back(std::move(parts));
  }
  unions_of_ = base::Rows<std::uint32_t>(index_.size(), wholes);
}

void OpenUnions::find_plain(const OpenParts& open) {
  is_plain_.resize(index_.size());
  for (std::uint32_t id = 0; id < index_.size(); ++id) {
    const ExprId expr{id};
    const std::uint8_t others = index_.rule_bits(expr) & ~static_cast<std::uint8_t>(RuleBits::above);
    is_plain_[id] = index_.is_atom(expr) && !index_.is_nominal(expr) && others == 0 &&
                    index_.universals(expr).empty() && !is_whole(expr);
  }
  for (const auto* counts : {&open.at_most, &open.at_least}) {
    for (const OpenCount& count : *counts) is_plain_[number(index_.representative(count.whole))] = false;
  }
}

//  x in X   [X < C or D]
std::uint32_t OpenUnions::find_union(std::uint32_t context) const {
  const auto& subsumers = saturation_.contexts()[context].subsumers;
  for (const std::uint32_t subsumer : subsumers.items()) {
    for (const std::uint32_t which : unions_of_[subsumer]) {
      const std::vector<std::uint32_t>& parts = parts_of_[which];
      const auto is_part = [&](std::uint32_t one) { return std::ranges::binary_search(parts, one); };
      if (!std::ranges::any_of(subsumers.items(), is_part)) return which;
    }
  }
  return none;
}

/// Whether a part is below all subsumers of the element from which something follows.
bool OpenUnions::may_be(const FailingContexts& failing, std::uint32_t context, std::uint32_t part) {
  const Context& element = saturation_.contexts()[context];
  const Context& other = saturation_.contexts()[part];
  if (other.is_unsatisfiable || failing.has(part)) return false;
  steps_ += element.subsumers.size();
  return std::ranges::all_of(element.subsumers.items(), [&](std::uint32_t subsumer) {
    return subsumer >= index_.size() || is_plain_[subsumer] || other.subsumers.contains(subsumer);
  });
}

/// Calls `visit` with each part that the model may choose, until one call returns true. True if one did.
template <typename Visit>
bool OpenUnions::visit_parts(const FailingContexts& failing, std::uint32_t context, Visit&& visit) {
  return std::ranges::any_of(parts_of_[union_of_[context]], [&](std::uint32_t part) {
    if (steps_ > max_steps || saturation_.find(ExprId{part}) == nullptr) return false;
    const std::uint32_t at = saturation_.number_of(ExprId{part});
    return may_be(failing, context, at) && visit(at);
  });
}

bool OpenUnions::can_lead_to_a_part(ElementTest& test, const HeardRoles& heard, const FailingContexts& failing,
                                    Link from, std::uint32_t context, unsigned depth) {
  if (depth > max_depth || steps_ > max_steps) return false;
  return visit_parts(failing, context, [&](std::uint32_t part) {
    if (is_open(part)) return can_lead_to_a_part(test, heard, failing, from, part, depth + 1);
    if (heard.is_heard(from.role) && !test.is_link_satisfied(from.context, from.role, part, false)) return false;
    return test.is_implied_satisfied(from.context, from.role, part);
  });
}

bool OpenUnions::is_settled(const FailingContexts& failing, std::uint32_t context, unsigned depth) {
  if (failing.has(context)) return false;
  if (!is_open(context)) return true;
  if (answers_[context] == Answer::unknown) {
    answers_[context] = Answer::busy;
    answers_[context] = has_nothing_more(failing, context, depth) ? Answer::settled : Answer::open;
  }
  return answers_[context] == Answer::settled;
}

/// Whether every class above all parts that the model may choose is above the context.
bool OpenUnions::has_nothing_more(const FailingContexts& failing, std::uint32_t context, unsigned depth) {
  if (depth > max_depth) return false;
  std::vector<ExprId> common;
  bool is_first = true;
  return visit_parts(failing, context, [&](std::uint32_t part) {
    if (!is_settled(failing, part, depth + 1)) return false;
    const auto found = above_.gather(saturation_.contexts()[part].root);
    steps_ += found.size();
    if (is_first) {
      for (const ExprId atom : found) {
        if (is_class_[number(atom)]) common.push_back(atom);
      }
      (void)above_.gather(saturation_.contexts()[context].root);
      std::erase_if(common, [&](ExprId atom) { return above_.contains(atom); });
      is_first = false;
    } else {
      std::erase_if(common, [&](ExprId atom) { return !above_.contains(atom); });
    }
    return common.empty();
  });
}

}  // namespace geminga::el
