// Work in counted units, so that a turn can be bounded without measuring time, which a test could not repeat.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_WORK_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_WORK_HPP

#include <cstdint>

#include "base/time.hpp"

namespace geminga::matching {
class Matcher;
}

namespace geminga::participant {

class Expressions;
class Overlaps;

/// Units of work; one is about a microsecond on a slow robot.
using Work = std::uint64_t;

inline constexpr Work cost_of_statement = 10;
/// One entry of the registry looked at.
inline constexpr Work cost_of_entry = 1;
/// One class that an entry is filed under or taken out of when the ontology changes.
inline constexpr Work cost_of_filing = 1;
/// One publication compared with one subscription, its filter included.
inline constexpr Work cost_of_judgement = 2;
inline constexpr Work cost_of_answer_line = 10;
inline constexpr Work cost_of_event = 10;
/// A name that the ontology does not know: similar names are searched for.
inline constexpr Work cost_of_unknown_name = 400;
/// A class expression that was classified.
inline constexpr Work cost_of_expression = 1000;
/// A question to the reasoner whether two concepts can have instances in common.
inline constexpr Work cost_of_overlap = 500;

/// The bound on what one event does for clients, and on what it does because of other hosts; the rest is done in later
/// events. Smaller: other clients are served
/// sooner. Larger: less is spent on going round.
inline constexpr Work work_in_turn = 2000;
/// The bound on what one event does to change the ontology. With it and the two bounds above, what clients ask for and
/// what the air says, an event ends after 5000 units and one step of each.
inline constexpr Work work_in_change = 1000;
/// The bound on what is done for one client before the next is looked for.
inline constexpr Work work_in_step = 200;
/// The work of a client counts for half after this time. The client that used the least lately goes first.
inline constexpr base::Duration half_life = std::chrono::milliseconds(100);

/// All work done since the start, whoever caused it. The matcher and the reasoner count their own; the rest is added
/// where it is done.
class WorkMeter {
 public:
  /// Borrows all three for its life.
  WorkMeter(const matching::Matcher& matcher, const Expressions& expressions, const Overlaps& overlaps)
      : matcher_(matcher), expressions_(expressions), overlaps_(overlaps) {}

  void add(Work work) { added_ += work; }
  [[nodiscard]] Work done() const;

 private:
  const matching::Matcher& matcher_;
  const Expressions& expressions_;
  const Overlaps& overlaps_;
  Work added_ = 0;
};

}  // namespace geminga::participant

#endif
