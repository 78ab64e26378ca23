// The legend is in closure/saturation.hpp.
#include "reasoning/el/model/inverse_conclusions.hpp"

#include <algorithm>

#include "base/sorted.hpp"

namespace geminga::el {

SuccessorContexts::SuccessorContexts(const IndexedOntology& index, const Saturation& saturation,
                                     const InverseRoles& roles, const SuccessorLimits& limits)
    : index_(index), saturation_(saturation), roles_(roles), limits_(limits), use_(limits.budget) {}

bool SuccessorContexts::spend(std::size_t steps) {
  if (!use_.spend(steps)) is_cut_off_ = true;
  return !is_cut_off_;
}

/// By context: its links whose ends learn something.
std::vector<std::vector<Link>> SuccessorContexts::links_that_teach() {
  const ContextStore& contexts = saturation_.contexts();
  std::vector<std::vector<Link>> links(contexts.size());
  for (std::uint32_t to = 0; to < contexts.size(); ++to) {
    if (contexts[to].is_unsatisfiable) continue;
    if (!spend(contexts[to].backward.size())) break;
    for (const Link link : contexts[to].backward.items()) {
      if (roles_.tells_end(link.role) && !contexts[link.context].is_unsatisfiable)
        links[link.context].push_back({link.role, to});
    }
  }
  return links;
}

//  C -R-> D   [successors of C in D are in E, because of what they learn of C; R <* S]
//  ---------------------------------------------------------------------------------- [S some E occurs negatively]
//  C < S some E
InverseConclusions SuccessorContexts::conclude() {
  InverseConclusions result;
  const auto links = links_that_teach();
  for (std::uint32_t at = 0; at < links.size() && !is_cut_off_; ++at) {
    const Context& context = saturation_.contexts()[at];
    const auto note = [&](ExprId expr) {
      if (!is_in(at, expr)) result.emplace_back(at, expr);
    };
    const std::span fillers(context.propagating.begin(), context.propagating.end());
    if (!spend(1 + links[at].size() * (fillers.size() + context.subsumers.size()))) break;
    for (const Link link : links[at]) {
      const std::span<const Learning> learnings = roles_.learning(link.role);
      visit_taught(index_, learnings, fillers, context.subsumers.items(), [&](ExprId learned) {
        for (const ExprId expr : find_grown(link.context, learned)) {
          const Expr& known = index_.expr(expr);
          for (const Learning& learning : learnings) {
            const auto heard =
                std::ranges::equal_range(index_.existentials(expr), learning.role, {}, &ExistentialRule::role);
            for (const ExistentialRule& rule : heard) {
              if (learning.recognises) note(rule.existential);
            }
            const bool goes_on =
                known.kind == ExprKind::existential && known.first == static_cast<std::uint32_t>(learning.role);
            if (learning.carries && goes_on) note(expr);
          }
        }
      });
    }
  }
  base::sort_unique(result);
  return result;
}

/// The expressions that a successor in the context is in beyond the context, if it learns this one.
std::span<const ExprId> SuccessorContexts::find_grown(std::uint32_t context, ExprId learned) {
  if (is_in(context, learned)) return {};
  const std::uint64_t hash = base::mixed(base::mixed(0, context), number(learned));
  const std::uint32_t known = table_.find(
      hash, [&](std::uint32_t at) { return successors_[at].context == context && successors_[at].learned == learned; });
  if (known != base::NumberTable::none) return grown(successors_[known]);
  if (successors_.size() >= limits_.contexts) return {};
  const auto begin = static_cast<std::uint32_t>(grown_.size());
  table_.insert(hash, static_cast<std::uint32_t>(successors_.size()));
  grow(successors_.emplace_back(context, learned, begin, begin));
  return grown(successors_.back());
}

void SuccessorContexts::grow(Successor& successor) {
  add(successor, successor.learned);
  for (std::uint32_t at = 0; at < grown(successor).size(); ++at) {
    const ExprId expr = grown(successor)[at];
    const auto above = index_.is_atom(expr) ? index_.frontier(expr) : index_.told_atoms(expr);
    for (const ExprId atom : above) {
      if (index_.is_active(atom)) {
        add(successor, atom);
      } else {
        for (const ExprId active : index_.frontier(atom)) add(successor, active);
      }
    }
    add_conjunctions(successor, expr);
  }
}

void SuccessorContexts::add(Successor& successor, ExprId expr) {
  const auto known = grown(successor);
  if (known.size() >= limits_.grown || is_in(successor.context, expr)) return;
  if (std::ranges::find(known, expr) != known.end()) return;
  grown_.push_back(expr);
  ++successor.end;
}

//  D < E   D < E'
//  -------------- [E and E' occurs negatively]; the first premise is new
//  D < E and E'
void SuccessorContexts::add_conjunctions(Successor& successor, ExprId expr) {
  const auto rules = index_.conjunctions(expr);
  const auto apply = [&](ExprId partner) {
    for (const ConjunctionRule& rule : std::ranges::equal_range(rules, partner, {}, &ConjunctionRule::partner)) {
      add(successor, rule.conjunction);
    }
  };
  for (std::uint32_t at = 0; at < grown(successor).size(); ++at) apply(grown(successor)[at]);
  const Context& context = saturation_.contexts()[successor.context];
  if (rules.size() <= context.subsumers.size()) {
    for (const ConjunctionRule& rule : rules) {
      if (is_in(successor.context, rule.partner)) add(successor, rule.conjunction);
    }
  } else {
    for (const std::uint32_t partner : context.subsumers.items()) apply(ExprId{partner});
  }
}

}  // namespace geminga::el
