#include "daemon/ontology/background.hpp"

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace geminga::daemon {

namespace net = boost::asio;

/// The thread's return to the event loop, for as long as its owner lives.
struct Background::Return {
  std::mutex mutex;
  net::io_context* context = nullptr;  ///< null once the owner is gone; guarded by the mutex
  Background* owner = nullptr;         ///< null once it is gone; used by the event loop alone
  /// Keeps the loop from ending while the thread works; used by the event loop alone.
  std::optional<net::executor_work_guard<net::io_context::executor_type>> guard;

  static void post(const std::shared_ptr<Return>& back, std::uint64_t number, After after) {
    const std::scoped_lock lock(back->mutex);
    if (back->context == nullptr) return;
    net::post(*back->context, [back, number, after = std::move(after)] {
      if (back->owner != nullptr) back->owner->finish(number, after);
    });
  }
};

Background::Background(boost::asio::io_context& context) : return_(std::make_shared<Return>()) {
  return_->context = &context;
  return_->owner = this;
}

Background::~Background() {
  const std::scoped_lock lock(return_->mutex);
  return_->context = nullptr;
  return_->owner = nullptr;
  return_->guard.reset();
}

void Background::start(Work work) {
  wanted_ = Wanted{std::move(work), ++last_number_};
  if (!is_at_work_) set_to_work();
}

void Background::cancel() { wanted_.reset(); }

void Background::set_to_work() {
  is_at_work_ = true;
  return_->guard.emplace(return_->context->get_executor());
  auto all = [back = return_, work = wanted_->work, number = wanted_->number] { Return::post(back, number, work()); };
  try {
    std::thread(all).detach();
  } catch (const std::system_error&) {
    all();  // The host has no thread left: the event loop waits this once.
  }
}

void Background::finish(std::uint64_t number, const After& after) {
  is_at_work_ = false;
  return_->guard.reset();
  if (!wanted_) return;
  if (wanted_->number != number) return set_to_work();
  wanted_.reset();
  after();
}

}  // namespace geminga::daemon
