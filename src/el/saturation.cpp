// The rules, each in logic notation beside its code; the legend is in saturation.hpp.
#include "el/saturation.hpp"

#include <algorithm>
#include <limits>

namespace geminga::el {
namespace {

constexpr std::uint32_t no_context = std::numeric_limits<std::uint32_t>::max();

}  // namespace

Saturation::Saturation(const Index& index, std::size_t max_conclusions)
    : index_(index),
      max_conclusions_(max_conclusions),
      keeps_forward_(index.has_nominals()),
      context_of_(index.size(), no_context) {
  const std::uint32_t top = require(top_expr);
  require_nonempty(top);
}

const Context* Saturation::find(ExprId root) const {
  const std::uint32_t context = context_of_[number(root)];
  return context == no_context ? nullptr : &contexts_[context];
}

//   ----- (init)   -----
//   C < C          C < T
std::uint32_t Saturation::require(ExprId root) {
  std::uint32_t& context = context_of_[number(root)];
  if (context != no_context) return context;
  context = static_cast<std::uint32_t>(contexts_.size());
  const std::uint32_t created = context;
  contexts_.emplace_back().root = root;
  start(created, {{root, top_expr}});
  if (index_.is_nominal(root)) require_nonempty(created);
  return created;
}

void Saturation::start(std::uint32_t context, std::span<const ExprId> atoms) {
  for (const ExprId own : atoms) {
    if (index_.is_active(own)) {
      add_subsumer(context, own);
    } else {
      for (const ExprId above : index_.frontier(own)) add_subsumer(context, above);
    }
  }
}

bool Saturation::run() {
  while (!queue_.empty() && is_consistent_) {
    const std::uint32_t context = queue_.back();
    queue_.pop_back();
    contexts_[context].is_queued = false;
    process(context);
    if (conclusions_ > max_conclusions_) return false;
  }
  return true;
}

void Saturation::enqueue(std::uint32_t context) {
  if (contexts_[context].is_queued) return;
  contexts_[context].is_queued = true;
  queue_.push_back(context);
}

void Saturation::process(std::uint32_t context) {
  Context& self = contexts_[context];  // a deque does not move its members
  while (is_consistent_ && conclusions_ <= max_conclusions_) {
    if (self.is_unsatisfiable) {
      if (self.backward_done == self.backward.size()) break;
      add_bottom(self.backward[self.backward_done++].context);
    } else if (self.subsumers_done < self.subsumers.size()) {
      const std::uint32_t subsumer = self.subsumers[self.subsumers_done++];
      if (subsumer < index_.size()) process_subsumer(context, ExprId{subsumer});
    } else if (self.backward_done < self.backward.size()) {
      process_backward(context, self.backward[self.backward_done++]);
    } else if (self.forward_done < self.forward.size()) {
      process_forward(context, self.forward[self.forward_done++]);
    } else if (self.selfs_done < self.selfs.size()) {
      process_self(context, self.selfs[self.selfs_done++]);
    } else {
      break;
    }
  }
}

void Saturation::add_subsumer(std::uint32_t context, ExprId subsumer) {
  Context& self = contexts_[context];
  if (self.is_unsatisfiable || !self.subsumers.insert(number(subsumer))) return;
  ++conclusions_;
  enqueue(context);
}

void Saturation::add_derived_atom(std::uint32_t context, ExprId atom) {
  Context& self = contexts_[context];
  if (self.is_unsatisfiable || atom == self.root) return;
  if (index_.is_active(atom)) {
    if (self.subsumers.contains(number(atom))) return;
    self.derived.push_back(atom);
    add_subsumer(context, atom);
    return;
  }
  self.derived.push_back(atom);
  for (const ExprId above : index_.frontier(atom)) add_subsumer(context, above);
}

void Saturation::process_subsumer(std::uint32_t context, ExprId subsumer) {
  Context& self = contexts_[context];

  //  C < D
  //  ----- [D < F is told]
  //  C < F
  if (index_.is_told_bottom(subsumer)) return add_bottom(context);

  //  C < D
  //  ----- [D < E is told]; of an atom D the taxonomy knows it, of others it must be noted
  //  C < E
  if (index_.is_atom(subsumer)) {
    for (const ExprId above : index_.frontier(subsumer)) add_subsumer(context, above);
  } else {
    for (const ExprId above : index_.told_atoms(subsumer)) add_derived_atom(context, above);
  }

  //  C < D
  //  -------- [D < R some E is told]
  //  C -R-> E
  for (const LinkRule& link : index_.links(subsumer)) {
    // By a functional role the successor may turn out to be this one itself, which then is in the target, too.
    const bool may_be_itself = index_.may_be_functional(link.role);
    add_link(context, link.role, require(may_be_itself ? link.target : index_.link_root(link.target)));
  }

  //  C < D
  //  ---------- [D < R Self is told]
  //  C < R Self
  for (const RoleId role : index_.selfs(subsumer)) add_self(context, role);

  //  C < D   C < E
  //  ------------- [D and E occurs negatively]
  //  C < D and E
  apply_conjunctions(context, index_.conjunctions(subsumer));

  //  C -R-> D   D < E
  //  ---------------- [S some E occurs negatively, R <* S]; here the second premise is new
  //  C < S some E
  for (const ExistentialRule& rule : index_.existentials(subsumer)) {
    self.propagations.push_back(rule);
    for (std::uint32_t at = 0; at < self.backward_done; ++at) {
      const Link link = self.backward[at];
      if (index_.roles().is_sub_role(link.role, rule.role)) add_subsumer(link.context, rule.existential);
    }
  }

  for (const std::uint32_t axiom : index_.disjointness(subsumer)) add_disjointness(context, axiom);

  //  C < D   C -R-> E
  //  ---------------- [D has at most one S, R <* S]; here the first premise is new
  //  E is the one S successor, as below
  for (const RoleId functional : index_.functional_roles(subsumer)) {
    for (std::uint32_t at = 0; at < self.forward_done && !self.is_unsatisfiable; ++at) {
      group_successor(context, functional, self.forward[at]);
    }
    process_functional_self(context, functional);
  }
  if (index_.has_nominals() && !self.is_unsatisfiable) process_nominal(context, subsumer);
}

void Saturation::apply_conjunctions(std::uint32_t context, std::span<const ConjunctionRule> rules) {
  // Whichever is shorter is walked, and the other searched: names like "disease" are in thousands of conjunctions.
  Context& self = contexts_[context];
  if (rules.size() <= self.subsumers.size() * 2) {
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
void Saturation::add_disjointness(std::uint32_t context, std::uint32_t axiom) {
  // The axiom's mark in the set of subsumers says that one member was there before.
  if (!contexts_[context].subsumers.insert(static_cast<std::uint32_t>(index_.size()) + axiom)) add_bottom(context);
}

//  C -R-> D   D < F
//  ---------------- ; what is left to do for C < F itself
//  C < F
void Saturation::add_bottom(std::uint32_t context) {
  Context& self = contexts_[context];
  if (self.is_unsatisfiable) return;
  self.is_unsatisfiable = true;
  ++conclusions_;
  if (self.is_nonempty) is_consistent_ = false;
  self.backward_done = 0;
  self.subsumers.clear();
  self.forward = {};
  self.propagations = {};
  self.derived = {};
  self.selfs = {};
  self.groups = {};
  self.nominals = {};
  enqueue(context);
}

void Saturation::add_link(std::uint32_t from, RoleId role, std::uint32_t to) {
  Context& target = contexts_[to];
  if (contexts_[from].is_unsatisfiable || !target.backward.insert({role, from})) return;
  ++conclusions_;
  ++links_;
  enqueue(to);
  if (keeps_forward_ || index_.roles().is_second(role) || index_.may_be_functional(role)) {
    contexts_[from].forward.push_back({role, to});
    enqueue(from);
  }
}

void Saturation::process_backward(std::uint32_t context, Link link) {
  Context& self = contexts_[context];

  //  C -R-> D   D < E
  //  ---------------- [S some E occurs negatively, R <* S]; here the first premise is new
  //  C < S some E
  for (const ExistentialRule& rule : self.propagations) {
    if (index_.roles().is_sub_role(link.role, rule.role)) add_subsumer(link.context, rule.existential);
  }

  //  C -R-> D   D -S-> E
  //  ------------------- [R o S SubPropertyOf R']; here the first premise is new
  //  C -R'-> E
  if (!index_.roles().compositions(link.role).empty()) {
    for (std::uint32_t at = 0; at < self.forward_done; ++at) {
      const Link next = self.forward[at];
      compose(link.context, link.role, next.role, next.context);
    }
  }
}

void Saturation::process_forward(std::uint32_t context, Link link) {
  //  C -R-> D   D -S-> E
  //  ------------------- [R o S SubPropertyOf R']; here the second premise is new
  //  C -R'-> E
  Context& self = contexts_[context];
  if (index_.roles().is_second(link.role)) {
    for (std::uint32_t at = 0; at < self.backward_done; ++at) {
      const Link before = self.backward[at];
      compose(before.context, before.role, link.role, link.context);
    }
  }
  if (index_.may_be_functional(link.role)) process_functional(context, link);
  if (self.is_nonempty) require_nonempty(link.context);
  if (index_.has_nominals() && index_.has_negative_self()) find_self_of_link(context, link.role, link.context);
}

void Saturation::compose(std::uint32_t from, RoleId first, RoleId second, std::uint32_t to) {
  const auto rules = index_.roles().compositions(first);
  for (auto rule = std::ranges::lower_bound(rules, second, {}, &Composition::second);
       rule != rules.end() && rule->second == second; ++rule) {
    add_link(from, rule->result, to);
  }
}

}  // namespace geminga::el
