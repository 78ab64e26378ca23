// The participants that our next presence names: those whose state we lack, and those that we doubt to be alive.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_LACKS_AND_DOUBTS_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_LACKS_AND_DOUBTS_HPP

#include <set>

#include "base/time.hpp"
#include "discovery/membership/records.hpp"
#include "discovery/membership/report.hpp"
#include "discovery/membership/strangers.hpp"

namespace geminga::membership {

class LacksAndDoubts {
 public:
  /// Takes in that a known participant has changed.
  void update(ParticipantId id, const NeighbourRecord& record, base::Instant now);
  /// Takes in that one of its services had to give way to others.
  void note_short(ParticipantId id) { named_.insert(id); }
  /// Forgets a participant that is gone.
  void forget(ParticipantId id);
  /// Takes in the presence of a participant whose state is not known; or its state.
  void hear_stranger(ParticipantId id, base::Instant now) { strangers_.hear(id, now); }
  void forget_stranger(ParticipantId id) { strangers_.forget(id); }

  /// Whether the state of a participant is lacked that is to be named at once.
  [[nodiscard]] bool lacks_anybody(base::Instant now) { return strangers_.prune(now) || !missed_.empty(); }
  [[nodiscard]] bool doubts_anybody() const { return !doubted_.empty(); }
  [[nodiscard]] const std::set<ParticipantId>& doubted() const { return doubted_; }
  /// Names them in a report. A doubted participant counts as asked by it. Strangers have places of their own, and each
  /// report begins where the last one had no room, so nobody can fill all places for good.
  void name(Records& records, base::Instant now, Report& report);

 private:
  std::set<ParticipantId> missed_;
  std::set<ParticipantId> doubted_;
  std::set<ParticipantId> named_;  ///< doubted, or lacked, whether it is to be named at once or not
  Strangers strangers_;
  ParticipantId next_{};  ///< where the next report begins
};

}  // namespace geminga::membership

#endif
