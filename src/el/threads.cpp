// Sharing of work: each worker has a queue of its own that nobody else sees. When somebody is idle, it lays the older
// half of it on its shelf, where others may take it.
#include "el/threads.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <thread>

namespace geminga::el {
namespace {

/// What others may take of one worker. The only lock that the threads have between them, and taken only where one of
/// them has nothing to do.
struct Shelf {
  std::mutex mutex;
  std::vector<std::uint32_t> contexts;
  std::atomic<bool> is_empty = true;
};

class Team {
 public:
  Team(Saturating& shared, std::vector<std::unique_ptr<Worker>>& workers)
      : shared_(shared), workers_(workers), shelves_(workers.size()) {}

  void run() {
    std::vector<std::jthread> threads;
    for (std::size_t me = 1; me < workers_.size(); ++me) threads.emplace_back([this, me] { work(me); });
    work(0);
  }

 private:
  /// Conclusions are counted together only now and then.
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
    } while (!is_done() && (take(me, me, false) || wait_for_work(me)));
    is_done_ = true;
    ring();
  }

  [[nodiscard]] bool is_done() const { return is_done_.load(std::memory_order_relaxed) || shared_.has_ended(); }

  void share(std::size_t me) {
    std::vector<std::uint32_t>& queue = workers_[me]->queue();
    if (queue.size() < 2 || !shelves_[me].is_empty.load(std::memory_order_relaxed)) return;
    {
      const std::scoped_lock lock(shelves_[me].mutex);
      const auto middle = queue.begin() + static_cast<std::ptrdiff_t>(queue.size() / 2);
      shelves_[me].contexts.assign(queue.begin(), middle);
      for (const std::uint32_t context : shelves_[me].contexts) set_owner(context, 0);
      queue.erase(queue.begin(), middle);
      shelves_[me].is_empty = false;
    }
    ring();
  }

  /// Who was idle counts as busy before others see that the shelf is empty: so where all are idle, nothing is left.
  bool take(std::size_t me, std::size_t from, bool was_idle) {
    if (shelves_[from].is_empty.load()) return false;
    const std::scoped_lock lock(shelves_[from].mutex);
    std::vector<std::uint32_t>& shelf = shelves_[from].contexts;
    if (shelf.empty()) return false;
    if (was_idle) --idle_;
    // From another's shelf a half, so that a third has something to take, too.
    const std::size_t count = me == from ? shelf.size() : (shelf.size() + 1) / 2;
    const auto first = shelf.end() - static_cast<std::ptrdiff_t>(count);
    workers_[me]->queue().assign(first, shelf.end());
    for (const std::uint32_t context : workers_[me]->queue()) set_owner(context, workers_[me]->rank());
    shelf.erase(first, shelf.end());
    shelves_[from].is_empty = shelf.empty();
    return true;
  }

  /// False where the work is done.
  bool wait_for_work(std::size_t me) {
    ++idle_;
    for (;;) {
      const std::uint32_t heard = bell_.load();
      for (std::size_t other = 0; other < workers_.size(); ++other) {
        if (other != me && take(me, other, true)) return true;
      }
      if (is_done() || idle_.load() == workers_.size()) return false;
      bell_.wait(heard);
    }
  }

  void set_owner(std::uint32_t context, std::uint8_t number) {
    shared_.contexts[context].owner.store(number, std::memory_order_relaxed);
  }

  void ring() {
    ++bell_;
    bell_.notify_all();
  }

  Saturating& shared_;
  std::vector<std::unique_ptr<Worker>>& workers_;
  std::vector<Shelf> shelves_;
  std::atomic<std::size_t> idle_ = 0;
  std::atomic<std::size_t> conclusions_ = 0;
  std::atomic<std::uint32_t> bell_ = 0;
  std::atomic<bool> is_done_ = false;
};

}  // namespace

void run_together(Saturating& shared, std::vector<std::unique_ptr<Worker>>& workers, unsigned threads) {
  while (workers.size() < threads) {
    workers.push_back(std::make_unique<Worker>(shared, static_cast<std::uint8_t>(workers.size() + 1)));
  }
  for (const auto& worker : workers) worker->set_parallel(true);
  for (const auto& worker : workers) {
    for (const std::uint32_t context : worker->queue()) {
      shared.contexts[context].inbox = being_worked_on();
      shared.contexts[context].owner = worker->rank();
      shared.contexts[context].is_queued = false;
    }
  }
  Team(shared, workers).run();
  for (const auto& worker : workers) worker->set_parallel(false);
}

}  // namespace geminga::el
