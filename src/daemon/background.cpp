// The thread, and the way back from it.
#include "daemon/background.hpp"

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace geminga::daemon {

namespace net = boost::asio;

/// How the thread reaches the event loop, as long as somebody waits there.
struct Background::Way {
  std::mutex mutex;
  net::io_context* context = nullptr;  ///< null once nobody waits; guarded by the mutex
  Background* owner = nullptr;         ///< of the event loop alone
  /// Keeps the loop from ending while the thread works; used by the event loop alone
  std::optional<net::executor_work_guard<net::io_context::executor_type>> guard;

  static void bring(const std::shared_ptr<Way>& way, std::uint64_t number, After after) {
    const std::scoped_lock lock(way->mutex);
    if (way->context == nullptr) return;
    net::post(*way->context, [way, number, after = std::move(after)] {
      if (way->owner != nullptr) way->owner->come_back(number, after);
    });
  }
};

Background::Background(boost::asio::io_context& context) : way_(std::make_shared<Way>()) {
  way_->context = &context;
  way_->owner = this;
}

Background::~Background() {
  const std::scoped_lock lock(way_->mutex);
  way_->context = nullptr;
  way_->owner = nullptr;
  way_->guard.reset();
}

void Background::start(Work work) {
  wanted_ = Wanted{std::move(work), ++last_number_};
  if (!is_at_work_) set_to_work();
}

void Background::cancel() { wanted_.reset(); }

void Background::set_to_work() {
  is_at_work_ = true;
  way_->guard.emplace(way_->context->get_executor());
  auto all = [way = way_, work = wanted_->work, number = wanted_->number] { Way::bring(way, number, work()); };
  try {
    std::thread(all).detach();
  } catch (const std::system_error&) {
    all();  // The host has no thread left. Better that all wait this once than that the work is never done.
  }
}

void Background::come_back(std::uint64_t number, const After& after) {
  is_at_work_ = false;
  way_->guard.reset();
  if (!wanted_) return;
  if (wanted_->number != number) return set_to_work();
  wanted_.reset();
  after();
}

}  // namespace geminga::daemon
