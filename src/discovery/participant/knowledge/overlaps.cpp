// Asking, remembering, and letting wait.
#include "discovery/participant/knowledge/overlaps.hpp"

#include <algorithm>
#include <utility>

namespace geminga::participant {

using matching::OverlapAnswer;

Overlaps::Memory& Overlaps::memory_of(const Vocabulary& vocabulary) {
  if (!memories_[last_].ontology.is_of(vocabulary)) {
    last_ = 1 - last_;
    if (!memories_[last_].ontology.is_of(vocabulary)) {
      memories_[last_] = {.ontology = vocabulary::OntologyMark(vocabulary), .by_request = {}, .size = 0};
    }
  }
  return memories_[last_];
}

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

void Overlaps::remember(Memory& memory, const std::string& requested, vocabulary::ClassNumber offered,
                        OverlapAnswer answer) {
  Answers& answers = memory.by_request[requested];
  answers.used = ++uses_;
  answers.by_offer.emplace(offered, std::move(answer));
  if (++memory.size <= max_remembered_overlaps) return;
  const auto oldest =
      std::ranges::min_element(memory.by_request, {}, [](const auto& entry) { return entry.second.used; });
  memory.size -= oldest->second.by_offer.size();
  memory.by_request.erase(oldest);
}

OverlapAnswer Overlaps::answer(const Vocabulary& vocabulary, vocabulary::ClassNumber offered,
                               const SemanticIdentity& requested, const matching::Classes& classes,
                               std::optional<ParticipantId> from, base::Instant now) {
  Memory& memory = memory_of(vocabulary);
  if (const auto about = memory.by_request.find(requested.concept_iri); about != memory.by_request.end()) {
    about->second.used = ++uses_;
    const auto& known = about->second.by_offer;
    if (const auto found = known.find(offered); found != known.end()) return found->second;
    if (known.size() == max_overlaps_of_request) {
      static const auto too_many = std::make_shared<const vocabulary::Overlap>(vocabulary::Overlap{
          .reason = "more than " + std::to_string(max_overlaps_of_request) + " concepts are offered"});
      return too_many;
    }
  }
  if (!take_quota(from, now)) return nullptr;
  OverlapAnswer found = matching::decided_at_once(vocabulary, offered, requested, classes);
  ++counts_.decided;
  if (found->verdict == vocabulary::Overlap::Verdict::undecided) ++counts_.undecided;
  remember(memory, requested.concept_iri, offered, found);
  return found;
}

}  // namespace geminga::participant
