// Asking, remembering, and letting wait.
#include "discovery/participant/knowledge/overlaps.hpp"

#include <memory>
#include <string>
#include <utility>

namespace geminga::participant {

using matching::ComparisonAnswer;
using matching::Meaning;
using matching::OverlapAnswer;

bool Overlaps::take_quota(std::optional<ParticipantId> from, base::Instant now) {
  if (left_ == 0) {
    is_waiting_ = true;
  } else if (from && !quota_.take(*from, now)) {
    if (!waiting_since_) waiting_since_ = now;
  } else {
    --left_;
    return true;
  }
  ++counts_.postponed;
  return false;
}

bool Overlaps::take_waiting(base::Instant now) {
  const bool is_second_over = waiting_since_ && now - *waiting_since_ >= RemoteQuota::second;
  if (is_second_over) waiting_since_.reset();
  return std::exchange(is_waiting_, false) || is_second_over;
}

OverlapAnswer Overlaps::answer(const Vocabulary& vocabulary, const Meaning& offered, const Meaning& requested,
                               std::optional<ParticipantId> from, base::Instant now) {
  if (auto known = overlaps_.find(vocabulary, offered, requested.identity)) return known;
  if (overlaps_.count(vocabulary, requested.identity) >= max_overlaps_of_request) {
    static const auto too_many = std::make_shared<const vocabulary::Overlap>(vocabulary::Overlap{
        .reason = "more than " + std::to_string(max_overlaps_of_request) + " concepts are offered"});
    return too_many;
  }
  if (!take_quota(from, now)) return nullptr;
  OverlapAnswer found = matching::decided_at_once(vocabulary, offered, requested);
  ++counts_.decided;
  if (found->verdict == vocabulary::Overlap::Verdict::undecided) ++counts_.undecided;
  overlaps_.put(vocabulary, offered, requested.identity, found);
  return found;
}

ComparisonAnswer Overlaps::compare(const Vocabulary& vocabulary, const Meaning& offered, const Meaning& requested,
                                   std::optional<ParticipantId> from, base::Instant now) {
  if (const auto by_place = vocabulary.compare(*offered.classes.place, *requested.classes.place)) {
    return std::make_shared<const vocabulary::Comparison>(*by_place);
  }
  if (auto known = comparisons_.find(vocabulary, offered, requested.identity)) return known;
  if (!take_quota(from, now)) return nullptr;
  ComparisonAnswer found = matching::compared_at_once(vocabulary, offered, requested);
  ++counts_.decided;
  comparisons_.put(vocabulary, offered, requested.identity, found);
  return found;
}

}  // namespace geminga::participant
