#include "discovery/relaying/voucher.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/assert.hpp"
#include "base/hash.hpp"
#include "discovery/announcement/codec.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::relaying {
namespace {

using announcement::Announcement;

/// The session and the counter of a word. One that is not sealed has the numbers of its sender's process on its link.
std::pair<sealing::Session, std::uint32_t> identity_of(const sealing::Opened& opened, const Announcement& said) {
  if (opened.session) return {*opened.session, opened.counter};
  const std::array<std::uint64_t, 2> sender{std::to_underlying(said.boot), said.link};
  return {sealing::Session(base::hash64(base::octets_of(std::span<const std::uint64_t>(sender)), 0)),
          static_cast<std::uint32_t>(said.sequence)};
}

}  // namespace

bool Voucher::note(const sealing::Opened& opened, const Announcement& said, base::Instant now) {
  const auto [session, counter] = identity_of(opened, said);
  if (words_.take(session, counter, now)) return true;
  refuse(Refusal::repeated);
  return false;
}

std::expected<const Announcement*, Refusal> Voucher::unwrap(const Announcement& relayed, ParticipantId self,
                                                            base::Instant now) {
  const auto& through = relayed.relayed.through;
  const auto no = [&](Refusal refusal) { return std::unexpected(refuse(refusal)); };
  if (std::ranges::find(through, self) != through.end()) return no(Refusal::looped);
  const auto opened = seal_.open_vouched(relayed.relayed.word);
  if (!opened) return no(opened.error() == sealing::Rejection::own ? Refusal::own : Refusal::unreadable);
  if (announcement::decode(opened->text, said_)) return no(Refusal::unreadable);
  if (!is_passed_on(said_.kind)) return no(Refusal::other_kind);
  const auto [session, counter] = identity_of(*opened, said_);
  if (!words_.take(session, counter, now)) return no(Refusal::repeated);
  return &said_;
}

std::expected<Announcement, Refusal> Voucher::wrap(const Word& word, ParticipantId self) {
  GEMINGA_ASSERT(self != ParticipantId{});
  if (word.through.size() >= announcement::max_hops) return std::unexpected(refuse(Refusal::too_far));
  if (word.datagram.empty() || word.datagram.size() > announcement::max_word_bytes)
    return std::unexpected(refuse(Refusal::too_large));
  Announcement relayed;
  relayed.kind = announcement::Kind::relayed;
  relayed.participant = self;
  relayed.relayed.word.assign(word.datagram.begin(), word.datagram.end());
  relayed.relayed.age = word.age;
  relayed.relayed.through.assign(word.through.begin(), word.through.end());
  relayed.relayed.through.push_back(self);
  relayed.relayed.source = word.source.substr(0, word.source.find('%'));
  return relayed;
}

Refusal Voucher::refuse(Refusal refusal) {
  ++refused_.at(static_cast<std::size_t>(refusal));
  return refusal;
}

}  // namespace geminga::relaying
