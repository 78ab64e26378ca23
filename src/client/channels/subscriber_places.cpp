// The keys of a subscriber's providers, and their places over TCP.
#include <algorithm>
#include <utility>
#include <vector>

#include "client/channels/subscriber_channel.hpp"

namespace geminga::client {

std::optional<ChannelKeys> SubscriberChannel::keys_of(Life publisher) const {
  if (const auto found = keys_.find(publisher); found != keys_.end()) return found->second;
  return has_plain_daemon_ ? std::optional(ChannelKeys()) : std::nullopt;
}

void SubscriberChannel::set_keys(Life publisher, const ChannelKeys& keys) {
  const bool is_new = keys_.insert_or_assign(publisher, keys).second;
  if (counterparts_.find(publisher)) {
    use_keys(publisher);
  } else if (is_new) {
    keep_keys(publisher);
  }
}

void SubscriberChannel::keep_keys(Life publisher) {
  if (!keys_.contains(publisher)) return;
  std::erase(waiting_keys_, publisher);
  waiting_keys_.push_back(publisher);
  if (waiting_keys_.size() <= max_waiting_keys) return;
  const Life eldest = waiting_keys_.front();
  waiting_keys_.pop_front();
  if (!counterparts_.find(eldest)) keys_.erase(eldest);
}

void SubscriberChannel::use_keys(Life publisher) {
  const auto number = counterparts_.find(publisher);
  const auto keys = keys_of(publisher);
  if (!number || !keys) return;
  Provider& provider = providers_.at(*number);
  if (provider.way == Way::none) return wire(*number, ServiceEvent(provider.event));
  udp_.set_keys(*number, *keys);
  if (provider.connection) provider.connection->set_keys(*keys);
}

void SubscriberChannel::on_daemon_keys(bool has_keys) {
  has_plain_daemon_ = !has_keys;
  if (has_keys) return;
  keys_.clear();
  waiting_keys_.clear();
  std::vector<Life> lives;
  for (const auto& [number, counterpart] : counterparts_.all()) lives.push_back(counterpart.life);
  for (const Life life : lives) {
    if (life != no_life) use_keys(life);
  }
}

void SubscriberChannel::on_mode() {
  std::vector<Number> lifeless;
  for (const auto& [number, counterpart] : counterparts_.all()) {
    if (counterpart.life == no_life) lifeless.push_back(number);
  }
  for (const Number number : lifeless) wire(number, ServiceEvent(providers_.at(number).event));
}

void SubscriberChannel::problem_of(Number number, const std::string& text) {
  if (std::exchange(providers_.at(number).last_problem, text) != text) problem(text);
}

void SubscriberChannel::claim_place(Number number) {
  const auto given = places_.claim(number, providers_.at(number).address);
  if (given.loser) {
    providers_.at(*given.loser).connection.reset();
    if (counterparts_.at(*given.loser).state != Counterparts::State::matched) on_lost(*given.loser);
  }
  if ((given.loser || !given.is_taken) && crowding_.on_full() == Crowding::News::full) {
    problem("all " + std::to_string(max_tcp_providers) + " places for providers over TCP are taken");
  }
  if (given.is_taken) connect(number);
  set_place_timer();
}

void SubscriberChannel::leave_place(Number number) {
  const auto next = places_.release(number);
  [[maybe_unused]] const auto news = crowding_.on_left(places_.places());
  if (next) connect(*next);
  set_place_timer();
}

void SubscriberChannel::rotate_places() {
  std::vector<Number> unconnected;
  for (const auto& [number, provider] : providers_) {
    const bool waits = provider.connection && !provider.connection->is_connected();
    if (waits && provider.connection->unconnected_since() + stranger_patience <= now()) unconnected.push_back(number);
  }
  for (const Number number : unconnected) {
    const auto next = places_.rotate(number);
    if (!next) break;
    providers_.at(number).connection.reset();
    connect(*next);
  }
  set_place_timer();
}

void SubscriberChannel::set_place_timer() {
  base::Instant next = base::never;
  if (places_.has_waiting()) {
    for (const auto& [number, provider] : providers_) {
      if (!provider.connection || provider.connection->is_connected()) continue;
      next = std::min(next, provider.connection->unconnected_since() + stranger_patience);
    }
    // A connection that is lost meanwhile is found out then.
    next = std::min(next, now() + stranger_patience);
  }
  place_timer_.set(next);
}

void SubscriberChannel::return_to_ended() {
  std::vector<ServiceEvent> due;
  base::Instant next = base::never;
  for (const auto& [key, ended] : ended_) {
    if (ended.until <= now()) {
      due.push_back(ended.event);
    } else {
      next = std::min(next, ended.until);
    }
  }
  for (ServiceEvent& event : due) {
    event.change = Change::add;
    on_event(event);
  }
  again_timer_.set(next);
}

}  // namespace geminga::client
