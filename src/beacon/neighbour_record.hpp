// Everything the neighbour table keeps of one participant: its ways, its services and their deadlines.
#ifndef GEMINGA_BEACON_NEIGHBOUR_RECORD_HPP
#define GEMINGA_BEACON_NEIGHBOUR_RECORD_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "base/time.hpp"
#include "beacon/loss_window.hpp"
#include "beacon/neighbour_table.hpp"
#include "beacon/state_assembly.hpp"

namespace geminga::beacon {

/// A share of the room for remote services that all records take from.
struct ServiceRoom {
  std::size_t taken = 0;
  std::uint64_t refused = 0;
};

/// One known participant. Appends what changes to the list it is given; deciding whether a datagram counts at all
/// (group, boot, goodbyes) is the table's.
class NeighbourRecord {
 public:
  NeighbourRecord(const Announcement& first, ServiceRoom& room);
  ~NeighbourRecord();
  NeighbourRecord(const NeighbourRecord&) = delete;
  NeighbourRecord& operator=(const NeighbourRecord&) = delete;

  [[nodiscard]] BootNonce boot() const { return boot_; }
  /// Whether this nonce belongs to an earlier life of the participant.
  [[nodiscard]] bool is_retired(BootNonce boot) const;
  /// The participant has started anew: its services stay until the new state is complete, its ways and counters do not.
  void restart(BootNonce boot);

  /// Takes in a state announcement of the current boot.
  void hear(const Announcement& announcement, const Arrival& arrival, std::vector<Change>& changes);
  /// Drops ways and services that have their deadline at or before `now`; the participant itself is the table's.
  void expire(base::Instant now, std::vector<Change>& changes);
  void forget_interface(env::InterfaceIndex interface, std::vector<Change>& changes);

  [[nodiscard]] base::Instant deadline() const { return deadline_; }
  /// When expire() has something to do.
  [[nodiscard]] base::Instant next_deadline() const;
  [[nodiscard]] Neighbour snapshot() const;

 private:
  struct Way {
    Path path;
    std::uint64_t revision = 0;  ///< of the announcement that its addresses are from
    LossWindow losses;
    StateAssembly assembly;
  };
  struct Entry {
    std::variant<Publication, Subscription> service;  ///< as announced
    std::string peer_name;
    base::Instant heard;
    base::Instant deadline;
    bool is_changed = true;  ///< the caller has not been told of it as it is now
    bool is_present = true;  ///< in the part that is being taken in
  };

  [[nodiscard]] base::Instant way_deadline(const Way& way) const;
  Way* find_way(const Announcement& announcement, const Arrival& arrival);
  void hear_on(Way& way, const Announcement& announcement, const Arrival& arrival);
  void update_header(const Announcement& announcement);
  /// Picks the address for services without one; marks what is changed by it.
  void choose_address();
  void remove_absent(const std::vector<ServiceNumber>& present, std::vector<Change>& changes);
  template <typename Service>
  void apply(ServiceNumber number, const Service& service, const std::string& peer_name, std::vector<Change>& changes);
  void apply_part(const Announcement& announcement, std::vector<Change>& changes);
  /// Tells what has changed, and again what was heard of and not told for a while.
  void tell(base::Instant now, std::vector<Change>& changes);
  void put(ServiceNumber number, const Entry& entry, std::vector<Change>& changes) const;
  [[nodiscard]] std::string effective_address(const std::string& announced) const;
  [[nodiscard]] bool depends_on_way(const Entry& entry) const;
  [[nodiscard]] ServiceKey key(ServiceNumber number) const { return {id_, number.peer, number.number}; }
  [[nodiscard]] base::Duration refresh_time() const;
  [[nodiscard]] double loss() const;

  ParticipantId id_;
  BootNonce boot_;
  std::vector<BootNonce> retired_;
  std::string name_;
  std::uint64_t ontology_digest_ = 0;
  base::Duration interval_{};
  base::Instant heard_;
  base::Instant deadline_;
  std::uint64_t revision_ = 0;  ///< the newest one heard
  bool is_complete_ = false;
  std::vector<Way> ways_;
  std::string address_;
  std::string zone_;  ///< of the way that the address was chosen from
  std::map<ServiceNumber, Entry> entries_;
  ServiceRoom& room_;
};

}  // namespace geminga::beacon

#endif
