// Growing, meeting, and what comes back to the source.
#include "reasoning/el/model/successor_contexts.hpp"

#include <algorithm>
#include <map>

#include "base/sorted.hpp"

namespace geminga::el {
SuccessorContexts::SuccessorContexts(const IndexedOntology& index, const Saturation& saturation,
                                     const InverseRoles& roles, Growing growing, const SuccessorLimits& limits)
    : index_(index),
      saturation_(saturation),
      roles_(roles),
      growing_(std::move(growing)),
      limits_(limits),
      use_(limits.budget) {
  index_links();
  learn_of_contexts();
  teach_all();
  if (is_over_limit_) return;
  meet();
  if (!is_over_limit_) look_back();
}

void SuccessorContexts::spend(std::size_t steps) {
  if (!use_.spend(steps)) is_over_limit_ = is_cut_off_ = true;
}

void SuccessorContexts::teach_all() {
  std::uint32_t taught = 0;
  std::size_t known = 0;
  do {
    for (; taught < copies_.size() && !is_over_limit_; ++taught) teach_successors(taught);
    known = copies_.size();
    if (!is_over_limit_) teach_new_successors();
  } while (known != copies_.size() && !is_over_limit_);
}

void SuccessorContexts::index_links() {
  const ContextStore& contexts = saturation_.contexts();
  std::vector<std::pair<std::uint32_t, Link>> links;
  for (std::uint32_t to = 0; to < contexts.size(); ++to) {
    if (contexts[to].is_unsatisfiable) continue;
    spend(contexts[to].backward.size());
    if (is_over_limit_) break;
    for (const Link link : contexts[to].backward.items()) {
      if (roles_.tells_end(link.role) && !contexts[link.context].is_unsatisfiable)
        links.emplace_back(link.context, Link{link.role, to});
    }
  }
  forward_ = base::Rows<Link>(contexts.size(), links);
}

void SuccessorContexts::learn_of_contexts() {
  const ContextStore& contexts = saturation_.contexts();
  for (std::uint32_t at = 0; at < contexts.size() && !is_over_limit_; ++at) {
    const Context& context = contexts[at];
    const std::span fillers(context.propagating.begin(), context.propagating.end());
    spend(1 + forward_[at].size() * (fillers.size() + context.subsumers.size()));
    for (const Link link : forward_[at]) {
      visit_taught(index_, roles_.learning(link.role), fillers, context.subsumers.items(),
                   [&](ExprId learned) { (void)learn(link.context, learned); });
    }
  }
}

std::uint32_t SuccessorContexts::find(std::uint32_t context, ExprId learned) const {
  return table_.find(base::mixed(base::mixed(0, context), number(learned)), [&](std::uint32_t at) {
    return copies_[at].context == context && copies_[at].learned == learned;
  });
}

/// The copy that has learned this; none where its context is in it anyway.
std::uint32_t SuccessorContexts::learn(std::uint32_t context, ExprId learned) {
  if (is_in(context, learned)) return none;
  const std::uint32_t known = find(context, learned);
  if (known != none) return known;
  if (copies_.size() >= limits_.contexts) {
    is_over_limit_ = true;
    return none;
  }
  const auto created = static_cast<std::uint32_t>(copies_.size());
  table_.insert(base::mixed(base::mixed(0, context), number(learned)), created);
  const Growth growth = growing_.growth(context, learned);
  copies_.push_back({context, learned, static_cast<std::uint32_t>(grown_.size()),
                     static_cast<std::uint32_t>(grown_.size()), growth == Growth::forbidden});
  if (growth == Growth::free) grow(created);
  return created;
}

bool SuccessorContexts::has_grown(std::uint32_t copy, ExprId expr) const {
  const auto all = grown(copy);
  return std::ranges::find(all, expr) != all.end();
}

void SuccessorContexts::add(std::uint32_t copy, ExprId expr) {
  if (is_in(copies_[copy].context, expr) || has_grown(copy, expr)) return;
  if (!growing_.may_grow[number(expr)] || copies_[copy].end - copies_[copy].begin >= limits_.grown) {
    copies_[copy].is_open = true;
    return;
  }
  grown_.push_back(expr);
  ++copies_[copy].end;
}

void SuccessorContexts::add_above(std::uint32_t copy, ExprId expr) {
  if (index_.is_active(expr)) return add(copy, expr);
  for (const ExprId above : index_.frontier(expr)) add(copy, above);
}

void SuccessorContexts::grow(std::uint32_t copy) {
  add(copy, copies_[copy].learned);
  for (std::uint32_t at = 0; at < grown(copy).size() && !copies_[copy].is_open; ++at) {
    const ExprId expr = grown(copy)[at];
    if (index_.is_told_bottom(expr)) copies_[copy].is_open = true;
    if (index_.is_atom(expr)) {
      for (const ExprId above : index_.frontier(expr)) add(copy, above);
    } else {
      for (const ExprId above : index_.told_atoms(expr)) add_above(copy, above);
    }
    add_conjunctions(copy, expr);
    for (const LinkRule& link : index_.links(expr)) add_link(copy, link);
  }
}

void SuccessorContexts::add_link(std::uint32_t copy, const LinkRule& rule) {
  const ContextStore& contexts = saturation_.contexts();
  const std::uint32_t from = copies_[copy].context;
  if (saturation_.find(rule.root) == nullptr) {
    copies_[copy].is_open = true;
    return;
  }
  const std::uint32_t to = saturation_.number_of(rule.root);
  if (contexts[to].backward.contains({rule.role, from})) return;
  if (contexts[to].is_unsatisfiable || !growing_.may_lead_to(from, rule.role, to)) {
    copies_[copy].is_open = true;
    return;
  }
  copies_[copy].has_links = true;
  new_links_.push_back({copy, {rule.role, to}});
  // With what chains make of it and of the links of the successor, which are closed.
  std::vector<Link> links = {{rule.role, to}};
  for (std::size_t at = 0; at < links.size() && !copies_[copy].is_open; ++at) {
    const Link link = links[at];
    recognise(copy, link);
    if (index_.roles().compositions(link.role).empty()) continue;
    for (const Link next : contexts[link.context].forward) {
      for (const RoleId result : index_.roles().composed(link.role, next.role)) {
        const Link composed{result, next.context};
        if (std::ranges::find(links, composed) == links.end()) links.push_back(composed);
      }
      if (links.size() > limits_.grown) copies_[copy].is_open = true;
    }
  }
}

//  C -R-> D   D < E
//  ---------------- [S some E occurs negatively, R <* S]; here the first premise is new
//  C < S some E
void SuccessorContexts::recognise(std::uint32_t copy, Link link) {
  const Context& successor = saturation_.contexts()[link.context];
  for (const ExprId filler : successor.propagating) {
    for (const ExistentialRule& rule : index_.existentials(filler)) {
      if (index_.roles().is_sub_role(link.role, rule.role)) add(copy, rule.existential);
    }
  }
  for (const Learning& learning : roles_.learning(link.role)) {
    if (learning.is_partial) parts_.emplace_back(copy, learning.role);
  }
}

void SuccessorContexts::add_conjunctions(std::uint32_t copy, ExprId expr) {
  const auto rules = index_.conjunctions(expr);
  const Context& context = saturation_.contexts()[copies_[copy].context];
  const auto apply = [&](ExprId partner) {
    for (auto rule = std::ranges::lower_bound(rules, partner, {}, &ConjunctionRule::partner);
         rule != rules.end() && rule->partner == partner; ++rule) {
      add(copy, rule->conjunction);
    }
  };
  for (std::uint32_t at = 0; at < grown(copy).size(); ++at) apply(grown(copy)[at]);
  if (rules.size() <= context.subsumers.size()) {
    for (const ConjunctionRule& rule : rules) {
      if (context.subsumers.contains(number(rule.partner))) add(copy, rule.conjunction);
    }
  } else {
    for (const std::uint32_t partner : context.subsumers.items()) apply(ExprId{partner});
  }
}

void SuccessorContexts::teach_successors(std::uint32_t copy) {
  const auto all = grown(copy);
  const std::vector<ExprId> fillers(all.begin(), all.end());
  std::vector<std::uint32_t> known;
  for (const ExprId expr : fillers) known.push_back(number(expr));
  for (const Link link : forward_[copies_[copy].context]) {
    spend(1 + fillers.size());
    visit_taught(index_, roles_.learning(link.role), fillers, known, [&](ExprId learned) {
      const std::uint32_t taught = learn(link.context, learned);
      if (taught != none) lessons_.push_back({copy, link.role, taught});
    });
    if (lessons_.size() > limits_.lessons) is_over_limit_ = true;
    if (is_over_limit_) return;
  }
}

/// What one copy of a context learns is taught to the new successors of another, too: a copy may be both.
void SuccessorContexts::teach_new_successors() {
  std::map<std::uint32_t, std::vector<std::uint32_t>> grown_at;
  for (const NewLink& one : new_links_) grown_at.try_emplace(copies_[one.copy].context);
  for (std::uint32_t at = 0; at < copies_.size(); ++at) {
    const auto found = grown_at.find(copies_[at].context);
    if (found == grown_at.end()) continue;
    for (const ExprId expr : grown(at)) found->second.push_back(number(expr));
  }
  for (auto& [context, exprs] : grown_at) {
    for (const std::uint32_t expr : saturation_.contexts()[context].subsumers.items()) exprs.push_back(expr);
    base::sort_unique(exprs);
  }
  std::vector<ExprId> fillers;
  for (std::size_t at = 0; at < new_links_.size() && !is_over_limit_; ++at) {
    const NewLink one = new_links_[at];
    const auto found = grown_at.find(copies_[one.copy].context);
    if (found == grown_at.end()) continue;  // it has come to be here, and has its turn
    fillers.clear();
    for (const std::uint32_t expr : found->second) {
      if (expr < index_.size()) fillers.push_back(ExprId{expr});
    }
    spend(1 + found->second.size());
    visit_taught(index_, roles_.learning(one.link.role), fillers, found->second, [&](ExprId learned) {
      const std::uint32_t taught = learn(one.link.context, learned);
      if (taught != none) lessons_.push_back({one.copy, one.link.role, taught});
    });
    if (lessons_.size() > limits_.lessons) is_over_limit_ = true;
  }
}

/// What one copy of a context learns may meet what another learns: a copy may learn both.
void SuccessorContexts::meet() {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::uint32_t at = 0; at < copies_.size(); ++at) pairs.emplace_back(copies_[at].context, at);
  const base::Rows<std::uint32_t> copies_of(saturation_.contexts().size(), pairs);
  for (std::size_t context = 0; context < copies_of.row_count() && !is_over_limit_; ++context) {
    if (copies_of[context].size() > 1) meet_at(copies_of[context]);
  }
}

void SuccessorContexts::meet_at(std::span<const std::uint32_t> copies) {
  std::vector<std::uint32_t> met;
  for (const std::uint32_t copy : copies) {
    for (const ExprId expr : grown(copy)) met.push_back(number(expr));
  }
  base::sort_unique(met);
  for (const std::uint32_t copy : copies) {
    spend(grown(copy).size());
    const auto meets = [&](const ConjunctionRule& rule) {
      return std::ranges::binary_search(met, number(rule.partner)) && !has_grown(copy, rule.conjunction) &&
             !is_in(copies_[copy].context, rule.conjunction);
    };
    for (const ExprId expr : grown(copy)) {
      const auto rules = index_.conjunctions(expr);
      bool is_met = false;
      if (rules.size() <= met.size()) {
        is_met = std::ranges::any_of(rules, meets);
      } else {
        is_met = std::ranges::any_of(met, [&](std::uint32_t partner) {
          const auto found = std::ranges::equal_range(rules, ExprId{partner}, {}, &ConjunctionRule::partner);
          return std::ranges::any_of(found, meets);
        });
      }
      if (is_met) copies_[copy].is_open = true;
    }
  }
}

/// Whether all that the source of a link hears of what the copy has grown by is so anyway.
template <typename IsIn>
bool SuccessorContexts::tells_nothing_new(std::uint32_t copy, RoleId link, IsIn&& is_in_source) const {
  const auto parts = std::ranges::equal_range(parts_, copy, {}, &std::pair<std::uint32_t, RoleId>::first);
  return std::ranges::all_of(roles_.learning(link), [&](const Learning& learning) {
    const auto is_of_this = [&](const auto& part) { return part.second == learning.role; };
    if (learning.enters_part && std::ranges::any_of(parts, is_of_this)) return false;
    return std::ranges::all_of(grown(copy), [&](ExprId expr) {
      const auto rules = index_.existentials(expr);
      const auto heard = std::ranges::equal_range(rules, learning.role, {}, &ExistentialRule::role);
      if (learning.is_partial && !heard.empty()) return false;
      const bool is_heard_all = !learning.recognises || std::ranges::all_of(heard, [&](const ExistentialRule& rule) {
        return is_in_source(rule.existential);
      });
      const Expr& known = index_.expr(expr);
      const bool may_go_on =
          known.kind == ExprKind::existential && known.first == static_cast<std::uint32_t>(learning.role);
      if (!may_go_on) return is_heard_all;
      return is_heard_all && !learning.is_partial && (!learning.carries || is_in_source(expr));
    });
  });
}

/// What comes back to copies from those that they have taught.
void SuccessorContexts::look_back() {
  for (const Lesson& lesson : lessons_) {
    const auto is_in_source = [&](ExprId expr) {
      return is_in(copies_[lesson.source].context, expr) || has_grown(lesson.source, expr);
    };
    if (!tells_nothing_new(lesson.copy, lesson.role, is_in_source)) copies_[lesson.source].is_open = true;
  }
}

//  C -R-> D   [copies of D that C leads to are in E, R <* S]
//  -------------------------------------------------------- [S some E occurs negatively]
//  C < S some E
SuccessorContexts::Derived SuccessorContexts::derived() const {
  const ContextStore& contexts = saturation_.contexts();
  Derived result;
  for (std::uint32_t at = 0; at < contexts.size() && !is_over_limit_; ++at) {
    const Context& context = contexts[at];
    const auto note = [&](ExprId expr) {
      if (!is_in(at, expr)) result.emplace_back(at, expr);
    };
    const std::span fillers(context.propagating.begin(), context.propagating.end());
    for (const Link link : forward_[at]) {
      visit_taught(index_, roles_.learning(link.role), fillers, context.subsumers.items(), [&](ExprId learned) {
        const std::uint32_t copy = find(link.context, learned);
        if (copy == none) return;
        for (const Learning& learning : roles_.learning(link.role)) {
          for (const ExprId expr : grown(copy)) {
            const auto heard =
                std::ranges::equal_range(index_.existentials(expr), learning.role, {}, &ExistentialRule::role);
            for (const ExistentialRule& rule : heard) {
              if (learning.recognises) note(rule.existential);
            }
            const Expr& known = index_.expr(expr);
            if (learning.carries && known.kind == ExprKind::existential &&
                known.first == static_cast<std::uint32_t>(learning.role))
              note(expr);
          }
        }
      });
    }
  }
  base::sort_unique(result);
  return result;
}

bool SuccessorContexts::spread(std::vector<bool>& failing) {
  const ContextStore& contexts = saturation_.contexts();
  if (is_over_limit_) {
    const bool is_new = std::ranges::find(failing, false) != failing.end();
    failing.assign(failing.size(), true);
    return is_new;
  }
  bool is_more_open = !is_spread_;
  is_spread_ = true;
  const auto open = [&](std::uint32_t copy) {
    if (copies_[copy].is_open) return false;
    return copies_[copy].is_open = is_more_open = true;
  };
  for (const NewLink& one : new_links_) {
    if (failing[one.link.context]) (void)open(one.copy);
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (const Lesson& lesson : lessons_) {
      if (copies_[lesson.copy].is_open) changed = open(lesson.source) || changed;
    }
  }
  if (!is_more_open) return false;
  bool is_more_failing = false;
  for (std::uint32_t at = 0; at < contexts.size(); ++at) {
    if (failing[at]) continue;
    const Context& context = contexts[at];
    const std::span fillers(context.propagating.begin(), context.propagating.end());
    bool is_failing = false;
    for (const Link link : forward_[at]) {
      if (is_failing) break;
      visit_taught(index_, roles_.learning(link.role), fillers, context.subsumers.items(), [&](ExprId learned) {
        const std::uint32_t copy = find(link.context, learned);
        if (copy == none) return;
        const auto is_in_source = [&](ExprId expr) { return is_in(at, expr); };
        is_failing = is_failing || copies_[copy].is_open || !tells_nothing_new(copy, link.role, is_in_source);
      });
    }
    if (!is_failing) continue;
    failing[at] = is_more_failing = true;
  }
  return is_more_failing;
}

}  // namespace geminga::el
