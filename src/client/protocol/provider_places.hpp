// The places of a subscriber's providers over TCP, and those that wait for one (src/client/CHANNELS.md, Places).
#ifndef GEMINGA_CLIENT_PROTOCOL_PROVIDER_PLACES_HPP
#define GEMINGA_CLIENT_PROTOCOL_PROVIDER_PLACES_HPP

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "client/protocol/counterparts.hpp"
#include "client/protocol/places.hpp"

namespace geminga::client {

/// Providers with a place are connected to; the others wait in the order in which they came. Pure: the caller owns the
/// connections.
class ProviderPlaces {
 public:
  using Number = Counterparts::Number;
  struct Given {
    bool is_taken = false;          ///< false: the provider waits
    std::optional<Number> loser{};  ///< has lost its place and waits
  };

  /// Gives a provider that has no place one, or lets it wait.
  Given claim(Number provider, const PeerAddress& address) {
    const auto given = places_.take(++last_, address);
    Given result{given.is_taken, {}};
    if (given.loser) {
      result.loser = holders_.extract(*given.loser).mapped();
      wait(*result.loser);
    }
    addresses_[provider] = address;
    if (given.is_taken) {
      hold(provider);
    } else {
      waiting_.push_back(provider);
    }
    return result;
  }
  /// Forgets a provider, which may have no place. The result is the one that waited and has a place then.
  std::optional<Number> release(Number provider) {
    std::erase(waiting_, provider);
    addresses_.erase(provider);
    return leave(provider) ? next() : std::nullopt;
  }
  /// Lets a provider with a place wait again. The result is the first that waited, which has that place then.
  std::optional<Number> rotate(Number provider) {
    if (waiting_.empty() || !leave(provider)) return std::nullopt;
    const auto first = next();
    waiting_.push_back(provider);
    return first;
  }
  /// The provider has delivered a message.
  void serve(Number provider) {
    if (const auto place = place_of_.find(provider); place != place_of_.end()) places_.serve(place->second);
  }
  [[nodiscard]] bool has_waiting() const { return !waiting_.empty(); }
  [[nodiscard]] const Places& places() const { return places_; }

 private:
  void hold(Number provider) {
    holders_[last_] = provider;
    place_of_[provider] = last_;
  }
  void wait(Number provider) {
    place_of_.erase(provider);
    waiting_.push_back(provider);
  }
  bool leave(Number provider) {
    const auto place = place_of_.find(provider);
    if (place == place_of_.end()) return false;
    places_.leave(place->second);
    holders_.erase(place->second);
    place_of_.erase(place);
    return true;
  }
  std::optional<Number> next() {
    if (waiting_.empty()) return std::nullopt;
    const Number first = waiting_.front();
    waiting_.pop_front();
    // There is a free place, so nobody loses one.
    places_.take(++last_, addresses_.at(first));
    hold(first);
    return first;
  }

  Places places_{max_tcp_providers};
  Places::Number last_ = 0;
  std::map<Places::Number, Number> holders_;
  std::map<Number, Places::Number> place_of_;
  std::map<Number, PeerAddress> addresses_;
  std::deque<Number> waiting_;
};

}  // namespace geminga::client

#endif
