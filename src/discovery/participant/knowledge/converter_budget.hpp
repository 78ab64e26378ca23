// The budget of changes to converters: how many a participant may make in a second, and all of them together.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_CONVERTER_BUDGET_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_CONVERTER_BUDGET_HPP

#include <algorithm>
#include <map>

#include "base/time.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/matching/conversions/consumer.hpp"
#include "geminga/service.hpp"

namespace geminga::participant {

/// Changes to converters of one participant that count at once, so that a host with all its converters may start and
/// start again, and how many more in a second. A change concerns all requests that convert, whoever makes it.
inline constexpr int converter_burst = 2 * static_cast<int>(matching::max_converters_of_participant);
inline constexpr int converter_changes_per_second = 4;
/// The same for all other participants together: all converters that may take part may come at once.
inline constexpr int converter_burst_of_all = 2 * static_cast<int>(matching::max_remote_converters);
inline constexpr int converter_changes_per_second_of_all = 64;

/// Says when a participant may change another converter. A change beyond the budget waits, and of several changes of
/// one converter only the last one counts then.
class ConverterBudget {
 public:
  /// The earliest time of the next change; it need not be later than now.
  [[nodiscard]] base::Instant next(ParticipantId participant) const {
    const auto known = of_participant_.find(participant);
    const base::Instant own = known == of_participant_.end() ? base::Instant{} : known->second - burst * period;
    return std::max(own, all_ - burst_of_all * period_of_all);
  }
  /// Takes one change at `now`, which is no earlier than next().
  void take(ParticipantId participant, base::Instant now) {
    if (of_participant_.size() > announcement::max_participants) {
      std::erase_if(of_participant_, [&](const auto& entry) { return entry.second <= now; });
    }
    base::Instant& own = of_participant_[participant];
    own = std::max(own, now) + period;
    all_ = std::max(all_, now) + period_of_all;
  }

 private:
  static constexpr base::Duration period = base::Duration(std::chrono::seconds(1)) / converter_changes_per_second;
  static constexpr base::Duration period_of_all =
      base::Duration(std::chrono::seconds(1)) / converter_changes_per_second_of_all;
  static constexpr int burst = converter_burst - 1;
  static constexpr int burst_of_all = converter_burst_of_all - 1;

  /// When all that was taken would have been taken at the steady pace.
  std::map<ParticipantId, base::Instant> of_participant_;
  base::Instant all_{};
};

}  // namespace geminga::participant

#endif
