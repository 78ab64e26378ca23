// Places that are free for everybody until all are taken, and then shared by address (src/client/CHANNELS.md, Places).
#ifndef GEMINGA_CLIENT_PROTOCOL_PLACES_HPP
#define GEMINGA_CLIENT_PROTOCOL_PLACES_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "client/protocol/peer_address.hpp"

namespace geminga::client {

/// The places of listeners, connections, consumers or providers, whose numbers are the caller's and rise with time.
/// Ports do not count. A newcomer costs a time linear in the addresses if all places are taken; all else is
/// logarithmic.
class Places {
 public:
  using Number = std::uint64_t;
  struct Given {
    bool is_taken = false;          ///< false: the newcomer is refused
    std::optional<Number> loser{};  ///< loses its place to the newcomer
  };

  explicit Places(std::size_t most) : most_(most) {}

  /// Gives a newcomer a place if there is one, or if its address has at least two places fewer than another. Requires a
  /// number above all others.
  Given take(Number number, const PeerAddress& address);
  /// The holder has delivered something, so it is among the last of its address that lose their places.
  void serve(Number number);
  void leave(Number number);

  [[nodiscard]] std::size_t most() const { return most_; }
  [[nodiscard]] std::size_t taken() const { return holders_.size(); }
  [[nodiscard]] bool are_taken() const { return holders_.size() >= most_; }
  [[nodiscard]] bool has(Number number) const { return holders_.contains(number); }

 private:
  struct Address {
    std::set<Number> unserved;
    std::set<Number> served;
    [[nodiscard]] std::size_t size() const { return unserved.size() + served.size(); }
    [[nodiscard]] Number newest() const;
  };
  struct Holder {
    PeerAddress address;
    bool is_served = false;
  };

  std::size_t most_;
  std::map<Number, Holder> holders_;
  std::map<PeerAddress, Address> addresses_;  ///< by address with port 0
};

/// Tells once that all places are taken, until at most three quarters of them are.
class Crowding {
 public:
  enum class News : std::uint8_t { none, full, free };
  /// Takes in that somebody was refused or lost a place.
  News on_full() { return std::exchange(is_full_, true) ? News::none : News::full; }
  /// Takes in that places may have been left.
  News on_left(const Places& places) {
    if (!is_full_ || places.taken() * 4 > places.most() * 3) return News::none;
    is_full_ = false;
    return News::free;
  }

 private:
  bool is_full_ = false;
};

}  // namespace geminga::client

#endif
