// The closure as its users see it, and how conclusions travel between contexts; what rules conclude is in
// saturation_rules.cpp.
#include "reasoning/el/saturation.hpp"

#include <algorithm>
#include <thread>

#include "base/interner.hpp"
#include "base/parallel/claim.hpp"
#include "base/parallel/threads.hpp"
#include "reasoning/el/saturation_worker.hpp"

namespace geminga::el {

Saturating::Saturating(const IndexedOntology& of, const SaturationLimits& within)
    : index(of), limits(within), keeps_forward(of.has_nominals()), context_of(of.size()) {}

Saturation::Saturation(const IndexedOntology& index, const SaturationLimits& limits) : shared_(index, limits) {
  workers_.push_back(std::make_unique<SaturationWorker>(shared_, std::uint8_t{1}));
  require_nonempty(require(top_expr));
}

Saturation::~Saturation() = default;

std::uint32_t Saturation::require(ExprId root) { return workers_.front()->require(root); }

void Saturation::conclude(std::uint32_t context, ExprId expr) { workers_.front()->conclude(context, expr); }

void Saturation::require_nonempty(std::uint32_t context) { workers_.front()->require_nonempty(context); }

const Context* Saturation::find(ExprId root) const {
  const std::uint32_t entry = shared_.context_of[number(root)];
  return entry == Saturating::no_context ? nullptr : &shared_.contexts[entry - 2];
}

bool Saturation::run(unsigned threads) {
  if (threads <= 1 || shared_.index.has_nominals()) {
    workers_.front()->run_alone();
  } else {
    parallel::run_together(shared_, workers_, std::min(threads, parallel::max_threads));
  }
  return !shared_.is_over_limit;
}

std::size_t Saturation::conclusion_count() const {
  std::size_t count = 0;
  for (const auto& worker : workers_) count += worker->conclusion_count();
  return count;
}

std::size_t Saturation::link_count() const {
  std::size_t count = 0;
  for (const auto& worker : workers_) count += worker->link_count();
  return count;
}

//   ----- (init)   -----
//   C < C          C < T
std::uint32_t SaturationWorker::require(ExprId root) {
  std::atomic<std::uint32_t>& entry = shared_.context_of[number(root)];
  std::uint32_t known = entry.load(std::memory_order_acquire);
  while (known <= Saturating::claimed_context) {
    if (known == Saturating::claimed_context) {
      std::this_thread::yield();  // another thread is making it
      known = entry.load(std::memory_order_acquire);
    } else if (entry.compare_exchange_weak(known, Saturating::claimed_context, std::memory_order_acq_rel)) {
      parallel::Claim claim(entry, Saturating::no_context);
      const std::uint32_t created = contexts_.add();
      contexts_[created].root = root;
      start(created, {{root, top_expr}});
      if (index_.is_nominal(root)) require_nonempty(created);
      claim.settle(created + 2);
      return created;
    }
  }
  return known - 2;
}

void SaturationWorker::start(std::uint32_t context, std::span<const ExprId> atoms) {
  // Nobody else knows this context yet.
  if (is_parallel_) {
    contexts_[context].mailbox.hold();
    contexts_[context].owner.store(rank_, std::memory_order_relaxed);
    queue_.push_back(context);
  }
  for (const ExprId own : atoms) {
    if (index_.is_active(own)) {
      add_subsumer(context, own);
    } else {
      for (const ExprId above : index_.frontier(own)) add_subsumer(context, above);
    }
  }
}

void SaturationWorker::run_alone() {
  while (!queue_.empty() && !shared_.has_ended()) {
    const std::uint32_t context = queue_.back();
    queue_.pop_back();
    contexts_[context].is_queued = false;
    process(context);
  }
}

void SaturationWorker::set_parallel(bool is_parallel) {
  is_parallel_ = is_parallel;
  if (!is_parallel) return;
  for (const std::uint32_t context : queue_) {
    contexts_[context].mailbox.hold();
    contexts_[context].owner = rank_;
    contexts_[context].is_queued = false;
  }
}

void SaturationWorker::work_on(std::uint32_t context) {
  Context& self = contexts_[context];
  for (;;) {
    QueuedMessage* waiting = self.mailbox.empty();
    while (waiting != nullptr) {
      QueuedMessage* next = waiting->next;
      receive(context, waiting->message);
      arena_.release(waiting, sizeof(QueuedMessage));
      waiting = next;
    }
    process(context);
    self.owner.store(0, std::memory_order_relaxed);
    if (shared_.has_ended() || self.mailbox.rest()) break;
    self.owner.store(rank_, std::memory_order_relaxed);  // a message has come
  }
}

void SaturationWorker::post(std::uint32_t context, const Message& message) {
  Context& there = contexts_[context];
  if (there.mailbox.take()) {
    there.owner.store(rank_, std::memory_order_relaxed);
    queue_.push_back(context);
    return receive(context, message);
  }
  // Saying a thing twice changes nothing, and chains conclude the same link again and again: who has said it of late
  // does not write once more.
  if (posted_.empty()) posted_.resize(posted_count);
  const std::uint64_t kind_and_context = static_cast<std::uint64_t>(message.kind) << 32 | context;
  Posted& slot = posted_[base::mixed(base::mixed(kind_and_context, message.first), message.second) % posted_count];
  if (slot.context == context && slot.message == message) return;
  slot = {context, message};
  auto* waiting = ::new (arena_.allocate(sizeof(QueuedMessage))) QueuedMessage{nullptr, message};
  if (!there.mailbox.put(waiting)) return;
  there.owner.store(rank_, std::memory_order_relaxed);  // it has come to rest meanwhile
  queue_.push_back(context);
}

void SaturationWorker::receive(std::uint32_t context, const Message& message) {
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

void SaturationWorker::enqueue(std::uint32_t context) {
  if (is_parallel_ || contexts_[context].is_queued) return;
  contexts_[context].is_queued = true;
  queue_.push_back(context);
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
    work_.add(1);
    if (conclusions_ > shared_.limits.conclusions) shared_.is_over_limit = true;
  }
}

}  // namespace geminga::el
