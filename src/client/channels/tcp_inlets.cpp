#include "client/channels/tcp_inlets.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "client/protocol/limits.hpp"

namespace geminga::client {

TcpInlets::TcpInlets(ChannelHost& host, Sealer& sealer, Told told)
    : host_(host), sealer_(sealer), told_(std::move(told)), timer_(host.reactor(), [this] { rotate(); }) {}

void TcpInlets::open(Number provider, Life life, const PeerAddress& address, const ChannelKeys& keys) {
  providers_.insert_or_assign(provider, Provider{life, address, keys});
  const auto given = places_.claim(provider, address);
  if (given.loser) {
    providers_.at(*given.loser).inlet.reset();
    // One that the daemon does not match any more goes with its connection.
    [[maybe_unused]] const bool waits = told_.lost(*given.loser);
  }
  if ((given.loser || !given.is_taken) && crowding_.on_full() == Crowding::News::full) {
    told_.problem("all " + std::to_string(max_tcp_providers) + " places for providers over TCP are taken");
  }
  if (given.is_taken) connect(provider);
  set_timer();
}

void TcpInlets::connect(Number number) {
  Provider& provider = providers_.at(number);
  TcpInlet::Told told;
  told.frame = [this, number](const Frame& frame, bool is_proved) { return take(number, frame, is_proved); };
  told.lost = [this, number] { return told_.lost(number); };
  told.dropped = [this] { told_.dropped(); };
  told.full = [this, address = to_string(provider.address)] {
    told_.problem("the provider " + address + " has no place for another consumer");
  };
  provider.inlet =
      std::make_unique<TcpInlet>(host_, provider.address, sealer_, provider.life, provider.keys, std::move(told));
  if (is_paused_) provider.inlet->pause(true);
  provider.inlet->start();
}

bool TcpInlets::take(Number provider, const Frame& frame, bool is_proved) {
  told_.frame(provider, frame, is_proved);
  return !is_paused_;
}

void TcpInlets::set_keys(Number provider, const ChannelKeys& keys) {
  const auto found = providers_.find(provider);
  if (found == providers_.end()) return;
  found->second.keys = keys;
  if (found->second.inlet) found->second.inlet->set_keys(keys);
}

void TcpInlets::close(Number provider) {
  if (providers_.erase(provider) == 0) return;
  const auto next = places_.release(provider);
  [[maybe_unused]] const auto news = crowding_.on_left(places_.places());
  if (next) connect(*next);
  set_timer();
}

bool TcpInlets::is_connected(Number provider) const {
  const auto found = providers_.find(provider);
  return found != providers_.end() && found->second.inlet && found->second.inlet->is_connected();
}

void TcpInlets::pause(bool is_paused) {
  if (is_paused_ == is_paused) return;
  is_paused_ = is_paused;
  // pause() gives the frames that a connection has read already, which may end it or pause all again.
  std::vector<Number> numbers;
  for (const auto& [number, provider] : providers_) {
    if (provider.inlet) numbers.push_back(number);
  }
  for (const Number number : numbers) {
    const auto found = providers_.find(number);
    if (found != providers_.end() && found->second.inlet) found->second.inlet->pause(is_paused_);
  }
}

void TcpInlets::rotate() {
  std::vector<Number> unconnected;
  for (const auto& [number, provider] : providers_) {
    const bool waits = provider.inlet && !provider.inlet->is_connected();
    if (waits && provider.inlet->unconnected_since() + stranger_patience <= now()) unconnected.push_back(number);
  }
  for (const Number number : unconnected) {
    const auto next = places_.rotate(number);
    if (!next) break;
    providers_.at(number).inlet.reset();
    connect(*next);
  }
  set_timer();
}

void TcpInlets::set_timer() {
  base::Instant next = base::never;
  if (places_.has_waiting()) {
    for (const auto& [number, provider] : providers_) {
      if (!provider.inlet || provider.inlet->is_connected()) continue;
      next = std::min(next, provider.inlet->unconnected_since() + stranger_patience);
    }
    // A connection that is lost meanwhile is found out then.
    next = std::min(next, now() + stranger_patience);
  }
  timer_.set(next);
}

}  // namespace geminga::client
