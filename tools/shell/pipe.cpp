#include "shell/pipe.hpp"

#include <sys/epoll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <expected>
#include <iostream>
#include <string>
#include <string_view>
#include <utility>

#include "base/harmless.hpp"
#include "shell/report.hpp"
#include "shell/stop_signals.hpp"
#include "shell/terminal.hpp"

namespace geminga::shell {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

/// The pause before a line that could not be sent is tried again.
constexpr milliseconds between_sends{20};
/// The octets of standard input that are read at once.
constexpr std::size_t read_bytes = std::size_t{64} * 1024;

/// Reads standard input as lines.
class Lines {
 public:
  /// The next line, where all of it has been read.
  [[nodiscard]] std::optional<std::string_view> next() const {
    const auto end = text_.find('\n', taken_);
    if (end == std::string::npos) return is_over_ && taken_ < text_.size() ? rest() : std::nullopt;
    return std::string_view(text_).substr(taken_, end - taken_);
  }
  void take() { taken_ = std::min(text_.size(), taken_ + next().value_or("").size() + 1); }
  [[nodiscard]] bool is_over() const { return is_over_ && taken_ == text_.size(); }
  [[nodiscard]] bool is_too_long() const { return text_.size() - taken_ > max_piped_bytes && !next(); }

  /// Reads once; waits where there is nothing to read.
  void read() {
    text_.erase(0, std::exchange(taken_, 0));
    const std::size_t before = text_.size();
    text_.resize(before + read_bytes);
    const auto got = ::read(STDIN_FILENO, text_.data() + before, read_bytes);
    text_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got == 0 || (got < 0 && errno != EINTR && errno != EAGAIN)) is_over_ = true;
  }

 private:
  [[nodiscard]] std::optional<std::string_view> rest() const { return std::string_view(text_).substr(taken_); }

  std::string text_;
  std::size_t taken_ = 0;  ///< octets at its front that are taken
  bool is_over_ = false;
};

/// The node and the conditions of the end, which both directions share.
class Piping {
 public:
  Piping(const Pipe& pipe, Node node) : pipe_(pipe), node_(std::move(node)), begin_(Clock::now()) {
    node_.on_event([this](const ChannelEvent& event) { tell(event); });
  }

  [[nodiscard]] Node& node() { return node_; }
  [[nodiscard]] std::optional<ExitStatus> ended() const { return ended_; }

  /// Ends well: there is no more input.
  void finish() { ended_ = ended_.value_or(ExitStatus::found); }
  /// Counts a message.
  void count() {
    if (++messages_ == pipe_.count) ended_ = ExitStatus::found;
  }
  /// Waits at most so long until `descriptor` is readable, and lets the node work. Events that came earlier are to be
  /// taken first.
  void wait(int descriptor, std::optional<milliseconds> at_most = {}) {
    auto left = at_most;
    if (pipe_.timeout) {
      const auto gone = std::chrono::duration_cast<milliseconds>(Clock::now() - begin_);
      const auto until_end = std::max(*pipe_.timeout - gone, milliseconds(0));
      if (until_end == milliseconds(0)) {
        ended_ = messages_ > 0 && pipe_.count == 0 ? ExitStatus::found : ExitStatus::timed_out;
        return;
      }
      left = std::min(left.value_or(until_end), until_end);
    }
    if (signals_.wait(descriptor, left) == StopSignals::Woken::stopped) ended_ = ExitStatus::found;
    node_.process();
  }

 private:
  void tell(const ChannelEvent& event) {
    if (ended_) return;
    if (std::holds_alternative<Disconnected>(event)) {
      complain(pipe_.program, std::get<Disconnected>(event).reason);
      if (!pipe_.is_kept) ended_ = ExitStatus::no_daemon;
    } else if (const auto* provider = std::get_if<ProviderChange>(&event)) {
      say(to_string(provider->what), provider->service.peer_name, provider->service.participant_name, provider->reason);
    } else if (const auto* consumer = std::get_if<ConsumerChange>(&event)) {
      say(to_string(consumer->what), consumer->consumer.peer_name, consumer->consumer.participant_name,
          consumer->reason);
    } else if (const auto* refused = std::get_if<Refused>(&event)) {
      ended_ = report(pipe_.program, {ClientError::Kind::refused, refused->error.text, refused->error.code});
    } else if (const auto* problem = std::get_if<Problem>(&event)) {
      complain(pipe_.program, problem->text);
    }
  }
  void say(std::string_view what, const std::string& peer, const std::string& participant,
           const std::string& reason) const {
    complain(pipe_.program, peer + "@" + participant + " " + std::string(what) + (reason.empty() ? "" : ": " + reason));
  }

  const Pipe& pipe_;
  Node node_;
  StopSignals signals_;
  Clock::time_point begin_;
  std::uint64_t messages_ = 0;
  std::optional<ExitStatus> ended_;
};

/// A node that is connected to its daemon.
Result<Node, ClientError> open(const Pipe& pipe) {
  ClientOptions probe = pipe.connection;
  probe.name.clear();
  if (auto client = Client::connect(probe); !client) return std::unexpected(client.error());
  ClientOptions options = pipe.connection;
  // Events tell of everything else.
  options.log = [program = pipe.program](std::string_view line) {
    if (line.starts_with("no daemon at ") || line.starts_with("the daemon at ")) complain(program, line);
  };
  return Node::open(options);
}

/// One descriptor for standard input and a node.
class Both {
 public:
  explicit Both(int node) {
    add(node);
    // epoll refuses a file, which is always readable.
    is_file_ = !add(STDIN_FILENO);
  }
  ~Both() { ::close(epoll_); }
  Both(const Both&) = delete;
  Both& operator=(const Both&) = delete;

  [[nodiscard]] int descriptor() const { return epoll_; }
  [[nodiscard]] bool has_input() const {
    if (is_file_) return true;
    std::array<epoll_event, 2> events{};
    const int count = ::epoll_wait(epoll_, events.data(), static_cast<int>(events.size()), 0);
    return std::any_of(events.begin(), events.begin() + std::max(count, 0),
                       [](const epoll_event& event) { return event.data.fd == STDIN_FILENO; });
  }

 private:
  bool add(int descriptor) const {
    epoll_event event{.events = EPOLLIN, .data = {.fd = descriptor}};
    return ::epoll_ctl(epoll_, EPOLL_CTL_ADD, descriptor, &event) == 0;
  }

  int epoll_ = ::epoll_create1(EPOLL_CLOEXEC);
  bool is_file_ = false;
};

}  // namespace

ExitStatus listen(const Pipe& pipe, const std::vector<NamedSubscription>& subscriptions) {
  auto node = open(pipe);
  if (!node) return report(pipe.program, node.error());
  Piping piping(pipe, std::move(*node));
  std::vector<Subscriber> subscribers;
  for (const auto& subscription : subscriptions) {
    auto subscriber = piping.node().subscribe(subscription);
    if (!subscriber) return report(pipe.program, subscriber.error());
    subscribers.push_back(std::move(*subscriber));
  }
  const bool is_terminal = Terminal::of_standard_output().is_terminal;
  while (!piping.ended()) {
    bool has_come = false;
    for (Subscriber& subscriber : subscribers) {
      while (!piping.ended()) {
        const auto message = subscriber.poll();
        if (!message) break;
        const std::string_view payload(reinterpret_cast<const char*>(message->payload.data()), message->payload.size());
        if (is_terminal) {
          std::cout << base::harmless_lines(payload) << '\n';
        } else {
          std::cout << payload << '\n';  // data, as it came
        }
        piping.count();
        has_come = true;
      }
    }
    if (has_come && !(std::cout << std::flush)) break;
    if (!piping.ended()) piping.wait(piping.node().descriptor());
  }
  return written(pipe.program, piping.ended().value_or(ExitStatus::found));
}

ExitStatus send(const Pipe& pipe, const NamedPublication& publication) {
  auto node = open(pipe);
  if (!node) return report(pipe.program, node.error());
  Piping piping(pipe, std::move(*node));
  auto publisher = piping.node().publish(publication);
  if (!publisher) return report(pipe.program, publisher.error());
  Both both(piping.node().descriptor());
  Lines lines;
  bool has_left_out = false;
  while (!piping.ended()) {
    const auto line = lines.next();
    if (!line) {
      if (lines.is_over()) break;
      if (lines.is_too_long()) {
        complain(pipe.program, "a line is longer than " + std::to_string(max_piped_bytes) + " octets");
        piping.finish();
        return ExitStatus::wrong_use;
      }
      if (both.has_input()) {
        lines.read();
      } else {
        piping.wait(both.descriptor());
      }
      continue;
    }
    const auto before = publisher->count().sent;
    if (publisher->has_room(line->size())) {
      const auto sent = publisher->send(*line);
      if (!sent)
        complain(pipe.program,
                 "a line of " + std::to_string(line->size()) + " octets is left out: " + sent.error().text);
      if (!sent && sent.error().kind == SendError::Kind::too_large) {
        has_left_out = true;
        lines.take();
        continue;
      }
      if (!sent) {
        piping.finish();
        return ExitStatus::wrong_use;
      }
    }
    if (publisher->count().sent == before) {
      piping.wait(piping.node().descriptor(), between_sends);
      continue;
    }
    lines.take();
    piping.count();
  }
  piping.finish();
  publisher->withdraw();
  const auto status = piping.ended().value_or(ExitStatus::found);
  return has_left_out && status == ExitStatus::found ? ExitStatus::wrong_use : status;
}

}  // namespace geminga::shell
