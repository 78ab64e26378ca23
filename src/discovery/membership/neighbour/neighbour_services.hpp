// The services of one participant, as far as it is believed, and what of them was told.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_NEIGHBOUR_SERVICES_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_NEIGHBOUR_SERVICES_HPP

#include <boost/container/flat_map.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/time.hpp"
#include "discovery/membership/neighbour/arrival.hpp"
#include "discovery/membership/neighbour/change.hpp"
#include "discovery/membership/neighbour/offer.hpp"
#include "discovery/membership/neighbour/revocable.hpp"
#include "discovery/membership/neighbour/service_room.hpp"
#include "discovery/membership/neighbour/state_assembly.hpp"

namespace geminga::membership {

/// The owner of the services: what every change says of the participant.
struct Owner {
  ParticipantId id{};
  std::string name;
  std::string address;       ///< for services that have none
  std::string zone;          ///< of link-local addresses
  bool is_reachable = true;  ///< `address`, from here
};

/// The time of a call, and how the participant stands at that time.
struct Moment {
  base::Instant now;
  base::Instant deadline;  ///< of a service that is heard now
  base::Duration hold;     ///< how long something that was said stands against something else
  base::Duration refresh;  ///< a service that was refreshed less than this ago is not refreshed
  bool is_contested = false;
  bool is_complete = false;  ///< any datagram of the revision proves that everything is as it was
  bool is_heard = true;      ///< the call takes in a datagram
};

/// Each call appends its changes to the list that it is given.
class NeighbourServices {
 public:
  NeighbourServices(Owner owner, ServiceRoom& room);
  ~NeighbourServices();
  NeighbourServices(const NeighbourServices&) = delete;
  NeighbourServices& operator=(const NeighbourServices&) = delete;

  /// Whether a datagram contradicts another one of the same revision. `complete`: the services of that revision, if all
  /// its parts have been heard; else null.
  [[nodiscard]] bool denies(const announcement::Announcement& announcement,
                            const std::vector<ServiceNumber>* complete) const;
  /// Takes in the services of one datagram. While the participant is contested, a service stays as it is while it is
  /// held.
  void apply(const announcement::Announcement& announcement, const Moment& moment, std::vector<Change>& changes);
  /// Withdraws the services that are not in the list, which is in ascending order.
  void withdraw_absent(const std::vector<ServiceNumber>& present, const Moment& moment, std::vector<Change>& changes);
  /// Withdraws the services that a change removes.
  void withdraw_removed(const announcement::Announcement& change, const Moment& moment, std::vector<Change>& changes);
  /// Withdraws the services that are not held. Returns when the next one will not be held, or a later time.
  base::Instant lapse(const Moment& moment, std::vector<Change>& changes);
  /// Removes services that have their deadline at or before now.
  void expire(const Moment& moment, std::vector<Change>& changes);
  /// Undoes what was changed or withdrawn less than `hold` ago. `affirmed`: when all services were last proved to be
  /// there.
  void roll_back(base::Instant affirmed, const Moment& moment, std::vector<Change>& changes);
  /// Removes one service to make room for another participant; false: there is none beyond the reserve.
  bool give_way(std::vector<Change>& changes);
  /// Tells what has changed. While not all parts are known it also tells again, at most once each `refresh`, what was
  /// heard again.
  void tell(const Moment& moment, std::vector<Change>& changes);
  /// Lets tell() tell all services as new ones: the participant was removed and is back.
  void forget_told();
  void clear();
  /// Makes every deadline at most this one.
  void shorten(base::Instant deadline);

  void set_name(const std::string& name);
  void set_address(const std::string& address, const std::string& zone);
  void set_reachable(bool is_reachable);
  [[nodiscard]] const Owner& owner() const { return owner_; }

  /// Whether a service found no room, since the first part of the last state.
  [[nodiscard]] bool is_short() const { return is_short_; }
  [[nodiscard]] std::size_t size() const { return present_; }
  [[nodiscard]] std::size_t publications() const;
  /// When expire() has something to do.
  [[nodiscard]] base::Instant earliest_deadline();

 private:
  enum class Told : std::uint8_t { nothing, publication, subscription };
  struct Entry {
    Revocable<SharedOffer> offer;  ///< null: withdrawn, and remembered in case that was a lie
    std::uint64_t revision = 0;    ///< the revision that said so
    base::Instant heard;
    base::Instant deadline;
    bool is_changed = true;  ///< the caller does not know it as it is
    Told told = Told::nothing;
  };
  using Entries = boost::container::flat_map<ServiceNumber, Entry>;

  [[nodiscard]] bool denies_removal(const announcement::Announcement& change,
                                    const std::vector<ServiceNumber>* complete) const;
  template <typename Visit>
  static void for_each_service(const announcement::Announcement& announcement, Visit visit);
  template <typename Service>
  void apply_one(ServiceNumber number, const Service& service, const std::string& peer_name, std::uint64_t revision,
                 const Moment& moment, std::vector<Change>& changes);
  /// Applies `affirmed_` to the services.
  void catch_up();
  template <typename Service>
  [[nodiscard]] SharedOffer shared(ServiceNumber number, const Service& service, const std::string& peer_name) const;
  template <typename Service>
  void add(ServiceNumber number, const Service& service, const std::string& peer_name, std::uint64_t revision,
           const Moment& moment);
  [[nodiscard]] bool take_room();
  void untell(ServiceNumber number, Entry& entry, Departure reason, std::vector<Change>& changes) const;
  Entries::iterator withdraw(const Entries::iterator& position, const Moment& moment, Departure reason,
                             std::vector<Change>& changes);
  Entries::iterator drop(const Entries::iterator& position);
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
  base::Instant refreshed_;  ///< when tell() last refreshed all services, or would have
  /// All present services were affirmed at an instant, which is not applied yet.
  struct Affirmed {
    base::Instant at;
    base::Instant deadline;
    base::Duration refresh;  ///< zero: applies to all; else to services that were not heard within it
  };
  std::optional<Affirmed> affirmed_;
};

}  // namespace geminga::membership

#endif
