// One piece of long work at a time, on a thread of its own, while the event loop serves.
#ifndef GEMINGA_DAEMON_BACKGROUND_HPP
#define GEMINGA_DAEMON_BACKGROUND_HPP

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace boost::asio {
class io_context;
}

namespace geminga::daemon {

/// Never two threads. Work shares what it was given and nothing else with the event loop, so that it can be left to
/// itself: it cannot be broken off, and neither a reload nor the end of the daemon waits for it.
class Background {
 public:
  /// What is done on the event loop when the work is done, in an event of its own.
  using After = std::function<void()>;
  /// Runs on the thread and must not throw. It may outlive everything that it does not own.
  using Work = std::function<After()>;

  /// Borrows the context for its life.
  explicit Background(boost::asio::io_context& context);
  /// What the work brings is dropped when it is done.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// What was started earlier is given up, and what it brings dropped. Begins when the thread has no other work.
  void start(Work work);
  /// Gives up what was started.
  void cancel();
  /// Whether something was started that is neither done nor given up.
  [[nodiscard]] bool is_wanted() const { return wanted_.has_value(); }
  /// Whether the thread is at work, be it for what was given up. The process must not take down then what it uses.
  [[nodiscard]] bool is_at_work() const { return is_at_work_; }

 private:
  struct Wanted {
    Work work;
    std::uint64_t number = 0;
  };
  struct Way;

  void set_to_work();
  void come_back(std::uint64_t number, const After& after);

  std::shared_ptr<Way> way_;
  std::optional<Wanted> wanted_;
  std::uint64_t last_number_ = 0;
  bool is_at_work_ = false;
};

}  // namespace geminga::daemon

#endif
