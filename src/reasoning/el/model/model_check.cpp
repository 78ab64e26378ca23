// The test of a canonical model.
#include "reasoning/el/model/model_check.hpp"

#include <algorithm>
#include <ranges>

namespace geminga::el {

ModelCheck::ModelCheck(const IndexedOntology& index, const Saturation& saturation, const OpenParts& open,
                       std::span<const ExprId> classes, const SuccessorLimits& limits)
    : index_(index),
      saturation_(saturation),
      open_(open),
      inverses_(index, open.inverses),
      limits_(limits),
      is_failing_(saturation.contexts().size(), false),
      union_of_(saturation.contexts().size(), none),
      roots_(saturation.contexts().size(), Root::unknown),
      is_class_(index.size(), false),
      above_(index, saturation) {
  for (const ExprId named : classes) is_class_[number(named)] = true;
  index_unions();
  find_heard();
  test_contexts();
  make_successors();
  spread();
}

bool ModelCheck::is_settled(ExprId atom) {
  const ExprId representative = index_.representative(atom);
  ExprId root = representative;
  if (index_.needs_no_context(representative)) {
    root = index_.frontier(representative).empty() ? index_.representative(top_expr)
                                                   : index_.frontier(representative).front();
  }
  if (saturation_.find(root) == nullptr) return false;
  return is_root_settled(saturation_.number_of(root), 0);
}

void ModelCheck::find_heard() {
  const Roles& roles = index_.roles();
  is_heard_.assign(roles.count(), false);
  is_composed_.assign(roles.count(), false);
  const auto hear = [&](RoleId role) { is_heard_[static_cast<std::size_t>(role)] = true; };
  for (std::uint32_t id = 0; id < index_.size(); ++id) {
    for (const ExistentialRule& rule : index_.existentials(ExprId{id})) hear(rule.role);
    for (const UniversalRule& rule : index_.universals(ExprId{id})) hear(rule.role);
  }
  for (const OpenCount& count : open_.at_most) hear(count.role);
  for (std::uint32_t role = 0; role < roles.count(); ++role) {
    const bool is_asked = index_.range_of(RoleId{role}) != top_expr || index_.may_be_functional(RoleId{role}) ||
                          index_.negative_self(RoleId{role}) != bottom_expr;
    if (is_asked) hear(RoleId{role});
  }
  // A link that nothing hears may be part of a chain that something hears, or imply what something hears.
  for (bool changed = true; changed;) {
    changed = false;
    const auto set = [&](std::vector<bool>& flags, std::size_t at) {
      changed = changed || !flags[at];
      flags[at] = true;
    };
    for (std::uint32_t role = 0; role < roles.count(); ++role) {
      for (const RoleId super : roles.supers(RoleId{role})) {
        if (is_heard_[static_cast<std::size_t>(super)]) set(is_heard_, role);
      }
      for (const ImpliedRole& other : inverses_.implied(RoleId{role})) {
        if (is_heard_[static_cast<std::size_t>(other.role)]) set(is_heard_, role);
      }
      for (const Composition& rule : roles.compositions(RoleId{role})) {
        if (!is_heard_[static_cast<std::size_t>(rule.result)]) continue;
        for (const std::size_t part : {static_cast<std::size_t>(role), static_cast<std::size_t>(rule.second)}) {
          set(is_heard_, part);
          set(is_composed_, part);
        }
      }
    }
  }
}

bool ModelCheck::is_in(std::uint32_t context, ExprId atom) const {
  const ExprId representative = index_.representative(atom);
  return representative == index_.representative(top_expr) ||
         saturation_.contexts()[context].subsumers.contains(number(representative));
}

// An atom without rules stands in no context, but a class of which nothing may be missing must be known to be in it.
// What is nothing but a successor is asked for nothing.
bool ModelCheck::has(std::uint32_t context, ExprId atom, bool is_only_successor) {
  const ExprId representative = index_.representative(atom);
  const Context& element = saturation_.contexts()[context];
  if (is_in(context, representative)) return true;
  if (index_.is_active(representative)) return false;
  const bool is_individual = index_.is_nominal(element.root) || !element.nominals.empty();
  if (is_only_successor && !is_individual) {
    return std::ranges::all_of(index_.frontier(representative), [&](ExprId above) { return is_in(context, above); });
  }
  if (!element.together.empty()) return false;
  (void)above_.of(element.root);
  return above_.contains(representative);
}

/// Whether an element is in all that something is told to be in which is nothing but a name for that: `S some D` where
/// a link makes it so, or the atom of a range.
bool ModelCheck::has_what_is_told(std::uint32_t context, ExprId named, bool is_only_successor) {
  if (is_in(context, named)) return true;
  constexpr auto above = static_cast<std::uint8_t>(RuleBits::above);
  if ((index_.rule_bits(named) & ~above) != 0 || !index_.universals(named).empty()) return false;
  return std::ranges::all_of(index_.told_atoms(named),
                             [&](ExprId atom) { return has(context, atom, is_only_successor); });
}

void ModelCheck::fail(std::uint32_t context) {
  if (is_failing_[context]) return;
  is_failing_[context] = true;
  failing_.push_back(context);
}

void ModelCheck::test_contexts() {
  const ContextStore& contexts = saturation_.contexts();
  std::vector<std::uint32_t> links_of(open_.at_most.empty() ? 0 : contexts.size(), 0);
  for (std::uint32_t at = 0; at < contexts.size(); ++at) {
    const Context& context = contexts[at];
    if (context.is_unsatisfiable) continue;
    //  x in X   [X < C or D]
    find_union(at);
    //  x in X   [X < at least n R C]; as many copies of the successor as there must be, unless something counts them
    for (const OpenCount& open : open_.at_least) {
      const bool may_be_counted =
          index_.may_be_functional(open.role) || index_.has_nominals() || !open_.at_most.empty();
      if (may_be_counted && is_in(at, open.whole)) fail(at);
    }
    // What is below an individual, and need not be, is not an element of its own.
    if (!context.nominals.empty() && !context.is_nonempty) fail(at);
    for (const RoleId role : context.selfs) test_link(at, role, at);
    for (const Link link : context.backward.items()) {
      if (contexts[link.context].is_unsatisfiable) continue;
      test_link(link.context, link.role, at);
      if (!links_of.empty()) ++links_of[link.context];
    }
  }
  for (std::uint32_t at = 0; at < links_of.size(); ++at) {
    //  x in X   [X < at most n R C]; links of other properties are counted, too
    for (const OpenCount& open : open_.at_most) {
      if (links_of[at] > open.count && !contexts[at].is_unsatisfiable && is_in(at, open.whole)) fail(at);
    }
  }
}

void ModelCheck::test_link(std::uint32_t from, RoleId role, std::uint32_t to) {
  if (!is_failing_[from] && !is_implied_satisfied(from, role, to)) fail(from);
}

/// Whether what inverses say of a link is so, but for what only the copy at its end learns (make_successors()).
bool ModelCheck::is_implied_satisfied(std::uint32_t from, RoleId role, std::uint32_t to) {
  const auto implied = inverses_.implied(role);
  const auto is_heard = [&](const ImpliedRole& other) { return is_heard_[static_cast<std::size_t>(other.role)]; };
  if (std::ranges::none_of(implied, is_heard)) return true;
  if (!inverses_.is_known(role) || !open_.is_mirrored) return false;
  const bool is_fit = std::ranges::all_of(implied, [&](const ImpliedRole& other) {
    if (!is_heard(other)) return true;
    return other.is_backward ? is_backward_link_satisfied(to, other.role, from)
                             : is_link_satisfied(from, other.role, to, false);
  });
  return is_fit && std::ranges::all_of(inverses_.ranges_of_beginning(role), [&](RoleId heard) {
           return has_what_is_told(from, index_.representative(index_.range_of(heard)), false);
         });
}

/// Whether a link back, from the successor to what it is the successor of, asks nothing new of either; what it lets the
/// successor learn is not looked at.
bool ModelCheck::is_backward_link_satisfied(std::uint32_t from, RoleId role, std::uint32_t to) {
  if (is_composed_[static_cast<std::size_t>(role)] &&
      (index_.has_nominals() || index_.has_universals() || !open_.at_most.empty()))
    return false;
  return may_be_linked(from, role, to, true);
}

/// Whether a successor is in all that it learns of its source without growing by it.
bool ModelCheck::knows_what_it_learns(std::uint32_t from, RoleId role, std::uint32_t to) {
  const Context& source = saturation_.contexts()[from];
  bool knows = true;
  visit_taught(index_, inverses_.learning(role), std::span(source.propagating.begin(), source.propagating.end()),
               source.subsumers.items(), [&](ExprId learned) { knows = knows && has_what_is_told(to, learned, true); });
  return knows;
}

void ModelCheck::make_successors() {
  const auto tells = [&](std::uint32_t role) { return inverses_.tells_end(RoleId{role}); };
  if (open_.inverses.empty() ||
      std::ranges::none_of(std::views::iota(0U, static_cast<std::uint32_t>(index_.roles().count())), tells))
    return;
  constexpr auto looked_at = static_cast<std::uint8_t>(
      static_cast<std::uint8_t>(RuleBits::above) | static_cast<std::uint8_t>(RuleBits::links) |
      static_cast<std::uint8_t>(RuleBits::conjunctions) | static_cast<std::uint8_t>(RuleBits::existentials));
  std::vector<bool> may_grow(index_.size());
  for (std::uint32_t id = 0; id < index_.size(); ++id) {
    may_grow[id] = (index_.rule_bits(ExprId{id}) & ~looked_at) == 0 && index_.universals(ExprId{id}).empty() &&
                   !index_.is_nominal(ExprId{id}) && unions_of_[id].empty();
  }
  for (const auto* counts : {&open_.at_most, &open_.at_least}) {
    for (const OpenCount& count : *counts) may_grow[number(index_.representative(count.whole))] = false;
  }
  successors_.emplace(index_, saturation_, inverses_,
                      SuccessorContexts::Growing{
                          .may_grow = std::move(may_grow),
                          .growth =
                              [&](std::uint32_t at, ExprId learned) {
                                const Context& context = saturation_.contexts()[at];
                                const bool is_individual = index_.is_nominal(context.root) || !context.nominals.empty();
                                if (!is_individual && context.selfs.empty() && union_of_[at] == none)
                                  return SuccessorContexts::Growth::free;
                                return has_what_is_told(at, learned, true) ? SuccessorContexts::Growth::not_needed
                                                                           : SuccessorContexts::Growth::forbidden;
                              },
                          .may_lead_to =
                              [&](std::uint32_t from, RoleId role, std::uint32_t to) {
                                return union_of_[to] == none && !index_.may_be_functional(role) &&
                                       open_.at_most.empty() && !index_.has_nominals() && !index_.has_universals() &&
                                       is_implied_satisfied(from, role, to);
                              },
                      },
                      limits_);
}

/// Whether a further link between two elements would leave everything as it is. One of them is the successor of the
/// other by some link: the source, if `is_backward`.
bool ModelCheck::is_link_satisfied(std::uint32_t from, RoleId role, std::uint32_t to, bool is_backward) {
  if (is_composed_[static_cast<std::size_t>(role)] || !may_be_linked(from, role, to, is_backward)) return false;
  //  y < D   [S some D occurs negatively]; the source must be in S some D
  const Context& target = saturation_.contexts()[to];
  return std::ranges::all_of(target.propagating, [&](ExprId filler) {
    return std::ranges::all_of(index_.existentials(filler), [&](const ExistentialRule& rule) {
      return !index_.roles().is_sub_role(role, rule.role) || has_what_is_told(from, rule.existential, is_backward);
    });
  });
}

/// The same but for what the source is in because of the link.
bool ModelCheck::may_be_linked(std::uint32_t from, RoleId role, std::uint32_t to, bool is_backward) {
  const Roles& roles = index_.roles();
  const Context& source = saturation_.contexts()[from];
  if (index_.may_be_functional(role) || from == to) return false;
  for (const RoleId super : roles.supers(role)) {
    if (index_.negative_self(super) != bottom_expr) return false;  // the two may be one individual
    //  y in E   [E is the range of S]
    const ExprId range = index_.range_of(super);
    if (range != top_expr && !has_what_is_told(to, index_.representative(range), !is_backward)) return false;
  }
  for (const ExprId restricting : source.restricting) {
    for (const UniversalRule& rule : index_.universals(restricting)) {
      if (roles.is_sub_role(role, rule.role) && !has(to, rule.target, !is_backward)) return false;
    }
  }
  return std::ranges::none_of(open_.at_most, [&](const OpenCount& open) {
    return roles.is_sub_role(role, open.role) && is_in(from, open.whole);
  });
}

void ModelCheck::spread_to_successors() {
  if (!successors_) return;
  std::vector<bool> failing = is_failing_;
  while (successors_->spread(failing)) {
    for (std::uint32_t at = 0; at < failing.size(); ++at) {
      if (failing[at]) fail(at);
    }
    follow();
    failing = is_failing_;
  }
}

// What leads to an element that fails has a model only where the element has another.
void ModelCheck::follow() {
  while (!failing_.empty()) {
    const std::uint32_t at = failing_.back();
    failing_.pop_back();
    for (const Link link : saturation_.contexts()[at].backward.items()) {
      if (!saturation_.contexts()[link.context].is_unsatisfiable) fail(link.context);
    }
  }
}

void ModelCheck::spread() {
  const ContextStore& contexts = saturation_.contexts();
  test_links_to_unions();
  // The individuals stand in one world: what leads to one of them leads to all.
  for (std::uint32_t at = 0; at < contexts.size(); ++at) {
    const ExprId root = contexts[at].root;
    const bool must_be = index_.is_nominal(root) || root == index_.representative(top_expr);
    const bool is_open = is_failing_[at] || union_of_[at] != none;
    if (must_be && is_open && !contexts[at].is_unsatisfiable) is_world_settled_ = false;
  }
  if (is_world_settled_) return;
  for (std::uint32_t at = 0; at < contexts.size(); ++at) {
    if (index_.is_nominal(contexts[at].root) && !contexts[at].is_unsatisfiable) fail(at);
  }
  test_links_to_unions();
}

}  // namespace geminga::el
