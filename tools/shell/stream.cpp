#include "shell/stream.hpp"

#include <algorithm>
#include <iostream>

#include "shell/report.hpp"

namespace geminga::shell {
namespace {

using Clock = std::chrono::steady_clock;

/// Between two attempts to reach a daemon that went: as long as gemingad's own announcements are apart.
constexpr std::chrono::milliseconds between_attempts{1000};

class Runner {
 public:
  Runner(const Stream& stream, EventView& view) : stream_(stream), view_(view), begin_(Clock::now()) {}

  ExitStatus run() {
    while (true) {
      auto client = Client::connect(stream_.connection);
      if (client) {
        was_connected_ = true;
        view_.doubt();
        if (auto begun = stream_.begin(*client); !begun) {
          if (!is_gone(begun.error())) return report(stream_.program, begun.error());
          client = std::unexpected(begun.error());
        }
      }
      const ClientError lost = client ? follow(*client) : client.error();
      if (end_) return *end_;
      // Only a daemon that was there once is waited for: a wrong address is told at once.
      if (!stream_.is_kept || !was_connected_ || !is_gone(lost)) return report(stream_.program, lost);
      complain(stream_.program, lost.text + "; trying again");
      const auto left = time_left();
      const auto pause = left ? std::min(*left, between_attempts) : between_attempts;
      if (signals_.wait(-1, pause) == StopSignals::Woken::stopped) return ExitStatus::found;
      if (left && *left <= between_attempts) return timed_out();
    }
  }

 private:
  static bool is_gone(const ClientError& error) {
    return error.kind == ClientError::Kind::closed || error.kind == ClientError::Kind::unreachable ||
           (error.kind == ClientError::Kind::refused && error.code == ErrorCode::not_ready);
  }

  [[nodiscard]] std::optional<std::chrono::milliseconds> time_left() const {
    if (!stream_.timeout) return std::nullopt;
    const auto gone = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begin_);
    return std::max(*stream_.timeout - gone, std::chrono::milliseconds(0));
  }

  [[nodiscard]] ExitStatus timed_out() const {
    return events_ > 0 && stream_.count == 0 ? ExitStatus::found : ExitStatus::timed_out;
  }

  /// Counts an event; whether it was the last one.
  bool is_last() { return ++events_ == stream_.count; }

  /// Tells events until end_ is set, or until the daemon goes.
  ClientError follow(Client& client) {
    // Each request has been answered by a pong, so the events that are true at this moment are there already.
    bool is_settled = false;
    while (true) {
      auto event = client.poll();
      if (!event) return event.error();
      if (*event) {
        if (view_.tell(**event) && is_last()) return end(ExitStatus::found);
        if (!std::cout) return end(ExitStatus::wrong_use);
        continue;
      }
      while (!is_settled && view_.drop_doubted()) {
        if (is_last()) return end(ExitStatus::found);
      }
      is_settled = true;
      switch (signals_.wait(client.file_descriptor(), time_left())) {
        case StopSignals::Woken::stopped:
          return end(ExitStatus::found);
        case StopSignals::Woken::timed_out:
          return end(timed_out());
        case StopSignals::Woken::readable:
          break;
      }
    }
  }

  ClientError end(ExitStatus status) {
    end_ = status;
    return {};
  }

  const Stream& stream_;
  EventView& view_;
  Clock::time_point begin_;
  StopSignals signals_;
  std::uint64_t events_ = 0;
  bool was_connected_ = false;
  std::optional<ExitStatus> end_;
};

}  // namespace

ExitStatus run(const Stream& stream, EventView& view) { return written(stream.program, Runner(stream, view).run()); }

}  // namespace geminga::shell
