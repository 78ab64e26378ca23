#include "client/channels/log.hpp"

#include <iostream>
#include <utility>

namespace geminga::client {

Log::Log(Reactor& reactor, Write write)
    : reactor_(reactor), write_(std::move(write)), timer_(reactor, [this] {
        was_told_ = true;
        line("no daemon at " + where_ + " for 1 s (" + reason_ +
             "): start gemingad, or say where it is with GEMINGA_CONNECT");
      }) {}

void Log::line(std::string_view text) const {
  if (write_) return write_(text);
  std::cerr << "geminga: " + std::string(text) + '\n' << std::flush;
}

void Log::on_no_daemon(const std::string& where, const std::string& reason) {
  where_ = where;
  reason_ = reason;
  if (!was_told_ && timer_.at() == base::never) timer_.set(reactor_.now() + daemon_patience);
}

void Log::on_daemon(const std::string& where) {
  timer_.set(base::never);
  if (std::exchange(was_told_, false)) line("the daemon at " + where + " answers");
}

void Log::on_refused(const Session::Stated& stated, const std::string& text) const {
  line("the request " + Session::words(stated) + " is refused: " + text);
}

}  // namespace geminga::client
