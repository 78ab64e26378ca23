#include "shell/command_queue.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <sstream>
#include <utility>

#include "shell/event_variables.hpp"
#include "shell/json.hpp"
#include "shell/report.hpp"

namespace geminga::shell {
namespace {

using std::chrono::milliseconds;

/// The name of an event on standard error.
std::string name_of_event(const boost::json::object& event) {
  std::string name;
  for (const char* key : {"event", "service", "subscription"}) {
    const auto* value = event.if_contains(key);
    if (value == nullptr || !value->is_string()) continue;
    if (!name.empty()) name += ' ';
    name += std::string_view(value->as_string());
  }
  return name;
}

/// The bad end of a command in words; empty: it ended well.
std::string trouble(int status) {
  if (WIFSIGNALED(status)) return "killed by signal " + std::to_string(WTERMSIG(status));
  return WEXITSTATUS(status) == 0 ? "" : "exit status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

std::size_t CommandQueue::Run::octets() const {
  std::size_t sum = name.size() + input.size();
  for (const std::string& variable : environment) sum += variable.size();
  return sum;
}

CommandQueue::CommandQueue(std::string_view program, CommandOptions options)
    : program_(program), options_(std::move(options)) {}
CommandQueue::~CommandQueue() = default;

void CommandQueue::add(const boost::json::object& event) {
  std::ostringstream line;
  print(line, event);
  Run run{name_of_event(event), event_variables(event), std::move(line).str()};
  waiting_octets_ += run.octets();
  waiting_.push_back(std::move(run));
  process();
}

bool CommandQueue::has_room() const {
  return waiting_.size() < max_waiting_commands && waiting_octets_ < max_waiting_octets;
}

std::optional<milliseconds> CommandQueue::time_left() const {
  if (!deadline_) return std::nullopt;
  return std::max(std::chrono::ceil<milliseconds>(*deadline_ - Clock::now()), milliseconds(0));
}

void CommandQueue::process() {
  while (true) {
    if (running_ && !running_->has_ended()) return hurry();
    if (running_) finish();
    if (waiting_.empty()) return;
    start_next();
  }
}

void CommandQueue::start_next() {
  const Run run = std::move(waiting_.front());
  waiting_.pop_front();
  waiting_octets_ -= run.octets();
  running_name_ = run.name;
  auto started =
      RunningCommand::start(options_.command, environment_with(run.environment, options_.connect), run.input);
  if (!started) return say("could not be started: " + started.error());
  running_ = std::move(*started);
  if (options_.time) deadline_ = Clock::now() + *options_.time;
}

/// Ends a command that has run too long.
void CommandQueue::hurry() {
  if (!deadline_ || Clock::now() < *deadline_) return;
  if (!told_to_end_.empty()) {
    running_->signal(SIGKILL);
    deadline_.reset();
    return;
  }
  told_to_end_ = "ended after " + std::to_string(std::chrono::duration<double>(*options_.time).count());
  told_to_end_.erase(told_to_end_.find_last_not_of('0') + 1);
  if (told_to_end_.ends_with('.')) told_to_end_.pop_back();
  told_to_end_ += " s, see --exec-timeout";
  running_->signal(SIGTERM);
  deadline_ = Clock::now() + command_grace;
}

void CommandQueue::finish() {
  const int status = running_->reap();
  running_.reset();
  deadline_.reset();
  const std::string why = std::exchange(told_to_end_, "");
  if (!why.empty()) {
    say(why);
  } else if (const std::string ended = trouble(status); !ended.empty()) {
    say(ended);
  }
}

void CommandQueue::stop(int signal) {
  if (running_) {
    running_->signal(signal);
    if (!running_->has_ended(command_grace)) running_->signal(SIGKILL);
    static_cast<void>(running_->reap());
    running_.reset();
    deadline_.reset();
  }
  if (!waiting_.empty()) {
    complain(program_, "--exec: not run any more, for so many events that waited: " + std::to_string(waiting_.size()));
  }
  waiting_.clear();
  waiting_octets_ = 0;
}

void CommandQueue::say(const std::string& what) const {
  complain(program_, "--exec: " + what + " (" + running_name_ + ')');
}

}  // namespace geminga::shell
