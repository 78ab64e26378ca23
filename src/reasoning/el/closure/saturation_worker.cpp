// The rules by the premise that is new; the rules themselves are in rules.hpp, nominal_rules.cpp and
// universal_rules.cpp. The legend is in saturation.hpp.
#include "reasoning/el/closure/saturation_worker.hpp"

namespace geminga::el {

void SaturationWorker::run_alone() {
  queue_.run_alone([this](std::uint32_t context) { process(context); }, [this] { return shared_.has_ended(); });
}

void SaturationWorker::work_on(std::uint32_t context) {
  queue_.work_on(
      context, [&](QueuedMessage* waiting) { read(context, waiting); }, [this](std::uint32_t held) { process(held); },
      [this] { return shared_.has_ended(); });
}

void SaturationWorker::process(std::uint32_t context) {
  Context& self = contexts_[context];
  while (!shared_.has_ended()) {
    if (self.is_unsatisfiable) {
      if (self.backward_done == self.backward.size()) break;
      add_bottom(self.backward[self.backward_done++].context);
    } else if (self.subsumers_done < self.subsumers.size()) {
      const std::uint32_t subsumer = self.subsumers[self.subsumers_done++];
      if (subsumer < index_.size()) process_subsumer(context, ExprId{subsumer});
    } else if (self.backward_done < self.backward.size()) {
      process_backward(context, self.backward[self.backward_done++]);
    } else if (self.firsts_done < self.firsts.size()) {
      process_first(context, self.firsts[self.firsts_done++]);
    } else if (self.forward_done < self.forward.size()) {
      process_forward(context, self.forward[self.forward_done++]);
    } else if (self.selfs_done < self.selfs.size()) {
      apply_self(context, self.selfs[self.selfs_done++]);
    } else {
      break;
    }
    count_work(1);
    if (conclusion_count() > shared_.limits.conclusions) shared_.is_over_limit = true;
  }
}

void SaturationWorker::process_subsumer(std::uint32_t context, ExprId subsumer) {
  apply(context, subsumer);
  const Context& self = contexts_[context];
  if (self.is_unsatisfiable) return;
  if (index_.has_rules(subsumer, RuleBits::functional)) apply_functional(context, subsumer);
  if (index_.has_universals() && !self.is_unsatisfiable) universals_.apply(context, subsumer);
  if (index_.has_nominals() && !self.is_unsatisfiable) nominals_.apply(context, subsumer);
}

// The second premise of propagate() is new.
void SaturationWorker::add_filler(std::uint32_t context, ExprId subsumer) {
  Context& self = contexts_[context];
  self.propagating.push_back(subsumer, arena_);
  count_work(self.backward_done);
  for (std::uint32_t at = 0; at < self.backward_done; ++at) propagate(self.backward[at], subsumer);
}

// The first premise of propagate() is new.
void SaturationWorker::process_backward(std::uint32_t context, Link link) {
  Context& self = contexts_[context];
  count_work(self.propagating.size());
  for (std::uint32_t at = 0; at < self.propagating.size(); ++at) propagate(link, self.propagating[at]);
}

// The first premise of compose() is new. A link that is composed of two links of a transitive role is no first premise:
// its own first part is one. So a path of n links is walked n times and not n * n times.
void SaturationWorker::process_first(std::uint32_t context, Link link) {
  Context& self = contexts_[context];
  count_work(self.forward_done);
  for (std::uint32_t at = 0; at < self.forward_done; ++at) {
    const Link next = self.forward[at];
    compose(link.context, link.role, next.role, next.context);
  }
}

// The second premise of compose() is new, or the link is one of a functional property.
void SaturationWorker::process_forward(std::uint32_t context, Link link) {
  Context& self = contexts_[context];
  if (index_.roles().is_second(link.role)) {
    count_work(self.firsts_done);
    for (std::uint32_t at = 0; at < self.firsts_done; ++at) {
      const Link before = self.firsts[at];
      compose(before.context, before.role, link.role, link.context);
    }
  }
  if (index_.may_be_functional(link.role)) functional_link(context, link);
  if (index_.has_nominals()) nominals_.apply_to_link(context, link.role, link.context);
}

void SaturationWorker::add_loop(std::uint32_t context, RoleId role) {
  add_link(context, role, context);
  if (index_.has_universals()) universals_.apply_to_self(context, role);
  for (const RoleId super : index_.roles().supers(role)) {
    if (index_.may_be_functional(super)) functional_self(context, super);
  }
}

}  // namespace geminga::el
