// The thread, and the way back from it.
#include "daemon/preparation.hpp"

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace geminga::daemon {

namespace net = boost::asio;

/// From the thread to the event loop, for as long as somebody waits there.
struct Preparation::Way {
  std::mutex mutex;
  net::io_context* context = nullptr;  ///< null once nobody waits; guarded by the mutex
  Preparation* owner = nullptr;        ///< of the event loop alone
  /// The loop does not end for want of work while the thread is at work. Of the event loop alone.
  std::optional<net::executor_work_guard<net::io_context::executor_type>> guard;

  static void bring(const std::shared_ptr<Way>& way, std::uint64_t number, Result result) {
    auto kept = std::make_shared<Result>(std::move(result));
    const std::scoped_lock lock(way->mutex);
    if (way->context == nullptr) return;
    net::post(*way->context, [way, number, kept] {
      if (way->owner != nullptr) way->owner->come_back(number, std::move(*kept));
    });
  }
};

Preparation::Preparation(boost::asio::io_context& context) : way_(std::make_shared<Way>()) {
  way_->context = &context;
  way_->owner = this;
}

Preparation::~Preparation() {
  const std::scoped_lock lock(way_->mutex);
  way_->context = nullptr;
  way_->owner = nullptr;
  way_->guard.reset();
}

void Preparation::start(std::shared_ptr<const el::Ontology> ontology, Done done) {
  wanted_ = Wanted{std::move(ontology), std::move(done), ++last_number_};
  if (!is_at_work_) set_to_work();
}

void Preparation::cancel() { wanted_.reset(); }

void Preparation::set_to_work() {
  is_at_work_ = true;
  way_->guard.emplace(way_->context->get_executor());
  // It holds the ontology on its own account: whoever started it may be gone before it is done.
  auto work = [way = way_, ontology = wanted_->ontology, number = wanted_->number] {
    Way::bring(way, number, participant::PreparedOntology::make(*ontology));
  };
  try {
    std::thread(work).detach();
  } catch (const std::system_error&) {
    work();  // The host has no thread to give: all wait this once, rather than that expressions are never answered.
  }
}

void Preparation::come_back(std::uint64_t number, Result result) {
  is_at_work_ = false;
  way_->guard.reset();
  if (!wanted_) return;
  if (wanted_->number != number) return set_to_work();
  const Wanted over = std::move(*std::exchange(wanted_, std::nullopt));
  over.done(std::move(result));
}

}  // namespace geminga::daemon
