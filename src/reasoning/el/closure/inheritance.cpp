// Workers for the nodes, one or a team of them.
#include "reasoning/el/closure/inheritance.hpp"

#include <algorithm>

#include "base/parallel/threads.hpp"
#include "reasoning/el/closure/inheritance_worker.hpp"
#include "reasoning/el/closure/ranges.hpp"

namespace geminga::el {

Inheritance::Inheritance(const IndexedOntology& index, const SaturationLimits& limits, std::span<const ExprId> asked)
    : shared_(index, limits, asked) {
  workers_.push_back(std::make_unique<InheritanceWorker>(shared_, std::uint8_t{1}));
  shared_.contexts[workers_.front()->require(top_expr)].is_nonempty = true;
}

Inheritance::~Inheritance() = default;

bool Inheritance::run(unsigned threads) {
  if (threads <= 1) {
    workers_.front()->run_alone();
  } else {
    parallel::run_together(shared_, workers_, std::min(threads, parallel::max_threads));
  }
  return !shared_.is_over_limit;
}

bool Inheritance::has_ranges(std::span<const OpenRange> ranges) {
  return RangeTest(shared_, *workers_.front(), ranges).passes();
}

std::size_t Inheritance::conclusion_count() const {
  std::size_t count = 0;
  for (const auto& worker : workers_) count += worker->conclusion_count();
  return count;
}

std::size_t Inheritance::link_count() const {
  std::size_t count = 0;
  for (const auto& worker : workers_) count += worker->link_count();
  return count;
}

}  // namespace geminga::el
