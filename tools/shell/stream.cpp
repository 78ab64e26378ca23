#include "shell/stream.hpp"

#include <algorithm>
#include <csignal>
#include <iostream>

#include "shell/report.hpp"
#include "shell/stop_signals.hpp"

namespace geminga::shell {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

/// The pause between two attempts to reach a daemon that went: the interval of gemingad's announcements.
constexpr milliseconds between_attempts{1000};

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
      // A daemon that was never reached is an error at once: its address may be wrong.
      if (!stream_.is_kept || !was_connected_ || !is_gone(lost)) return report(stream_.program, lost);
      complain(stream_.program, lost.text + "; trying again");
      if (!pause()) return *end_;
    }
  }

  /// Lets the commands end, or ends them, after run() has returned `status`.
  ExitStatus finish(ExitStatus status) {
    if (stream_.commands == nullptr) return status;
    let_commands_end();
    if (ending_signal_ != 0) stream_.commands->stop(ending_signal_);
    return is_out_of_time_ && status == ExitStatus::found ? timed_out() : status;
  }

 private:
  static bool is_gone(const ClientError& error) {
    return error.kind == ClientError::Kind::closed || error.kind == ClientError::Kind::unreachable ||
           (error.kind == ClientError::Kind::refused && error.code == ErrorCode::not_ready);
  }

  [[nodiscard]] std::optional<milliseconds> time_left() const {
    if (!stream_.timeout) return std::nullopt;
    return std::max(*stream_.timeout - std::chrono::duration_cast<milliseconds>(Clock::now() - begin_),
                    milliseconds(0));
  }

  [[nodiscard]] ExitStatus timed_out() const {
    return events_ > 0 && stream_.count == 0 ? ExitStatus::found : ExitStatus::timed_out;
  }

  /// Counts an event. True: it was the last one.
  bool is_last() { return ++events_ == stream_.count; }

  [[nodiscard]] bool has_room() const { return stream_.commands == nullptr || stream_.commands->has_room(); }

  /// Waits at most so long for the descriptor (-1: none), for a command that ends, or for the end of the program, which
  /// sets end_.
  void wait(int descriptor, std::optional<milliseconds> at_most) {
    CommandQueue* const commands = stream_.commands;
    const auto earlier = [&](std::optional<milliseconds> time) {
      if (time) at_most = std::min(at_most.value_or(*time), *time);
    };
    const auto left = time_left();
    earlier(left);
    if (commands != nullptr) earlier(commands->time_left());
    switch (signals_.wait(descriptor, at_most, commands == nullptr ? -1 : commands->descriptor())) {
      case StopSignals::Woken::stopped:
        ending_signal_ = StopSignals::pending();
        end_ = ExitStatus::found;
        break;
      case StopSignals::Woken::timed_out:
        if (left && *left <= *at_most) {
          ending_signal_ = SIGTERM;
          is_out_of_time_ = true;
          end_ = timed_out();
        }
        break;
      case StopSignals::Woken::readable:
        break;
    }
    if (commands != nullptr) commands->process();
  }

  /// Waits until all commands have run or the program is to end.
  void let_commands_end() {
    while (ending_signal_ == 0 && stream_.commands != nullptr && !stream_.commands->is_idle()) wait(-1, {});
  }

  /// Waits before the next attempt to reach a daemon that went. False: the program is to end, and end_ says how.
  bool pause() {
    const auto until = Clock::now() + between_attempts;
    while (!end_) {
      const auto left = std::chrono::ceil<milliseconds>(until - Clock::now());
      if (left <= milliseconds(0)) return true;
      wait(-1, left);
    }
    return false;
  }

  /// Prints events until end_ is set or the daemon goes.
  ClientError follow(Client& client) {
    // The pong has come after the requests, so their present events have been read.
    bool is_settled = false;
    while (!end_) {
      if (!has_room()) {
        wait(-1, {});
        continue;
      }
      auto event = client.poll();
      if (!event) return event.error();
      if (*event) {
        if (view_.tell(**event) && is_last()) end_ = ExitStatus::found;
        if (!std::cout) end_ = ExitStatus::wrong_use;
      } else if (!is_settled) {
        is_settled = !view_.drop_doubted();
        if (!is_settled && is_last()) end_ = ExitStatus::found;
      } else {
        wait(client.file_descriptor(), {});
      }
    }
    let_commands_end();  // commands may need the statements, which the end withdraws
    return {};
  }

  const Stream& stream_;
  EventView& view_;
  Clock::time_point begin_;
  StopSignals signals_;
  std::uint64_t events_ = 0;
  bool was_connected_ = false;
  std::optional<ExitStatus> end_;
  int ending_signal_ = 0;  ///< for the running command; 0: it runs to its end
  bool is_out_of_time_ = false;
};

}  // namespace

ExitStatus run(const Stream& stream, EventView& view) {
  Runner runner(stream, view);
  const ExitStatus status = runner.run();  // its client has withdrawn its statements
  return written(stream.program, runner.finish(status));
}

}  // namespace geminga::shell
