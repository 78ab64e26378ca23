// Where the conclusions of a saturation are noted, and the rules by the premise that is new. The rules themselves are
// in rules.hpp, but for those that only a saturation has; the legend is in saturation.hpp.
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

void SaturationWorker::add_atom(std::uint32_t context, ExprId atom) {
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
  apply(context, subsumer);
  const Context& self = contexts_[context];
  if (self.is_unsatisfiable) return;
  if (index_.has_rules(subsumer, RuleBits::functional)) apply_functional(context, subsumer);
  if (index_.has_universals() && !self.is_unsatisfiable) process_universal(context, subsumer);
  if (index_.has_nominals() && !self.is_unsatisfiable) process_nominal(context, subsumer);
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

// The second premise of propagate() is new.
void SaturationWorker::add_filler(std::uint32_t context, ExprId subsumer) {
  Context& self = contexts_[context];
  self.propagating.push_back(subsumer, arena_);
  work_.add(self.backward_done);
  for (std::uint32_t at = 0; at < self.backward_done; ++at) propagate(self.backward[at], subsumer);
}

// The first premise of propagate() is new.
void SaturationWorker::process_backward(std::uint32_t context, Link link) {
  Context& self = contexts_[context];
  work_.add(self.propagating.size());
  for (std::uint32_t at = 0; at < self.propagating.size(); ++at) propagate(link, self.propagating[at]);
}

// The first premise of compose() is new. A link that is composed of two of a transitive R' is no first premise: its own
// first part is, again and again, so that a path of n links is walked n times and not n * n times.
void SaturationWorker::process_first(std::uint32_t context, Link link) {
  Context& self = contexts_[context];
  work_.add(self.forward_done);
  for (std::uint32_t at = 0; at < self.forward_done; ++at) {
    const Link next = self.forward[at];
    compose(link.context, link.role, next.role, next.context);
  }
}

// The second premise of compose() is new, or the link is one of a functional property.
void SaturationWorker::process_forward(std::uint32_t context, Link link) {
  Context& self = contexts_[context];
  if (index_.roles().is_second(link.role)) {
    work_.add(self.firsts_done);
    for (std::uint32_t at = 0; at < self.firsts_done; ++at) {
      const Link before = self.firsts[at];
      compose(before.context, before.role, link.role, link.context);
    }
  }
  if (index_.may_be_functional(link.role)) functional_link(context, link);
  if (self.is_nonempty && index_.has_nominals()) require_nonempty(link.context);
  if (index_.has_nominals() && index_.has_negative_self()) find_self_of_link(context, link.role, link.context);
}

void SaturationWorker::add_self(std::uint32_t context, RoleId role) {
  Context& self = contexts_[context];
  if (self.is_unsatisfiable || std::ranges::find(self.selfs, role) != self.selfs.end()) return;
  self.selfs.own().push_back(role);
  ++conclusions_;
  enqueue(context);
}

void SaturationWorker::add_loop(std::uint32_t context, RoleId role) {
  add_link(context, role, context);
  if (index_.has_universals()) process_universal_self(context, role);
  for (const RoleId super : index_.roles().supers(role)) {
    if (index_.may_be_functional(super)) functional_self(context, super);
  }
}

}  // namespace geminga::el
