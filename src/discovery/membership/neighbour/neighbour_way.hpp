// One way on which a participant is heard: its source address, its sequence numbers and what it announces there.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_NEIGHBOUR_WAY_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_NEIGHBOUR_WAY_HPP

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/rare.hpp"
#include "discovery/membership/neighbour/arrival.hpp"
#include "discovery/membership/neighbour/change.hpp"
#include "discovery/membership/neighbour/hearing.hpp"
#include "discovery/membership/neighbour/loss_window.hpp"
#include "discovery/membership/neighbour/neighbour.hpp"
#include "discovery/membership/neighbour/revocable.hpp"
#include "discovery/membership/neighbour/rising_count.hpp"
#include "discovery/membership/neighbour/state_assembly.hpp"

namespace geminga::membership {

/// A way belongs to the source address that it was first heard from (ANNOUNCEMENT.md, "Who is believed").
class NeighbourWay {
 public:
  NeighbourWay(const announcement::Announcement& first, const Arrival& arrival);

  /// The origin of a datagram on this way.
  enum class Origin : std::uint8_t {
    bound,      ///< from the address that the way belongs to
    back,       ///< from the address that it belonged to: those who spoke since then were somebody else
    copied,     ///< from another address, with a number that was heard: a copy
    elsewhere,  ///< from another address that has not proved itself yet
  };
  /// Judges the origin of a datagram. `needs_silence`: another address gets the way only after the present one was
  /// silent for `hold`.
  [[nodiscard]] Origin origin(const announcement::Announcement& announcement, const Arrival& arrival,
                              bool needs_silence, base::Duration hold);

  /// The order of a datagram among those before it, by its numbers.
  enum class Order : std::uint8_t {
    next,           ///< it fits
    overtaken,      ///< sent before the last one that was heard: only a sign of life
    contradiction,  ///< no sender numbers its datagrams like this: this one or an earlier one is forged
  };
  [[nodiscard]] Order order(const announcement::Announcement& announcement, base::Instant now) const;
  /// Whether the revision is so far from `believed` that it is not taken at once.
  [[nodiscard]] bool leaps(const announcement::Announcement& announcement, std::uint64_t believed);
  /// Whether it contradicts what another datagram of the same revision said of this way.
  [[nodiscard]] bool denies(const announcement::Announcement& announcement, const Arrival& arrival) const;

  /// Counts a datagram. `is_contradiction`: its number is the sender's, whatever was heard before.
  void count(const announcement::Announcement& announcement, const Arrival& arrival, bool is_contradiction);
  /// Takes over what a state says of the way, unless the present addresses are held.
  void say(const announcement::Announcement& announcement, const Arrival& arrival, bool is_contested,
           base::Duration hold);
  /// Whether the state of the newest revision was heard on this way.
  [[nodiscard]] bool is_said() const { return said_revision_ == revision_ && !has_moved_; }
  /// Takes in a presence. It affirms what the state of its revision said of the way.
  void affirm(std::uint64_t revision, base::Instant now, bool is_contested) {
    revision_ = revision;
    if (revision == said_revision_ && !is_contested) addresses_.affirm(now);
  }
  /// Takes in a change. If the state of `since` or of a later revision is known here, that of `revision` is.
  void advance(std::uint64_t since, std::uint64_t revision, base::Instant now, bool is_contested) {
    if (said_revision_ && since <= *said_revision_ && *said_revision_ <= revision && !is_contested) {
      if (revision != *said_revision_) part_count_.reset();
      said_revision_ = revision;
    }
    affirm(revision, now, is_contested);
  }
  /// Undoes what was said less than `hold` ago.
  void roll_back(base::Instant now, base::Duration hold);

  /// Whether its datagrams come through relays, on whatever interface.
  [[nodiscard]] bool is_relayed() const { return is_relayed_; }
  /// Whether all its datagrams came to us alone, so that its participant need not be on our link.
  [[nodiscard]] bool is_heard_alone() const { return is_heard_alone_; }
  /// Takes over the losses of the same way before its participant was given up.
  void go_on_from(const LossWindow& former) { losses_.go_on_from(former); }
  /// Takes in the loss of all hops of a relayed way.
  void set_loss(double loss) { path_.loss = loss; }
  /// Whether a datagram belongs to this way, from whatever address it came.
  [[nodiscard]] bool is_way_of(const announcement::Announcement& announcement, const Arrival& arrival) const {
    if (link() != announcement.link || is_relayed_ != (arrival.passage != nullptr)) return false;
    return is_relayed_ || is_on(arrival.interface);
  }
  [[nodiscard]] bool is_on(env::InterfaceIndex interface) const { return path_.interface == interface; }
  [[nodiscard]] env::InterfaceIndex interface() const { return path_.interface; }
  [[nodiscard]] std::uint32_t link() const { return path_.link; }
  [[nodiscard]] base::Instant opened() const { return opened_; }
  [[nodiscard]] const std::string& interface_name() const { return path_.interface_name; }
  [[nodiscard]] base::Instant heard() const { return path_.heard; }
  [[nodiscard]] Path path() const;
  [[nodiscard]] const std::string& source() const { return source_; }
  /// Whether it belonged to this address a short while ago.
  [[nodiscard]] bool was_of(std::string_view source) const { return home_ && home_->source == source; }
  [[nodiscard]] const std::vector<std::string>& addresses() const { return addresses_.value(); }
  /// Whether a datagram with this number was heard and may have come twice.
  [[nodiscard]] bool is_copy(std::uint64_t sequence, base::Instant now) const {
    return losses_.has(sequence) && !sequences_.is_late(sequence, now);
  }
  [[nodiscard]] bool is_next(std::uint64_t sequence) const { return losses_.is_empty() || sequence > losses_.newest(); }
  [[nodiscard]] bool has(std::uint64_t sequence) const { return losses_.has(sequence); }
  [[nodiscard]] double loss() const { return path_.loss; }
  /// Whether enough was heard for the loss to mean something.
  [[nodiscard]] bool is_loss_known() const { return is_relayed_ || losses_.span() >= LossWindow::least_span; }
  [[nodiscard]] const LossWindow& losses() const { return losses_; }
  /// Takes in a part of a state. Returns whether it completes the revision; then assembled() has its services.
  [[nodiscard]] bool assemble(const announcement::Announcement& part) { return assembly_.made().add(part); }
  [[nodiscard]] const std::vector<ServiceNumber>& assembled() const { return assembly_->services(); }
  void forget_parts() { assembly_.reset(); }
  /// The highest sequence number.
  [[nodiscard]] std::uint64_t newest() const { return losses_.newest(); }

  bool is_vouched = false;               ///< a word from its address is a sign of life
  base::Instant deadline;                ///< when the way is lost unless it is heard again
  std::optional<std::uint64_t> goodbye;  ///< the number of a goodbye that was heard here

 private:
  /// Another source address that speaks in the name of this way.
  struct Mover {
    std::string source;
    std::uint64_t sequence = 0;
  };
  /// The address that the way belonged to.
  struct Home {
    std::string source;
    std::uint64_t sequence = 0;
    base::Instant left;
    Revocable<std::vector<std::string>> addresses;  ///< the addresses that were believed then
  };
  void move(const Arrival& arrival, base::Duration hold);

  Path path_;
  bool is_relayed_;
  bool is_heard_alone_;
  base::Instant opened_;
  std::string source_;
  base::Rare<Home> home_;
  base::Rare<Mover> mover_;
  bool was_misled_ = false;  ///< it moved, and the address that it left went on speaking
  bool has_moved_ = false;   ///< it moved and was not heard since: its next addresses are new
  Revocable<std::vector<std::string>> addresses_;
  LossWindow losses_;
  RisingCount sequences_;
  std::uint64_t revision_;  ///< the last one heard here
  /// The revision of the last state; none: the way was opened by a presence, which says nothing of the way.
  std::optional<std::uint64_t> said_revision_;
  std::optional<std::uint32_t> part_count_;  ///< of that state; nothing: changes led to it, so it was not said
  std::optional<std::uint64_t> leap_;        ///< the sequence number of a datagram whose revision leapt
  base::Rare<StateAssembly> assembly_;       ///< of a state of which not all parts were heard
};

/// An address with the interface that it is valid on.
struct ZonedAddress {
  std::string address;
  std::string zone;
};
/// The address of the best rank (address_rank()) on these ways. Of equals the one in use is preferred, then the first.
/// None: no way has an address.
[[nodiscard]] std::optional<ZonedAddress> best_address(std::span<const NeighbourWay> ways, std::string_view in_use,
                                                       std::string_view zone);

}  // namespace geminga::membership

#endif
