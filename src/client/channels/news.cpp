#include "client/channels/news.hpp"

#include <string>
#include <utility>

#include "client/protocol/limits.hpp"

namespace geminga::client {
namespace {

/// The number that stands for events among the news.
constexpr ChannelNumber events_only = 0;

}  // namespace

void News::tell(ChannelEvent event) {
  if (const auto* problem = std::get_if<Problem>(&event)) log_.line(problem->text);
  if (events_.size() == max_waiting_events) {
    events_.pop_front();
    ++lost_events_;
  }
  events_.push_back(std::move(event));
  has_event_come_ = true;
  unseen_.insert(events_only);
}

void News::on_message(ChannelNumber channel) {
  ready_.push_back(channel);
  unseen_.insert(channel);
}

void News::forget(ChannelNumber channel) {
  on_message_.erase(channel);
  has_looked(channel);
}

std::optional<ChannelEvent> News::next_event() {
  has_looked(events_only);
  if (const auto lost = std::exchange(lost_events_, 0); lost > 0) {
    Problem problem{0, std::to_string(lost) + " events were thrown away: take them more often"};
    log_.line(problem.text);
    return problem;
  }
  if (events_.empty()) return std::nullopt;
  std::optional<ChannelEvent> event(std::move(events_.front()));
  events_.pop_front();
  return event;
}

void News::on_messages(ChannelNumber number, OnMessage on_message) {
  on_message_[number] = std::move(on_message);
  ready_.push_back(number);
}

bool News::hand_out(const Take& take) {
  const bool has_come = std::exchange(has_event_come_, false) || !ready_.empty();
  // The functions of the program may call everything of the engine but process().
  while (on_event_ && !events_.empty()) {
    const auto event = next_event();
    const OnEvent told = on_event_;
    told(*event);
  }
  const auto ready = std::exchange(ready_, {});
  for (const ChannelNumber number : ready) {
    const auto found = on_message_.find(number);
    if (found == on_message_.end()) continue;
    const OnMessage told = found->second;
    has_looked(number);
    while (auto message = take(number)) told(std::move(*message));
  }
  return has_come;
}

}  // namespace geminga::client
