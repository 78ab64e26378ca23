// One piece of long work at a time on a thread of its own, while the event loop serves.
#ifndef GEMINGA_DAEMON_ONTOLOGY_BACKGROUND_HPP
#define GEMINGA_DAEMON_ONTOLOGY_BACKGROUND_HPP

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace boost::asio {
class io_context;
}

namespace geminga::daemon {

/// Runs at most one thread. Work shares with the event loop only what it was given. It cannot be stopped, and neither a
/// reload nor the end of the daemon waits for it.
class Background {
 public:
  /// Runs on the event loop after the work, in an event of its own.
  using After = std::function<void()>;
  /// Runs on the thread and must not throw. Work may outlive everything that it does not own.
  using Work = std::function<After()>;

  /// Borrows the context for its life.
  explicit Background(boost::asio::io_context& context);
  /// Drops the result of work that is under way.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Begins the work when the thread has no other. Earlier work is given up, and its result dropped.
  void start(Work work);
  /// Gives up the work.
  void cancel();
  /// Whether there is work that is neither done nor given up.
  [[nodiscard]] bool is_wanted() const { return wanted_.has_value(); }
  /// Whether the thread is at work, even on work that was given up. Until it is done, the process must not destroy what
  /// the thread uses.
  [[nodiscard]] bool is_at_work() const { return is_at_work_; }

 private:
  struct Wanted {
    Work work;
    std::uint64_t number = 0;
  };
  struct Return;

  void set_to_work();
  void finish(std::uint64_t number, const After& after);

  std::shared_ptr<Return> return_;  ///< shared with the thread
  std::optional<Wanted> wanted_;
  std::uint64_t last_number_ = 0;
  bool is_at_work_ = false;
};

}  // namespace geminga::daemon

#endif
