#include "reasoning/dl/consequence/saturation.hpp"

#include <mutex>

#include "base/parallel/crew.hpp"
#include "reasoning/dl/consequence/worker.hpp"

namespace geminga::consequence {
namespace {

[[nodiscard]] std::uint64_t hash_of(const ContextKey& key) {
  std::uint64_t hash = (key.function * std::uint64_t{2} + (key.is_value ? 1 : 0)) * 0x9e3779b97f4a7c15ULL;
  for (const Literal literal : key.core) hash = (hash ^ hash_of(literal)) * 0xff51afd7ed558ccdULL;
  return hash ^ (hash >> 33);
}

}  // namespace

Saturation::Saturation(const Rules& rules, std::span<const std::uint32_t> wanted, const SaturationLimits& limits)
    : rules_(rules), is_wanted_(rules.vocabulary().predicate_count), limits_(limits), stacks_(1) {
  for (const std::uint32_t predicate : wanted) is_wanted_[predicate] = true;
}

Context& Saturation::context_for(ContextKey&& key, unsigned worker) {
  const std::uint64_t hash = hash_of(key);
  Part& part = parts_[hash % parts];
  Context* made = nullptr;
  {
    const std::lock_guard guard(part.lock);
    if ((part.contexts.size() + 1) * 4 > part.slots.size() * 3) {
      part.slots.assign(part.slots.empty() ? 16 : part.slots.size() * 2, 0);
      for (std::uint32_t position = 1; position <= part.contexts.size(); ++position) {
        std::size_t at = (hash_of(part.contexts[position - 1]->key) / parts) & (part.slots.size() - 1);
        while (part.slots[at] != 0) at = (at + 1) & (part.slots.size() - 1);
        part.slots[at] = position;
      }
    }
    std::size_t at = (hash / parts) & (part.slots.size() - 1);
    for (; part.slots[at] != 0; at = (at + 1) & (part.slots.size() - 1)) {
      Context& found = *part.contexts[part.slots[at] - 1];
      if (found.key == key) return found;
    }
    made = part.contexts.emplace_back(std::make_unique<Context>()).get();
    part.slots[at] = static_cast<std::uint32_t>(part.contexts.size());
    made->number = static_cast<std::uint32_t>(context_count_.fetch_add(1, std::memory_order_relaxed));
    made->key = std::move(key);
    const auto& core = made->key.core;
    made->answers_queries =
        made->key.function == ContextKey{}.function && !made->key.is_value &&
        (core.empty() || (core.size() == 1 && core[0].kind() == LiteralKind::unary && is_wanted_[core[0].predicate()]));
  }
  post(*made, MessageKind::start, nullptr, x_term, {}, {}, worker);
  return *made;
}

const Context* Saturation::find(const ContextKey& key) const {
  const std::uint64_t hash = hash_of(key);
  const Part& part = parts_[hash % parts];
  if (part.slots.empty()) return nullptr;
  for (std::size_t at = (hash / parts) & (part.slots.size() - 1); part.slots[at] != 0;
       at = (at + 1) & (part.slots.size() - 1)) {
    const Context& found = *part.contexts[part.slots[at] - 1];
    if (found.key == key) return &found;
  }
  return nullptr;
}

void Saturation::post(Context& to, MessageKind kind, const Context* from, Term f, std::span<const Literal> body,
                      std::span<const Literal> head, unsigned worker) {
  if (waiting_.fetch_add(1, std::memory_order_relaxed) >= max_messages()) {
    is_flooded_.store(true, std::memory_order_relaxed);
    return give_up();
  }
  {
    const std::lock_guard guard(to.lock);
    to.mailbox.push_back({kind, f, const_cast<Context*>(from), static_cast<std::uint32_t>(body.size()),
                          static_cast<std::uint32_t>(head.size())});
    to.mailbox_literals.insert(to.mailbox_literals.end(), body.begin(), body.end());
    to.mailbox_literals.insert(to.mailbox_literals.end(), head.begin(), head.end());
    if (to.is_scheduled) return;
    to.is_scheduled = true;
  }
  schedule(to, worker);
}

void Saturation::schedule(Context& context, unsigned worker) {
  scheduled_.fetch_add(1, std::memory_order_relaxed);
  {
    Stack& stack = stacks_[worker];
    const std::lock_guard guard(stack.lock);
    stack.contexts.push_back(&context);
  }
  if (stacks_.size() == 1) return;
  epoch_.fetch_add(1);
  if (sleepers_.load() > 0) epoch_.notify_one();
}

Context* Saturation::take(unsigned worker) {
  for (std::size_t i = 0; i < stacks_.size(); ++i) {
    Stack& stack = stacks_[(worker + i) % stacks_.size()];
    const std::lock_guard guard(stack.lock);
    if (stack.contexts.empty()) continue;
    Context* const taken = stack.contexts.back();
    stack.contexts.pop_back();
    return taken;
  }
  return nullptr;
}

void Saturation::work(unsigned worker) {
  const ArenaUse use(stacks_[worker].arena);
  Worker works(*this, worker);
  while (true) {
    const std::uint32_t epoch = epoch_.load();
    if (is_abandoned_.load()) break;
    if (Context* const context = take(worker); context != nullptr) {
      works.work(*context);
      // Contexts that this one has scheduled were counted before the count falls, so it is 0 only at the end.
      if (scheduled_.fetch_sub(1, std::memory_order_acq_rel) == 1) break;
      continue;
    }
    if (scheduled_.load(std::memory_order_acquire) == 0) break;
    sleepers_.fetch_add(1);
    epoch_.wait(epoch);
    sleepers_.fetch_sub(1);
  }
  wake_all();
}

void Saturation::wake_all() {
  epoch_.fetch_add(1);
  epoch_.notify_all();
}

void Saturation::run(unsigned threads) {
  parallel::Crew crew(threads);
  while (stacks_.size() < crew.size()) stacks_.emplace_back();
  crew.run([this](unsigned worker) { work(worker); },
           [this] {
             is_abandoned_.store(true);
             give_up();
             wake_all();
           });
}

bool Saturation::count(std::size_t clauses) {
  if (clauses_.fetch_add(clauses, std::memory_order_relaxed) + clauses > limits_.clauses) give_up();
  if (limits_.budget != nullptr && !limits_.budget->spend(clauses * steps_per_clause)) give_up();
  return !is_cut_off();
}

bool Saturation::count_attempts(std::size_t attempts) {
  const std::size_t all = attempts_.fetch_add(attempts, std::memory_order_relaxed) + attempts;
  if (all / attempts_per_clause > limits_.clauses) give_up();
  if (limits_.budget != nullptr && !limits_.budget->spend(attempts)) give_up();
  return !is_cut_off();
}

}  // namespace geminga::consequence
