#include "client/protocol/places.hpp"

#include <algorithm>
#include <utility>

namespace geminga::client {
namespace {

PeerAddress without_port(PeerAddress address) {
  address.port = 0;
  return address;
}

}  // namespace

Places::Number Places::Address::newest() const {
  return std::max(unserved.empty() ? 0 : *unserved.rbegin(), served.empty() ? 0 : *served.rbegin());
}

Places::Given Places::take(Number number, const PeerAddress& address) {
  const PeerAddress own = without_port(address);
  Given given{true, {}};
  if (are_taken()) {
    const auto most = std::ranges::max_element(
        addresses_, {}, [](const auto& one) { return std::pair(one.second.size(), one.second.newest()); });
    const auto mine = addresses_.find(own);
    const std::size_t held = mine == addresses_.end() ? 0 : mine->second.size();
    if (most == addresses_.end() || most->second.size() < held + 2) return {};
    const Address& crowded = most->second;
    given.loser = crowded.unserved.empty() ? *crowded.served.rbegin() : *crowded.unserved.rbegin();
    leave(*given.loser);
  }
  holders_[number] = {own};
  addresses_[own].unserved.insert(number);
  return given;
}

void Places::serve(Number number) {
  const auto holder = holders_.find(number);
  if (holder == holders_.end() || std::exchange(holder->second.is_served, true)) return;
  Address& address = addresses_.at(holder->second.address);
  address.unserved.erase(number);
  address.served.insert(number);
}

void Places::leave(Number number) {
  const auto holder = holders_.find(number);
  if (holder == holders_.end()) return;
  const auto address = addresses_.find(holder->second.address);
  address->second.unserved.erase(number);
  address->second.served.erase(number);
  if (address->second.size() == 0) addresses_.erase(address);
  holders_.erase(holder);
}

}  // namespace geminga::client
