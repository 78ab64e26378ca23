#include "discovery/relaying/recall.hpp"

#include <algorithm>
#include <optional>

#include "discovery/announcement/codec.hpp"

namespace geminga::relaying {

using announcement::Announcement;
using announcement::Kind;

bool Recall::take(std::span<const std::byte> envelope, base::Instant now) {
  const auto outer = seal_.open_vouched(envelope);
  if (!outer || !outer->session || announcement::decode(outer->text, wrapping_)) return false;
  const sealing::Session session = *outer->session;
  if (wrapping_.kind != Kind::relayed || wrapping_.relayed.through.back() != wrapping_.participant) return false;
  const auto inner = seal_.open_vouched(wrapping_.relayed.word);
  if (!inner || !inner->session || announcement::decode(inner->text, said_)) return false;
  if (said_.kind != Kind::state && said_.kind != Kind::change) return false;
  forget_old(now);
  const auto known = pending_.find({session, said_.participant});
  if (known != pending_.end()) {
    known->second.taken = now;
    // A word that is kept on is written again in a new envelope.
    if (std::ranges::find(known->second.words, inner->counter, &Pending::counter) != known->second.words.end())
      return true;
  }
  if (pending_count_ == max_pending_words) return false;
  Participant& participant = pending_[{session, said_.participant}];
  participant.relay = wrapping_.participant;
  participant.taken = now;
  participant.words.push_back({inner->counter, WordPlace::of(said_), wrapping_.relayed});
  ++pending_count_;
  return true;
}

std::vector<Announcement> Recall::recall(sealing::Session session, ParticipantId relay,
                                         const announcement::Behind& testimony) {
  const auto found = pending_.find({session, testimony.participant});
  if (found == pending_.end() || found->second.relay != relay || testimony.revision == 0) return {};
  auto& words = found->second.words;
  std::ranges::sort(words, {}, &Pending::counter);
  WordChain chain;
  for (const Pending& word : words) chain.add(word.place, {.relayed = word.relayed});
  if (!chain.leads_to(testimony.revision)) return {};
  std::vector<Announcement> recalled;
  for (const HeardWord& word : chain.words()) {
    Announcement& one = recalled.emplace_back();
    one.kind = Kind::relayed;
    one.participant = relay;
    one.relayed = word.relayed;
    one.relayed.age = testimony.age;
  }
  pending_count_ -= words.size();
  pending_.erase(found);
  return recalled;
}

void Recall::forget_old(base::Instant now) {
  if (pending_count_ < max_pending_words) return;
  std::erase_if(pending_, [&](const auto& one) {
    if (now - one.second.taken < pending_time) return false;
    pending_count_ -= one.second.words.size();
    return true;
  });
}

}  // namespace geminga::relaying
