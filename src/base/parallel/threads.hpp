// Work by several threads on contexts that know each other. Each worker has a queue of its own that no other thread
// sees. When another worker is idle, it puts the older half of it on its work queue, from which others may take.
#ifndef GEMINGA_BASE_PARALLEL_THREADS_HPP
#define GEMINGA_BASE_PARALLEL_THREADS_HPP

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "base/parallel/crew.hpp"

namespace geminga::parallel {

/// The most threads that are started: each keeps memory of its own.
inline constexpr unsigned max_threads = 64;

/// The contexts that others may take from one worker. Its lock is the only one between the threads, and is taken only
/// when one of them has nothing to do.
struct WorkQueue {
  std::mutex mutex;
  std::vector<std::uint32_t> contexts;
  std::atomic<bool> is_empty = true;
};

/// Requires that Shared has contexts by number and says when it has ended, and that Worker has a queue of them and
/// works on one.
template <typename Shared, typename Worker>
class Team {
 public:
  Team(Shared& shared, std::span<const std::unique_ptr<Worker>> workers)
      : shared_(shared), workers_(workers), work_queues_(workers.size()), seen_round_(workers.size(), 0) {}

  /// Runs all workers. Requires a crew of as many threads. An exception of one ends the work of all, and is thrown
  /// here.
  void run(Crew& crew) {
    crew.run([this](unsigned me) { work(me); }, [this] { end(); });
  }

 private:
  /// Conclusions that a worker makes before they are added to the common count.
  static constexpr std::size_t counted_at_once = std::size_t{1} << 14;

  void work(std::size_t me) {
    Worker& worker = *workers_[me];
    std::size_t counted = 0;
    do {
      while (!worker.queue().empty() && !is_done()) {
        const std::uint32_t context = worker.queue().back();
        worker.queue().pop_back();
        worker.work_on(context);
        if (idle_.load(std::memory_order_relaxed) > 0) share(me);
        if (worker.conclusion_count() - counted < counted_at_once) continue;
        const std::size_t more = worker.conclusion_count() - counted;
        counted += more;
        if (conclusions_.fetch_add(more) + more > shared_.limits.conclusions) shared_.is_over_limit = true;
      }
    } while (!is_done() && (take(me, me, false) || worker.begin_more() || take_from_any(me) || worker.release_one() ||
                            wait_for_work(me)));
    end();
  }

  void end() {
    is_done_ = true;
    wake_all();
  }

  [[nodiscard]] bool is_done() const { return is_done_.load(std::memory_order_relaxed) || shared_.has_ended(); }

  void share(std::size_t me) {
    std::vector<std::uint32_t>& queue = workers_[me]->queue();
    if (queue.size() < 2 || !work_queues_[me].is_empty.load(std::memory_order_relaxed)) return;
    {
      const std::scoped_lock lock(work_queues_[me].mutex);
      const auto middle = queue.begin() + static_cast<std::ptrdiff_t>(queue.size() / 2);
      work_queues_[me].contexts.assign(queue.begin(), middle);
      for (const std::uint32_t context : work_queues_[me].contexts) set_owner(context, 0);
      queue.erase(queue.begin(), middle);
      work_queues_[me].is_empty = false;
    }
    wake_all();
  }

  /// Takes contexts from a work queue. An idle thread counts as busy before others see the queue empty, so if all are
  /// idle nothing is left.
  bool take(std::size_t me, std::size_t from, bool was_idle) {
    if (work_queues_[from].is_empty.load()) return false;
    const std::scoped_lock lock(work_queues_[from].mutex);
    std::vector<std::uint32_t>& work_queue = work_queues_[from].contexts;
    if (work_queue.empty()) return false;
    if (was_idle) --idle_;
    // From another's work queue only half is taken, so that a third thread finds something, too.
    const std::size_t count = me == from ? work_queue.size() : (work_queue.size() + 1) / 2;
    const auto first = work_queue.end() - static_cast<std::ptrdiff_t>(count);
    workers_[me]->queue().assign(first, work_queue.end());
    for (const std::uint32_t context : workers_[me]->queue()) set_owner(context, workers_[me]->rank());
    work_queue.erase(first, work_queue.end());
    work_queues_[from].is_empty = work_queue.empty();
    return true;
  }

  bool take_from_any(std::size_t me) {
    for (std::size_t other = 0; other < workers_.size(); ++other) {
      if (other != me && take(me, other, false)) return true;
    }
    return false;
  }

  /// Waits for work. Returns false if all work is done.
  bool wait_for_work(std::size_t me) {
    ++idle_;
    for (;;) {
      const std::uint32_t seen = wake_ups_.load();
      for (std::size_t other = 0; other < workers_.size(); ++other) {
        if (other != me && take(me, other, true)) return true;
      }
      if (is_done()) return false;
      if (idle_.load() == workers_.size()) {
        // All are idle. The thread that gets the lock begins the next round.
        const std::scoped_lock lock(rounds_);
        if (idle_.load() != workers_.size()) continue;
        if (!workers_[me]->begin_round()) return false;
        ++round_;
        --idle_;
        wake_all();
        return true;
      }
      // A thread that comes too late for a round finds nothing, and stays idle.
      if (const std::uint32_t round = round_.load(); round != seen_round_[me]) {
        seen_round_[me] = round;
        --idle_;
        if (workers_[me]->begin_more()) return true;
        ++idle_;
        continue;
      }
      wake_ups_.wait(seen);
    }
  }

  void set_owner(std::uint32_t context, std::uint8_t number) {
    shared_.contexts[context].owner.store(number, std::memory_order_relaxed);
  }

  void wake_all() {
    ++wake_ups_;
    wake_ups_.notify_all();
  }

  Shared& shared_;
  std::span<const std::unique_ptr<Worker>> workers_;
  std::vector<WorkQueue> work_queues_;
  std::atomic<std::size_t> idle_ = 0;
  std::atomic<std::size_t> conclusions_ = 0;
  std::atomic<std::uint32_t> wake_ups_ = 0;
  std::atomic<bool> is_done_ = false;
  std::mutex rounds_;  ///< its holder begins the next round
  std::atomic<std::uint32_t> round_ = 0;
  std::vector<std::uint32_t> seen_round_;
};

/// Works with so many threads, the caller's among them, or with fewer if the system gives no more. Adds workers as
/// needed. An exception of a thread is thrown here when all have ended; the shared object is then of no use.
template <typename Shared, typename Worker>
void run_together(Shared& shared, std::vector<std::unique_ptr<Worker>>& workers, unsigned threads) {
  Crew crew(threads);
  while (workers.size() < crew.size()) {
    workers.push_back(std::make_unique<Worker>(shared, static_cast<std::uint8_t>(workers.size() + 1)));
  }
  const std::span<const std::unique_ptr<Worker>> working(workers.begin(), crew.size());
  for (const auto& worker : working) worker->set_parallel(true);
  Team<Shared, Worker>(shared, working).run(crew);
  for (const auto& worker : working) worker->set_parallel(false);
}

}  // namespace geminga::parallel

#endif
