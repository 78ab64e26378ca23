// Workers for the contexts, one or a team of them.
#include "reasoning/el/closure/saturation.hpp"

#include <algorithm>

#include "base/parallel/threads.hpp"
#include "reasoning/el/closure/saturation_worker.hpp"

namespace geminga::el {

Saturation::Saturation(const IndexedOntology& index, const SaturationLimits& limits) : shared_(index, limits) {
  workers_.push_back(std::make_unique<SaturationWorker>(shared_, std::uint8_t{1}));
  require_nonempty(require(top_expr));
}

Saturation::~Saturation() = default;

std::uint32_t Saturation::require(ExprId root) { return workers_.front()->require(root); }

void Saturation::conclude(std::uint32_t context, ExprId expr) { workers_.front()->add_subsumer(context, expr); }

void Saturation::require_nonempty(std::uint32_t context) { workers_.front()->require_nonempty(context); }

const Context* Saturation::find(ExprId root) const {
  const std::uint32_t entry = shared_.context_of[number(root)];
  return entry == SharedContexts::no_context ? nullptr : &shared_.contexts[entry - 2];
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

}  // namespace geminga::el
