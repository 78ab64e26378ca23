// The daemon link's reactor, driven by the thread of Asio.
#ifndef GEMINGA_WEB_SERVER_EVENT_LOOP_HPP
#define GEMINGA_WEB_SERVER_EVENT_LOOP_HPP

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>

#include "client/channels/reactor.hpp"

namespace geminga::web {

/// Calls Reactor::process() whenever there is something to do, on the context's thread. Neither copies nor moves; the
/// reactor must outlive it, and it must outlive the context's last run.
class EventLoop {
 public:
  EventLoop(boost::asio::io_context& context, client::Reactor& reactor);
  ~EventLoop() { ready_.release(); }  // the descriptor is the reactor's
  EventLoop(const EventLoop&) = delete;
  EventLoop& operator=(const EventLoop&) = delete;

 private:
  void wait();

  client::Reactor& reactor_;
  boost::asio::posix::stream_descriptor ready_;
};

}  // namespace geminga::web

#endif
