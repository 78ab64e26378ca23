#include "discovery/participant/air/introductions.hpp"

#include <algorithm>

#include "base/address.hpp"

namespace geminga::participant {
namespace {

/// An address at which everybody on the link can send to it alone: no IPv6 link-local one, which is heard by multicast
/// only. Empty: it has none.
std::string address_on(const membership::Neighbour& neighbour, env::InterfaceIndex interface) {
  const auto path = std::ranges::find(neighbour.paths, interface, &membership::Path::interface);
  if (path == neighbour.paths.end()) return "";
  const auto found = std::ranges::find_if(path->addresses, [](const std::string& text) {
    const auto address = base::parse_address(text);
    return address && address->scope() != base::AddressScope::loopback &&
           !(address->is_ipv6() && address->scope() == base::AddressScope::link_local);
  });
  return found == path->addresses.end() ? "" : *found;
}

}  // namespace

bool Introductions::is_due(base::Instant now) {
  const base::Duration interval = settings_.interval;
  if (!table_.witnesses().anybody_knows_others()) {
    begin_ = base::never;
    return false;
  }
  if (begin_ == base::never || roster_ != table_.neighbours().roster()) {
    pause_ = introducing_intervals;
    roster_ = table_.neighbours().roster();
    if (begin_ == base::never || now >= end_ || now < begin_) begin_ = now;
    end_ = begin_ + introducing_intervals * interval;
  }
  if (now >= end_) {
    begin_ = now + pause_ * interval;
    end_ = begin_ + introducing_intervals * interval;
    pause_ = std::min(2 * pause_, longest_introducing_pause);
  }
  return now >= begin_;
}

void Introductions::add_to(announcement::Announcement& presence, env::InterfaceIndex interface, base::Instant now) {
  const bool is_sealed = seal_.policy().mode >= sealing::Mode::authenticated;
  if (presence.kind != announcement::Kind::presence || !is_sealed || !is_due(now)) return;
  auto& all = presence.introductions;  // in ascending order
  bool is_needed = false;
  table_.neighbours().for_each([&](const membership::Neighbour& one) {
    std::string address = address_on(one, interface);
    if (address.empty()) return;
    is_needed = is_needed || table_.witnesses().knows_others(one.id);
    all.push_back({one.id, std::move(address)});
  });
  if (!is_needed || all.size() < 2) {
    all.clear();
    return;
  }
  std::ranges::rotate(all, std::ranges::upper_bound(all, last_, {}, &announcement::Introduction::participant));
  all.resize(std::min(all.size(), announcement::max_introductions));
  last_ = all.back().participant;
}

}  // namespace geminga::participant
