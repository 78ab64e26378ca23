// All known participants, by identifier.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_RECORDS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_RECORDS_HPP

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "discovery/membership/admission.hpp"
#include "discovery/membership/neighbour_record.hpp"
#include "discovery/membership/timetable.hpp"

namespace geminga::membership {

/// One known participant, with what the parts of the table have to do with it.
struct Known {
  std::unique_ptr<NeighbourRecord> record;
  Slot slot{};                        ///< when something is to be done for it
  Admission::Place* place = nullptr;  ///< among those who have one
  int heard = 0;                      ///< of its last datagrams on all ways
  int span = 0;                       ///< how many there were of them
};

/// A map that is looked into with every datagram: found by a flat list of identifiers.
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
  /// To be called when something of it was heard.
  void count(Known& known);
  /// The share of all participants' last datagrams that was lost, in [0, 1); nothing: too few were heard.
  [[nodiscard]] std::optional<double> loss() const;

 private:
  [[nodiscard]] std::size_t place_of(ParticipantId id) const;

  Map map_;
  std::vector<ParticipantId> ids_;  ///< ascending
  std::vector<iterator> found_;     ///< in the same order
  int heard_ = 0;                   ///< of all of them
  int span_ = 0;
};

}  // namespace geminga::membership

#endif
