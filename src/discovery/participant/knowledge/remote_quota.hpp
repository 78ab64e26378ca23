// A quota for work that other participants ask for: how much in a second each of them may cause, and all together.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_REMOTE_QUOTA_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_REMOTE_QUOTA_HPP

#include <cstddef>
#include <map>

#include "base/time.hpp"
#include "discovery/announcement/limits.hpp"
#include "geminga/service.hpp"

namespace geminga::participant {

class RemoteQuota {
 public:
  static constexpr base::Duration second = std::chrono::seconds(1);

  RemoteQuota(std::size_t of_participant, std::size_t of_all) : of_participant_(of_participant), of_all_(of_all) {}

  /// Counts one piece of work. False where it exceeds the quota of this second.
  bool take(ParticipantId from, base::Instant now) {
    if (windows_.size() > announcement::max_participants) {
      std::erase_if(windows_, [&](const auto& entry) { return now - entry.second.begin >= second; });
    }
    return count(windows_[from], of_participant_, now) && count(all_, of_all_, now);
  }

 private:
  struct Window {
    base::Instant begin{};
    std::size_t seen = 0;
  };
  static bool count(Window& window, std::size_t limit, base::Instant now) {
    if (now - window.begin >= second) window = {.begin = now, .seen = 0};
    if (window.seen >= limit) return false;
    ++window.seen;
    return true;
  }

  std::size_t of_participant_;
  std::size_t of_all_;
  std::map<ParticipantId, Window> windows_;
  Window all_;
};

}  // namespace geminga::participant

#endif
