// All known participants, by identifier.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_RECORDS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_RECORDS_HPP

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "discovery/membership/admission/admission.hpp"
#include "discovery/membership/neighbour/neighbour_record.hpp"
#include "discovery/membership/timetable.hpp"

namespace geminga::membership {

/// One known participant, with its entries in the other parts of the table.
struct Known {
  std::unique_ptr<NeighbourRecord> record;
  Slot slot{};  ///< when its record has something to do
  Admission::Member* member = nullptr;
  int heard = 0;  ///< its last datagrams on all ways that were heard
  int span = 0;   ///< all its last datagrams
};

/// A map that is searched for every datagram, through a flat list of identifiers.
class Records {
 public:
  using Map = std::map<ParticipantId, Known>;
  using value_type = Map::value_type;
  using iterator = Map::iterator;

  [[nodiscard]] iterator begin() { return map_.begin(); }
  [[nodiscard]] iterator end() { return map_.end(); }
  [[nodiscard]] Map::const_iterator begin() const { return map_.begin(); }
  [[nodiscard]] Map::const_iterator end() const { return map_.end(); }
  [[nodiscard]] std::size_t size() const { return map_.size(); }
  [[nodiscard]] iterator find(ParticipantId id);
  [[nodiscard]] const NeighbourRecord* record(ParticipantId id) const;

  iterator add(ParticipantId id, Known known);
  void erase(iterator one);
  /// Counts its losses anew. Call when something of it was heard.
  void count(Known& known);
  /// Counts that a record has another name or ontology.
  void note_change() { ++roster_; }
  /// Counts every add(), erase() and note_change().
  [[nodiscard]] std::uint64_t roster() const { return roster_; }
  /// The share of all participants' last datagrams that was lost, in [0, 1); nothing: too few were heard.
  [[nodiscard]] std::optional<double> loss() const;

 private:
  [[nodiscard]] std::size_t index_of(ParticipantId id) const;

  Map map_;
  std::vector<ParticipantId> ids_;  ///< ascending
  std::vector<iterator> found_;     ///< in the same order
  int heard_ = 0;                   ///< of all participants
  int span_ = 0;
  std::uint64_t roster_ = 0;
};

}  // namespace geminga::membership

#endif
