// A saturation by several threads: who works on which context.
#ifndef GEMINGA_EL_THREADS_HPP
#define GEMINGA_EL_THREADS_HPP

#include <memory>
#include <vector>

#include "el/saturation.hpp"
#include "el/worker.hpp"

namespace geminga::el {

/// More are not started: each keeps memory of its own.
inline constexpr unsigned max_threads = 64;

/// Saturates with so many threads, the caller's among them. Workers are added as they are needed; those that are there
/// keep their queues. The index must have no nominals.
void run_together(Saturating& shared, std::vector<std::unique_ptr<Worker>>& workers, unsigned threads);

}  // namespace geminga::el

#endif
