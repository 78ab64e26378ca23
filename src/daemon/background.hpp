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

/// There is never more than one thread. Work shares with the event loop what it was given and nothing else. It cannot
/// be stopped, and neither a reload nor the end of the daemon waits for it.
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
  /// Whether the thread is at work, even on work that was given up. Until it is done, the process must not destroy what
  /// the thread uses.
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
