// The rules, each in logic notation beside its code; the legend is in saturation.hpp.
#include <algorithm>

#include "reasoning/el/saturation_worker.hpp"

namespace geminga::el {

void SaturationWorker::add_subsumer(std::uint32_t context, ExprId subsumer) {
  if (is_elsewhere(context)) return post(context, {Message::Kind::subsumer, number(subsumer), 0});
  Context& self = contexts_[context];
  if (self.is_unsatisfiable || !self.subsumers.insert(number(subsumer), arena_)) return;
  ++conclusions_;
  if (index_.has_universals() && !index_.universals(subsumer).empty()) self.restricting.own().push_back(subsumer);
  enqueue(context);
}

void SaturationWorker::add_derived_atom(std::uint32_t context, ExprId atom) {
  Context& self = contexts_[context];
  if (self.is_unsatisfiable || atom == self.root) return;
  if (index_.is_active(atom)) {
    if (self.subsumers.contains(number(atom))) return;
    self.derived.push_back(atom, arena_);
    add_subsumer(context, atom);
    return;
  }
  self.derived.push_back(atom, arena_);
  for (const ExprId above : index_.frontier(atom)) add_subsumer(context, above);
}

void SaturationWorker::process_subsumer(std::uint32_t context, ExprId subsumer) {
  Context& self = contexts_[context];
  const auto has = [&](RuleBits rules) { return index_.has_rules(subsumer, rules); };

  //  C < D
  //  ----- [D < F is told]
  //  C < F
  if (has(RuleBits::bottom)) return add_bottom(context);

  //  C < D
  //  ----- [D < E is told]; of an atom D the taxonomy knows it, of others it must be noted
  //  C < E
  if (has(RuleBits::above)) {
    if (index_.is_atom(subsumer)) {
      for (const ExprId above : index_.frontier(subsumer)) add_subsumer(context, above);
    } else {
      for (const ExprId above : index_.told_atoms(subsumer)) add_derived_atom(context, above);
    }
  }

  //  C < D
  //  -------- [D < R some E is told]
  //  C -R-> E
  if (has(RuleBits::links)) {
    for (const LinkRule& link : index_.links(subsumer)) add_link(context, link.role, require_restricted(context, link));
  }

  //  C < D
  //  ---------- [D < R Self is told]
  //  C < R Self
  if (has(RuleBits::selfs)) {
    for (const RoleId role : index_.selfs(subsumer)) add_self(context, role);
  }

  //  C < D   C < E
  //  ------------- [D and E occurs negatively]
  //  C < D and E
  if (has(RuleBits::conjunctions)) apply_conjunctions(context, index_.conjunctions(subsumer));

  //  C -R-> D   D < E
  //  ---------------- [S some E occurs negatively, R <* S]; here the second premise is new
  //  C < S some E
  if (has(RuleBits::existentials)) {
    self.propagating.push_back(subsumer, arena_);
    work_.add(self.backward_done);
    for (std::uint32_t at = 0; at < self.backward_done; ++at) propagate(self.backward[at], subsumer);
  }

  if (has(RuleBits::disjointness)) {
    for (const std::uint32_t axiom : index_.disjointness(subsumer)) add_disjointness(context, axiom);
    if (self.is_unsatisfiable) return;
  }

  //  C < D   C -R-> E
  //  ---------------- [D has at most one S, R <* S]; here the first premise is new
  //  E is the one S successor, as below
  if (has(RuleBits::functional)) {
    for (const RoleId functional : index_.functional_roles(subsumer)) {
      for (std::uint32_t at = 0; at < self.forward_done && !self.is_unsatisfiable; ++at) {
        group_successor(context, functional, self.forward[at]);
      }
      process_functional_self(context, functional);
    }
  }
  if (index_.has_universals() && !self.is_unsatisfiable) process_universal(context, subsumer);
  if (index_.has_nominals() && !self.is_unsatisfiable) process_nominal(context, subsumer);
}

void SaturationWorker::apply_conjunctions(std::uint32_t context, std::span<const ConjunctionRule> rules) {
  // Whichever is shorter is walked, and the other searched: names like "disease" are in thousands of conjunctions.
  Context& self = contexts_[context];
  work_.add(std::min<std::size_t>(rules.size(), self.subsumers.size()));
  if (rules.size() <= std::size_t{self.subsumers.size()} * 2) {
    for (const ConjunctionRule& rule : rules) {
      if (self.subsumers.contains(number(rule.partner))) add_subsumer(context, rule.conjunction);
    }
    return;
  }
  for (std::size_t at = 0; at < self.subsumers.size(); ++at) {
    const ExprId partner{self.subsumers[at]};
    for (auto rule = std::ranges::lower_bound(rules, partner, {}, &ConjunctionRule::partner);
         rule != rules.end() && rule->partner == partner; ++rule) {
      add_subsumer(context, rule->conjunction);
    }
  }
}

//  C < D   C < E
//  ------------- [D and E are different members of one disjointness axiom]
//  C < F
void SaturationWorker::add_disjointness(std::uint32_t context, std::uint32_t axiom) {
  Context& self = contexts_[context];
  if (self.is_unsatisfiable) return;
  // The axiom's mark in the set of subsumers says that one member was there before.
  if (!self.subsumers.insert(static_cast<std::uint32_t>(index_.size()) + axiom, arena_)) add_bottom(context);
}

//  C -R-> D   D < F
//  ---------------- ; what is left to do for C < F itself
//  C < F
void SaturationWorker::add_bottom(std::uint32_t context) {
  if (is_elsewhere(context)) return post(context, {Message::Kind::bottom, 0, 0});
  Context& self = contexts_[context];
  if (self.is_unsatisfiable) return;
  self.is_unsatisfiable = true;
  ++conclusions_;
  if (self.is_nonempty) shared_.is_inconsistent = true;
  self.backward_done = self.firsts_done = 0;
  self.firsts.clear(arena_);
  self.subsumers_done = self.forward_done = self.selfs_done = 0;  // what they count is gone
  self.subsumers.clear(arena_);
  self.forward.clear(arena_);
  self.propagating.clear(arena_);
  self.derived.clear(arena_);
  self.selfs.clear();
  self.groups.clear();
  self.restricting.clear();
  self.nominals.clear();
  enqueue(context);
}

void SaturationWorker::add_link(std::uint32_t from, RoleId role, std::uint32_t to, bool is_last) {
  // Of another thread's context it is not known whether it is still worth it; that one will see.
  if (!is_elsewhere(from) && contexts_[from].is_unsatisfiable) return;
  if (is_elsewhere(to)) {
    const auto kind = is_last ? Message::Kind::last : Message::Kind::backward;
    return post(to, {kind, static_cast<std::uint32_t>(role), from});
  }
  if (!is_last && !index_.roles().compositions(role).empty() && !contexts_[to].is_unsatisfiable &&
      contexts_[to].firsts.insert({role, from}, arena_))
    enqueue(to);
  if (!contexts_[to].backward.insert({role, from}, arena_)) return;
  ++conclusions_;
  ++links_;
  enqueue(to);
  if (shared_.keeps_forward || index_.roles().is_second(role) || index_.may_be_functional(role)) {
    add_forward(from, {role, to});
  }
}

void SaturationWorker::add_forward(std::uint32_t from, Link link) {
  if (is_elsewhere(from)) {
    return post(from, {Message::Kind::forward, static_cast<std::uint32_t>(link.role), link.context});
  }
  Context& self = contexts_[from];
  if (self.is_unsatisfiable) return;
  self.forward.push_back(link, arena_);
  enqueue(from);
}

void SaturationWorker::propagate(Link link, ExprId filler) {
  // What a hub is below may be the filler of thousands of existentials, of which one link concerns a handful.
  constexpr std::size_t max_scanned = 8;
  const Roles& roles = index_.roles();
  const auto rules = index_.existentials(filler);
  if (rules.size() <= max_scanned) {
    for (const ExistentialRule& rule : rules) {
      if (roles.is_sub_role(link.role, rule.role)) add_subsumer(link.context, rule.existential);
    }
    return;
  }
  for (const RoleId super : roles.supers(link.role)) {
    for (auto rule = std::ranges::lower_bound(rules, super, {}, &ExistentialRule::role);
         rule != rules.end() && rule->role == super; ++rule) {
      add_subsumer(link.context, rule->existential);
    }
  }
}

void SaturationWorker::process_backward(std::uint32_t context, Link link) {
  Context& self = contexts_[context];

  //  C -R-> D   D < E
  //  ---------------- [S some E occurs negatively, R <* S]; here the first premise is new
  //  C < S some E
  work_.add(self.propagating.size());
  for (std::uint32_t at = 0; at < self.propagating.size(); ++at) propagate(link, self.propagating[at]);
}

//  C -R-> D   D -S-> E
//  ------------------- [R o S SubPropertyOf R']; here the first premise is new
//  C -R'-> E
//  A link that is composed of two of a transitive R' is no first premise: its own first part is, again and again, so
//  that a path of n links is walked n times and not n * n times.
void SaturationWorker::process_first(std::uint32_t context, Link link) {
  Context& self = contexts_[context];
  work_.add(self.forward_done);
  for (std::uint32_t at = 0; at < self.forward_done; ++at) {
    const Link next = self.forward[at];
    compose(link.context, link.role, next.role, next.context);
  }
}

void SaturationWorker::process_forward(std::uint32_t context, Link link) {
  //  C -R-> D   D -S-> E
  //  ------------------- [R o S SubPropertyOf R']; here the second premise is new
  //  C -R'-> E
  Context& self = contexts_[context];
  if (index_.roles().is_second(link.role)) {
    work_.add(self.firsts_done);
    for (std::uint32_t at = 0; at < self.firsts_done; ++at) {
      const Link before = self.firsts[at];
      compose(before.context, before.role, link.role, link.context);
    }
  }
  if (index_.may_be_functional(link.role)) process_functional(context, link);
  if (self.is_nonempty && index_.has_nominals()) require_nonempty(link.context);
  if (index_.has_nominals() && index_.has_negative_self()) find_self_of_link(context, link.role, link.context);
}

void SaturationWorker::compose(std::uint32_t from, RoleId first, RoleId second, std::uint32_t to) {
  const auto rules = index_.roles().compositions(first);
  for (auto rule = std::ranges::lower_bound(rules, second, {}, &Composition::second);
       rule != rules.end() && rule->second == second; ++rule) {
    add_link(from, rule->result, to, index_.roles().is_last(first, second, rule->result));
  }
}

void SaturationWorker::add_self(std::uint32_t context, RoleId role) {
  Context& self = contexts_[context];
  if (self.is_unsatisfiable || std::ranges::find(self.selfs, role) != self.selfs.end()) return;
  self.selfs.own().push_back(role);
  ++conclusions_;
  enqueue(context);
}

void SaturationWorker::process_self(std::uint32_t context, RoleId role) {
  //  C < R Self
  //  ---------- [R <* S, S Self occurs negatively]
  //  C < S Self
  for (const RoleId super : index_.roles().supers(role)) {
    const ExprId negative = index_.negative_self(super);
    if (negative != bottom_expr) add_subsumer(context, negative);
  }

  //  C < R Self    C < R Self
  //  ----------    ---------- [E is the range of R]
  //  C -R-> C      C < E
  add_link(context, role, context);
  if (index_.has_universals()) process_universal_self(context, role);
  for (const RoleId super : index_.roles().supers(role)) {
    if (index_.may_be_functional(super)) process_functional_self(context, super);
  }
  if (index_.range_of(role) != top_expr) add_derived_atom(context, index_.representative(index_.range_of(role)));

  //  C < R Self   C < S Self
  //  ----------------------- [R o S SubPropertyOf R']
  //  C < R' Self
  const auto compose_selfs = [&](RoleId first, RoleId second) {
    for (const Composition& rule : index_.roles().compositions(first)) {
      if (rule.second == second) add_self(context, rule.result);
    }
  };
  const std::uint32_t done = contexts_[context].selfs_done;
  for (std::uint32_t at = 0; at < done; ++at) {
    const RoleId other = contexts_[context].selfs[at];
    compose_selfs(role, other);
    if (other != role) compose_selfs(other, role);
  }
}

}  // namespace geminga::el
