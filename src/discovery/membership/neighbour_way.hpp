// One way on which a participant is heard: from which source address, with which numbers, and what it says of itself.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_WAY_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_WAY_HPP

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "discovery/membership/loss_window.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "discovery/membership/passed.hpp"
#include "discovery/membership/settled.hpp"
#include "discovery/membership/state_assembly.hpp"

namespace geminga::membership {

/// A way belongs to the source address that it was first heard from (ANNOUNCEMENT.md, "Who is believed").
class NeighbourWay {
 public:
  NeighbourWay(const announcement::Announcement& first, const Arrival& arrival);

  /// From whom a datagram on this way is.
  enum class Origin : std::uint8_t {
    bound,      ///< from the address that the way belongs to
    back,       ///< from the address that it belonged to: who has spoken since was somebody else
    copied,     ///< from another address, with a number that was heard: a copy
    elsewhere,  ///< from another address, which has not proved itself yet
  };
  /// `needs_silence`: the way is given to another address only after the present one was silent for `hold`.
  [[nodiscard]] Origin origin(const announcement::Announcement& announcement, const Arrival& arrival,
                              bool needs_silence, base::Duration hold);

  /// What the numbers of a datagram say about it.
  enum class Order : std::uint8_t {
    next,           ///< nothing speaks against it
    overtaken,      ///< sent before what was heard last: a sign of life and nothing else
    contradiction,  ///< no sender numbers its datagrams like this: this one or one before it is forged
  };
  [[nodiscard]] Order order(const announcement::Announcement& announcement, base::Instant now) const;
  /// Whether the revision is too far from `believed` to be taken at its first word.
  [[nodiscard]] bool leaps(const announcement::Announcement& announcement, std::uint64_t believed);
  /// Whether it says something else of this way than another datagram of the same revision did.
  [[nodiscard]] bool denies(const announcement::Announcement& announcement, const Arrival& arrival) const;

  /// Counts it in. `is_contradiction`: its number is where the sender is, whatever was heard before.
  void count(const announcement::Announcement& announcement, const Arrival& arrival, bool is_contradiction);
  /// Takes over what it says of the way, unless another word is held; whether addresses have changed.
  bool say(const announcement::Announcement& announcement, const Arrival& arrival, bool is_contested,
           base::Duration hold);
  /// Whether what is known of the way is what the state of its newest revision says.
  [[nodiscard]] bool is_said() const { return said_revision_ == revision_ && !has_moved_; }
  /// Takes in a presence, which says of the way what the state of its revision has said.
  void affirm(std::uint64_t revision, base::Instant now, bool is_contested) {
    revision_ = revision;
    if (revision == said_revision_ && !is_contested) addresses_.affirm(now);
  }
  /// Takes in a change: where the state of `since` or a later revision is known, that of `revision` is.
  void advance(std::uint64_t since, std::uint64_t revision, base::Instant now, bool is_contested) {
    if (said_revision_ && since <= *said_revision_ && *said_revision_ <= revision && !is_contested) {
      if (revision != *said_revision_) part_count_.reset();
      said_revision_ = revision;
    }
    affirm(revision, now, is_contested);
  }
  /// Undoes what was said less than `hold` ago.
  void roll_back(base::Instant now, base::Duration hold);

  [[nodiscard]] bool is_on(env::InterfaceIndex interface) const { return path_.interface == interface; }
  [[nodiscard]] env::InterfaceIndex interface() const { return path_.interface; }
  [[nodiscard]] std::uint32_t link() const { return path_.link; }
  [[nodiscard]] base::Instant opened() const { return opened_; }
  [[nodiscard]] const std::string& interface_name() const { return path_.interface_name; }
  [[nodiscard]] base::Instant heard() const { return path_.heard; }
  [[nodiscard]] Path path() const;
  [[nodiscard]] const std::string& source() const { return source_; }
  /// Whether it belonged to this address until a short while ago.
  [[nodiscard]] bool was_of(std::string_view source) const { return home_ && home_->source == source; }
  [[nodiscard]] const std::vector<std::string>& addresses() const { return addresses_.value(); }
  [[nodiscard]] bool is_next(std::uint64_t sequence) const { return losses_.is_empty() || sequence > losses_.newest(); }
  [[nodiscard]] bool has(std::uint64_t sequence) const { return losses_.has(sequence); }
  [[nodiscard]] double loss() const { return losses_.loss(); }
  [[nodiscard]] const LossWindow& losses() const { return losses_; }
  [[nodiscard]] StateAssembly& assembly() { return assembly_; }
  /// The highest sequence number.
  [[nodiscard]] std::uint64_t newest() const { return losses_.newest(); }

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
    Settled<std::vector<std::string>> addresses;  ///< what was believed then
  };
  void move(const Arrival& arrival, base::Duration hold);

  Path path_;
  base::Instant opened_;
  std::string source_;
  std::optional<Home> home_;
  std::optional<Mover> mover_;
  bool was_misled_ = false;  ///< it has moved, and the address that it left went on speaking
  bool has_moved_ = false;   ///< and has not been heard since: its addresses are new with it
  Settled<std::vector<std::string>> addresses_;
  LossWindow losses_;
  Passed passed_;
  std::uint64_t revision_;  ///< the last one heard here
  /// The last one of a state; none: the way was opened by a presence, which says nothing of the way.
  std::optional<std::uint64_t> said_revision_;
  std::optional<std::uint32_t> part_count_;  ///< of that state; nothing: it was reached by changes, and not said
  std::optional<std::uint64_t> leap_;        ///< sequence number of a datagram whose revision leapt
  StateAssembly assembly_;
};

/// An address with the interface that it is valid on.
struct ZonedAddress {
  std::string address;
  std::string zone;
};
/// The address of the best rank (address_rank()) on any of these ways; of equals the one in use, then the first. None:
/// no way has an address.
[[nodiscard]] std::optional<ZonedAddress> best_address(std::span<const NeighbourWay> ways, std::string_view in_use,
                                                       std::string_view zone);

}  // namespace geminga::membership

#endif
