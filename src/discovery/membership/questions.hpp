// Whose state is lacked, and of whom it is doubted that he lives: what the next presence is to say of them.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_QUESTIONS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_QUESTIONS_HPP

#include <set>

#include "base/time.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "discovery/membership/records.hpp"
#include "discovery/membership/strangers.hpp"

namespace geminga::membership {

class Questions {
 public:
  /// Something has happened to a known participant.
  void update(ParticipantId id, const NeighbourRecord& record, base::Instant now);
  /// Something that it said had to give way.
  void note_short(ParticipantId id) { named_.insert(id); }
  /// It is not known any more.
  void forget(ParticipantId id);
  /// The presence of somebody whose state is not known was heard; or his state.
  void hear_stranger(ParticipantId id, base::Instant now) { strangers_.hear(id, now); }
  void forget_stranger(ParticipantId id) { strangers_.forget(id); }

  /// Whether somebody is lacked of whom it is to be said at once; or doubted.
  [[nodiscard]] bool lacks_anybody(base::Instant now) { return strangers_.prune(now) || !missed_.empty(); }
  [[nodiscard]] bool doubts_anybody() const { return !doubted_.empty(); }
  [[nodiscard]] const std::set<ParticipantId>& doubted() const { return doubted_; }
  /// Names them in a report; who is doubted counts as asked. Strangers have places of their own, and each report begins
  /// where the last one had no room, so nobody can fill all places for good.
  void name(Records& records, base::Instant now, Report& report);

 private:
  std::set<ParticipantId> missed_;
  std::set<ParticipantId> doubted_;
  std::set<ParticipantId> named_;  ///< doubted, or lacked, be it said at once or when we speak anyway
  Strangers strangers_;
  ParticipantId next_{};  ///< with whom the next report begins
};

}  // namespace geminga::membership

#endif
