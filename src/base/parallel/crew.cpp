// Threads wait at a gate, so that the caller knows how many there are before the first begins.
#include "base/parallel/crew.hpp"

#include <new>
#include <system_error>
#include <utility>

namespace geminga::parallel {

Crew::Crew(unsigned wanted) {
  try {
    if (wanted > 1) threads_.reserve(wanted - 1);
    for (unsigned me = 1; me < wanted; ++me) threads_.emplace_back([this, me] { wait_and_work(me); });
  } catch (const std::system_error&) {  // fewer are enough
  } catch (const std::bad_alloc&) {     // here, too
  }
}

Crew::~Crew() { join(); }

void Crew::run(const std::function<void(unsigned)>& work, const std::function<void()>& stop) {
  {
    const std::lock_guard lock(mutex_);
    work_ = &work;
    stop_ = &stop;
  }
  changed_.notify_all();
  work_as(0);
  join();
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

void Crew::wait_and_work(unsigned me) {
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return work_ != nullptr || is_dismissed_; });
    if (work_ == nullptr) return;
  }
  work_as(me);
}

void Crew::work_as(unsigned me) {
  try {
    (*work_)(me);
  } catch (...) {
    {
      const std::lock_guard lock(mutex_);
      if (!thrown_) thrown_ = std::current_exception();
    }
    (*stop_)();
  }
}

void Crew::join() {
  {
    const std::lock_guard lock(mutex_);
    is_dismissed_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) {
    if (thread.joinable()) thread.join();
  }
}

}  // namespace geminga::parallel
