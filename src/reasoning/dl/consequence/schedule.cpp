#include "reasoning/dl/consequence/schedule.hpp"

#include <mutex>

namespace geminga::consequence {

void Schedule::add(Context& context, unsigned thread) {
  scheduled_.fetch_add(1, std::memory_order_relaxed);
  {
    Thread& own = threads_[thread];
    const std::lock_guard guard(own.lock);
    own.contexts.push_back(&context);
  }
  if (threads_.size() == 1) return;
  epoch_.fetch_add(1);
  if (sleepers_.load() > 0) epoch_.notify_one();
}

Context* Schedule::take(unsigned thread) {
  for (std::size_t i = 0; i < threads_.size(); ++i) {
    Thread& from = threads_[(thread + i) % threads_.size()];
    const std::lock_guard guard(from.lock);
    if (from.contexts.empty()) continue;
    Context* const taken = from.contexts.back();
    from.contexts.pop_back();
    return taken;
  }
  return nullptr;
}

}  // namespace geminga::consequence
