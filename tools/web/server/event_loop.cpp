#include "web/server/event_loop.hpp"

namespace geminga::web {

EventLoop::EventLoop(boost::asio::io_context& context, client::Reactor& reactor)
    : reactor_(reactor), ready_(context, reactor.descriptor()) {
  wait();
}

void EventLoop::wait() {
  ready_.async_wait(boost::asio::posix::stream_descriptor::wait_read, [this](const boost::system::error_code& error) {
    if (error) return;
    reactor_.process();
    wait();
  });
}

}  // namespace geminga::web
