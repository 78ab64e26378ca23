// The ways on which one participant is heard, and the rules for opening another one.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_NEIGHBOUR_WAYS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_NEIGHBOUR_WAYS_HPP

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/rare.hpp"
#include "discovery/membership/neighbour/neighbour_way.hpp"

namespace geminga::membership {

class NeighbourWays {
 public:
  [[nodiscard]] const std::vector<NeighbourWay>& all() const { return ways_; }

  /// The way of a datagram, from whatever address it came; null: there is none.
  [[nodiscard]] NeighbourWay* find(const announcement::Announcement& announcement, const Arrival& arrival);
  /// The way of a datagram if it came from the address that the way belongs to; null otherwise.
  [[nodiscard]] const NeighbourWay* find_bound(const announcement::Announcement& announcement,
                                               const Arrival& arrival) const;
  /// The same, or the way that belonged to that address before somebody moved it; null: there is none.
  [[nodiscard]] const NeighbourWay* find_once_bound(const announcement::Announcement& announcement,
                                                    const Arrival& arrival) const;
  /// Whether a state proves that a participant lives that seemed to leave at an instant.
  enum class Proof : std::uint8_t {
    none,   ///< no proof: it comes from another address, or may be older than that instant
    echo,   ///< its number is known: it may be a copy
    alive,  ///< it was sent after that instant
  };
  [[nodiscard]] Proof proof(const announcement::Announcement& announcement, const Arrival& arrival,
                            base::Instant left) const;
  /// The highest sequence number that was heard on the first way; 0: there is none.
  [[nodiscard]] std::uint64_t newest() const { return ways_.empty() ? 0 : ways_.front().newest(); }
  /// Opens a way for a datagram; null: it may not be opened, or there are max_paths. A way that was heard within `hold`
  /// is alive.
  [[nodiscard]] NeighbourWay* open(const announcement::Announcement& announcement, const Arrival& arrival,
                                   base::Duration hold, bool is_contested);
  /// Closes the ways that were opened from the same address after this one, since its own address has spoken. Returns
  /// whether there were any: somebody opened them in its name.
  bool close_later(const NeighbourWay& way, const Arrival& arrival);

  /// Closes the ways through relays, since the participant is heard directly.
  void close_relayed() { std::erase_if(ways_, &NeighbourWay::is_relayed); }
  /// Closes the ways on an interface that is gone. Returns whether there were any. It is we who hear the participant on
  /// fewer ways, so those that are left count.
  bool forget_interface(env::InterfaceIndex interface);
  /// Closes the ways that have their deadline at or before `now`. Returns whether there were any.
  bool expire(base::Instant now);
  /// Moves every deadline before `until` to `until`.
  void postpone(base::Instant until);
  /// The same for the way on which the participant was heard last.
  void postpone_last(base::Instant until);
  /// Moves every deadline after `latest` to `latest`.
  void shorten(base::Instant latest);

  /// Whether a datagram comes from the address of one of the ways.
  [[nodiscard]] bool is_from_one(const Arrival& arrival) const;
  /// Takes in the loss on the ways through relays, which a relay states.
  void set_relayed_loss(double loss);
  /// Undoes what was said of all ways within `hold`, because somebody has lied.
  void roll_back(base::Instant now, base::Duration hold);
  /// Forgets the parts of states that are not whole.
  void forget_parts();
  /// Remembers the number of the first goodbye on its way, if it came from the address that the way belongs to.
  void note_goodbye(const announcement::Announcement& announcement, const Arrival& arrival);
  /// Forgets the numbers of goodbyes.
  void forget_goodbyes();

  /// Whether words from this address are signs of life (ANNOUNCEMENT.md, "Whose words are signs of life").
  [[nodiscard]] bool is_vouched(std::string_view source) const;
  /// Whether a datagram is a sign of life, by its seal or by its source.
  [[nodiscard]] bool is_vouched(const Arrival& arrival) const {
    return arrival.is_sealed || is_vouched(arrival.source);
  }
  void vouch(std::string_view source);
  [[nodiscard]] static std::string_view without_zone(std::string_view address) {
    return address.substr(0, address.find('%'));
  }
  /// Whether a state names this address, whatever its zone.
  [[nodiscard]] static bool lists(const announcement::Announcement& state, std::string_view address);

  /// Takes over the losses on one way before the participant was given up.
  void go_on_from(env::InterfaceIndex interface, std::uint32_t link, const LossWindow& former);

  /// The loss of the best way. 1: no way was measured; 0: there is no way.
  [[nodiscard]] double loss() const;
  /// Whether one way has heard enough datagrams for its loss to mean something.
  [[nodiscard]] bool is_loss_known() const;

 private:
  /// A datagram that asks for a way.
  struct Opening {
    env::InterfaceIndex interface{};
    std::uint32_t link = 0;
    std::string source;
    std::uint64_t sequence = 0;
  };
  [[nodiscard]] bool may_open(const announcement::Announcement& announcement, const Arrival& arrival,
                              base::Duration hold, bool is_contested);

  std::vector<NeighbourWay> ways_;    ///< by interface and link
  std::vector<std::string> vouched_;  ///< without zones; at most max_vouched, the oldest gives way
  base::Rare<Opening> opening_;
  bool was_misled_ = false;  ///< a way was opened although another one went on speaking
};

}  // namespace geminga::membership

#endif
