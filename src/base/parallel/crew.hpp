// A crew of threads that work on one thing. Only this file starts threads for reasoning; what one of them throws
// reaches the caller.
#ifndef GEMINGA_BASE_PARALLEL_CREW_HPP
#define GEMINGA_BASE_PARALLEL_CREW_HPP

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace geminga::parallel {

/// The caller, and threads that wait until there is something to do. Not thread-safe.
class Crew {
 public:
  /// Starts one thread less than wanted, or fewer if the system gives no more. size() counts them and the caller.
  explicit Crew(unsigned wanted);
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  ~Crew();

  [[nodiscard]] unsigned size() const { return static_cast<unsigned>(threads_.size()) + 1; }

  /// Calls `work` with each number below size(): 0 in the caller's thread, the others in their own. Returns when all
  /// have returned. If one throws, `stop` is called, which must make the others return soon and must not throw; the
  /// first exception is thrown again when all have ended. Call it once only.
  void run(const std::function<void(unsigned)>& work, const std::function<void()>& stop);

 private:
  void wait_and_work(unsigned me);
  void work_as(unsigned me);
  void join();

  std::mutex mutex_;  ///< guards the members below, except the threads
  std::condition_variable changed_;
  const std::function<void(unsigned)>* work_ = nullptr;
  const std::function<void()>* stop_ = nullptr;
  bool is_dismissed_ = false;
  std::exception_ptr thrown_;
  std::vector<std::thread> threads_;
};

}  // namespace geminga::parallel

#endif
