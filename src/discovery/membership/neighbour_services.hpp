// What one participant offers and asks for, as far as it is believed, and what of it has been told.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_SERVICES_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_SERVICES_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/time.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "discovery/membership/service_room.hpp"
#include "discovery/membership/settled.hpp"
#include "discovery/membership/state_assembly.hpp"

namespace geminga::membership {

/// Whose services they are: what every change says of the participant.
struct Owner {
  ParticipantId id{};
  std::string name;
  std::string address;  ///< for services that have none
  std::string zone;     ///< of link-local addresses
};

/// When something is done to services.
struct Moment {
  base::Instant now;
  base::Instant deadline;  ///< of what is heard of now
  base::Duration hold;     ///< how long a word counts against another one
  base::Duration refresh;  ///< what was told less than this ago is not told again
  bool is_contested = false;
  bool is_complete = false;  ///< one datagram of the revision proves that all is as it was
  bool is_heard = true;      ///< a datagram is being taken in
};

/// The services of one participant. All changes go to the list that a call is given.
class NeighbourServices {
 public:
  NeighbourServices(Owner owner, ServiceRoom& room);
  ~NeighbourServices();
  NeighbourServices(const NeighbourServices&) = delete;
  NeighbourServices& operator=(const NeighbourServices&) = delete;

  /// Whether a datagram says something else of a service than another one of the same revision did. `complete`: the
  /// services of that revision, if all its parts have been heard.
  [[nodiscard]] bool denies(const announcement::Announcement& announcement,
                            const std::vector<ServiceNumber>* complete) const;
  /// Takes in the services of one datagram. While the participant is contested, a service that is there stays as it is
  /// for as long as it is held.
  void apply(const announcement::Announcement& announcement, const Moment& moment, std::vector<Change>& changes);
  /// Withdraws what is not in the list, which is in ascending order.
  void withdraw_absent(const std::vector<ServiceNumber>& present, const Moment& moment, std::vector<Change>& changes);
  /// Withdraws what a change says that it is no more.
  void withdraw_removed(const announcement::Announcement& change, const Moment& moment, std::vector<Change>& changes);
  /// Withdraws what is not held any more; when the next one will not be, or later.
  base::Instant lapse(const Moment& moment, std::vector<Change>& changes);
  /// Removes what has its deadline at or before now.
  void expire(const Moment& moment, std::vector<Change>& changes);
  /// Undoes what was changed or withdrawn less than `hold` ago. `affirmed`: when all services were last proved to be
  /// there.
  void roll_back(base::Instant affirmed, const Moment& moment, std::vector<Change>& changes);
  /// Removes one service to make room for somebody else's; false: there is nothing beyond the reserve.
  bool give_way(std::vector<Change>& changes);
  /// Tells what has changed; and again what was heard of and not told for a while, if the room wants that or not all is
  /// known.
  void tell(const Moment& moment, std::vector<Change>& changes);
  /// The participant was removed and is back: tells all of its services again, as new ones.
  void forget_told();
  void clear();
  /// No deadline is later than this.
  void shorten(base::Instant deadline);

  void set_name(const std::string& name);
  void set_address(const std::string& address, const std::string& zone);
  [[nodiscard]] const Owner& owner() const { return owner_; }

  /// Whether something that was said had no room, since the last state that was taken in whole.
  [[nodiscard]] bool is_short() const { return is_short_; }
  [[nodiscard]] std::size_t size() const { return present_; }
  [[nodiscard]] std::size_t publications() const;
  /// When expire() has something to do.
  [[nodiscard]] base::Instant earliest_deadline();

 private:
  struct Offer {
    std::variant<Publication, Subscription> service;  ///< as announced
    std::string peer_name;
    friend bool operator==(const Offer&, const Offer&) = default;
  };
  enum class Told : std::uint8_t { nothing, publication, subscription };
  struct Entry {
    Settled<std::optional<Offer>> offer;  ///< nothing: withdrawn, and remembered in case that was a lie
    std::uint64_t revision = 0;           ///< that said so
    base::Instant heard;
    base::Instant deadline;
    bool is_changed = true;  ///< the caller has not been told of it as it is now
    Told told = Told::nothing;
  };
  using Entries = std::map<ServiceNumber, Entry>;

  [[nodiscard]] bool denies_removal(const announcement::Announcement& change,
                                    const std::vector<ServiceNumber>* complete) const;
  template <typename Visit>
  static void for_each_service(const announcement::Announcement& announcement, Visit visit);
  template <typename Service>
  void apply_one(ServiceNumber number, const Service& service, const std::string& peer_name, std::uint64_t revision,
                 const Moment& moment, std::vector<Change>& changes);
  /// Whether what was heard again is told again: who knows when all was affirmed need not be told of each.
  [[nodiscard]] bool tells_again(const Moment& moment) const { return room_.tells_affirmed() || !moment.is_complete; }
  /// Enters what was affirmed.
  void catch_up();
  void add(ServiceNumber number, Offer offer, std::uint64_t revision, const Moment& moment);
  [[nodiscard]] bool take_room();
  void untell(ServiceNumber number, Entry& entry, Departure reason, std::vector<Change>& changes) const;
  Entries::iterator withdraw(Entries::iterator position, const Moment& moment, Departure reason,
                             std::vector<Change>& changes);
  Entries::iterator drop(Entries::iterator position);
  void forget_withdrawn();
  void put(ServiceNumber number, Entry& entry, std::vector<Change>& changes) const;
  [[nodiscard]] std::string effective_address(const std::string& announced) const;
  [[nodiscard]] static bool depends_on_way(const Offer& offer);
  [[nodiscard]] ServiceKey key(ServiceNumber number) const { return {owner_.id, number.peer, number.number}; }

  Owner owner_;
  ServiceRoom& room_;
  Entries entries_;
  std::size_t present_ = 0;
  bool is_short_ = false;
  bool has_changes_ = false;
  base::Instant refreshed_;  ///< when tell() last looked at all, or would have
  /// All that is there was affirmed at an instant, which is not entered yet.
  struct Affirmed {
    base::Instant at;
    base::Instant deadline;
    base::Duration refresh;  ///< zero: of all; else of what was not heard of within it
  };
  std::optional<Affirmed> affirmed_;
};

}  // namespace geminga::membership

#endif
