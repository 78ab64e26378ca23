// Contexts are made once, conclusions are noted once, and messages carry them to other workers.
#include "reasoning/el/closure/conclusions.hpp"

#include <algorithm>
#include <new>
#include <thread>

#include "base/interner.hpp"
#include "base/parallel/claim.hpp"

namespace geminga::el {

SharedContexts::SharedContexts(const IndexedOntology& of, const SaturationLimits& within)
    : index(of), limits(within), keeps_forward(of.has_nominals()), context_of(of.size()) {}

//   ----- (init)   -----
//   C < C          C < T
std::uint32_t Conclusions::require(ExprId root) {
  std::atomic<std::uint32_t>& entry = shared_.context_of[number(root)];
  std::uint32_t known = entry.load(std::memory_order_acquire);
  while (known <= SharedContexts::claimed_context) {
    if (known == SharedContexts::claimed_context) {
      std::this_thread::yield();  // another thread makes it
      known = entry.load(std::memory_order_acquire);
    } else if (entry.compare_exchange_weak(known, SharedContexts::claimed_context, std::memory_order_acq_rel)) {
      parallel::Claim claim(entry, SharedContexts::no_context);
      const std::uint32_t created = contexts_.add();
      contexts_[created].root = root;
      start(created, {{root, top_expr}});
      if (index().is_nominal(root)) (void)mark_nonempty(created);  // it has no links to follow yet
      claim.settle(created + 2);
      return created;
    }
  }
  return known - 2;
}

std::uint32_t Conclusions::require_together(const std::vector<ExprId>& atoms) {
  if (atoms.size() == 1) return require(atoms.front());
  const std::scoped_lock lock(shared_.together_mutex);  // only functional properties and universals ask for these
  const auto [known, is_new] = shared_.context_of_some.try_emplace(atoms, 0);
  if (!is_new) return known->second;
  const std::uint32_t created = contexts_.add();
  known->second = created;
  contexts_[created].root = bottom_expr;
  contexts_[created].together.own() = atoms;
  conclusions_ += atoms.size();
  shared_.merged_atoms += atoms.size();
  if (shared_.merged_atoms > shared_.limits.merged_atoms) {
    shared_.is_over_merged = true;
    shared_.is_over_limit = true;
  }
  std::vector<ExprId> above = atoms;
  above.push_back(top_expr);
  start(created, above);
  return created;
}

void Conclusions::start(std::uint32_t context, std::span<const ExprId> atoms) {
  queue_.add(context);
  for (const ExprId own : atoms) {
    if (index().is_active(own)) {
      add_subsumer(context, own);
    } else {
      for (const ExprId above : index().frontier(own)) add_subsumer(context, above);
    }
  }
}

std::vector<ExprId> Conclusions::members_of(std::uint32_t context) const {
  const Context& self = contexts_[context];
  return self.together.empty() ? std::vector<ExprId>{self.root} : self.together.get();
}

void Conclusions::add_subsumer(std::uint32_t context, ExprId subsumer) {
  if (queue_.is_elsewhere(context)) return post(context, {Message::Kind::subsumer, number(subsumer), 0});
  Context& self = contexts_[context];
  if (self.is_unsatisfiable || !self.subsumers.insert(number(subsumer), arena_)) return;
  ++conclusions_;
  if (index().has_universals() && !index().universals(subsumer).empty()) self.restricting.own().push_back(subsumer);
  queue_.enqueue(context);
}

void Conclusions::add_atom(std::uint32_t context, ExprId atom) {
  Context& self = contexts_[context];
  if (self.is_unsatisfiable || atom == self.root) return;
  if (index().is_active(atom)) {
    if (self.subsumers.contains(number(atom))) return;
    self.derived.push_back(atom, arena_);
    add_subsumer(context, atom);
    return;
  }
  self.derived.push_back(atom, arena_);
  for (const ExprId above : index().frontier(atom)) add_subsumer(context, above);
}

//  C -R-> D   D < F
//  ---------------- ; the worker walks the links of an unsatisfiable context
//  C < F
void Conclusions::add_bottom(std::uint32_t context) {
  if (queue_.is_elsewhere(context)) return post(context, {Message::Kind::bottom, 0, 0});
  Context& self = contexts_[context];
  if (self.is_unsatisfiable) return;
  self.is_unsatisfiable = true;
  ++conclusions_;
  if (self.is_nonempty) shared_.is_inconsistent = true;
  self.backward_done = self.firsts_done = 0;
  self.firsts.clear(arena_);
  self.subsumers_done = self.forward_done = self.selfs_done = 0;
  self.subsumers.clear(arena_);
  self.forward.clear(arena_);
  self.propagating.clear(arena_);
  self.derived.clear(arena_);
  self.selfs.clear();
  self.groups.clear();
  self.restricting.clear();
  self.nominals.clear();
  queue_.enqueue(context);
}

void Conclusions::add_link(std::uint32_t from, RoleId role, std::uint32_t to, bool is_last) {
  // Only the holder of `from` sees whether it is unsatisfiable.
  if (!queue_.is_elsewhere(from) && contexts_[from].is_unsatisfiable) return;
  if (queue_.is_elsewhere(to)) {
    const auto kind = is_last ? Message::Kind::last : Message::Kind::backward;
    return post(to, {kind, static_cast<std::uint32_t>(role), from});
  }
  Context& end = contexts_[to];
  const bool may_go_on = !is_last && !index().roles().compositions(role).empty() && !end.is_unsatisfiable;
  if (may_go_on) {
    // A first is a link that was noted. Chains conclude the same link again and again.
    if (!end.firsts.insert({role, from}, arena_)) return;
    queue_.enqueue(to);
  }
  if (!end.backward.insert({role, from}, arena_)) return;
  ++conclusions_;
  ++links_;
  queue_.enqueue(to);
  if (shared_.keeps_forward || index().roles().is_second(role) || index().may_be_functional(role)) {
    add_forward(from, {role, to});
  }
}

void Conclusions::add_forward(std::uint32_t from, Link link) {
  if (queue_.is_elsewhere(from)) {
    return post(from, {Message::Kind::forward, static_cast<std::uint32_t>(link.role), link.context});
  }
  Context& self = contexts_[from];
  if (self.is_unsatisfiable) return;
  self.forward.push_back(link, arena_);
  queue_.enqueue(from);
}

void Conclusions::add_self(std::uint32_t context, RoleId role) {
  Context& self = contexts_[context];
  if (self.is_unsatisfiable || std::ranges::find(self.selfs, role) != self.selfs.end()) return;
  self.selfs.own().push_back(role);
  ++conclusions_;
  queue_.enqueue(context);
}

bool Conclusions::mark_nonempty(std::uint32_t context) {
  Context& self = contexts_[context];
  if (self.is_nonempty) return false;
  self.is_nonempty = true;
  if (self.is_unsatisfiable) shared_.is_inconsistent = true;
  return true;
}

void Conclusions::post(std::uint32_t context, const Message& message) {
  if (queue_.take(context)) return receive(context, message);
  // A repeated message changes nothing, and chains conclude the same link again and again.
  if (posted_.empty()) posted_.resize(posted_count);
  const std::uint64_t kind_and_context = static_cast<std::uint64_t>(message.kind) << 32 | context;
  Posted& slot = posted_[base::mixed(base::mixed(kind_and_context, message.first), message.second) % posted_count];
  if (slot.context == context && slot.message == message) return;
  slot = {context, message};
  queue_.post(context, ::new (arena_.allocate(sizeof(QueuedMessage))) QueuedMessage{nullptr, message});
}

void Conclusions::read(std::uint32_t context, QueuedMessage* waiting) {
  receive(context, waiting->message);
  arena_.release(waiting, sizeof(QueuedMessage));
}

void Conclusions::receive(std::uint32_t context, const Message& message) {
  switch (message.kind) {
    case Message::Kind::subsumer:
      return add_subsumer(context, ExprId{message.first});
    case Message::Kind::backward:
      return add_link(message.second, RoleId{message.first}, context);
    case Message::Kind::forward:
      return add_forward(context, {RoleId{message.first}, message.second});
    case Message::Kind::bottom:
      return add_bottom(context);
    case Message::Kind::last:
      return add_link(message.second, RoleId{message.first}, context, true);
  }
}

}  // namespace geminga::el
