// The order of participants, which gives each two bits their meaning.
#include "discovery/membership/witnesses.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "base/hash.hpp"
#include "discovery/membership/deadline.hpp"

namespace geminga::membership {
namespace {

using announcement::HeardWithin;
using base::Duration;
using base::Instant;

std::uint64_t fold_of(ParticipantId id, announcement::BootNonce boot) {
  const std::array<std::uint64_t, 2> numbers{std::to_underlying(id), std::to_underlying(boot)};
  return base::hash64(base::octets_of(std::span(numbers)));
}

HeardWithin heard_within(Duration age, Duration interval) {
  if (age > interval) return HeardWithin::longer;
  if (age > interval / 2) return HeardWithin::interval;
  return age > interval / 4 ? HeardWithin::half : HeardWithin::quarter;
}

/// How long ago somebody was heard at most who was heard so lately.
Duration age_of(HeardWithin within, Duration interval) {
  switch (within) {
    case HeardWithin::half:
      return interval / 2;
    case HeardWithin::quarter:
      return interval / 4;
    default:
      return interval;
  }
}

}  // namespace

void Witnesses::set_self(ParticipantId id, announcement::BootNonce boot) {
  self_ = id;
  self_fold_ = fold_of(id, boot);
}

Witnesses::Members::const_iterator Witnesses::find(ParticipantId id) const {
  return std::ranges::lower_bound(others_, id, {}, &Member::id);
}

void Witnesses::add(ParticipantId id, announcement::BootNonce boot) {
  others_.insert(find(id), Member{id, boot, {}, {}, {}, 0, {}});
  others_fold_ ^= fold_of(id, boot);
}

void Witnesses::remove(ParticipantId id) {
  const auto member = find(id);
  others_fold_ ^= fold_of(id, member->boot);
  others_.erase(member);
}

void Witnesses::update(ParticipantId id, Instant heard, Duration interval) {
  auto& member = others_[static_cast<std::size_t>(find(id) - others_.cbegin())];
  member.heard = heard;
  member.interval = interval;
}

std::uint16_t Witnesses::fold() const { return static_cast<std::uint16_t>(others_fold_ ^ self_fold_); }

HeardWithin Witnesses::testimony(const Member& member, Instant now) const {
  if (member.heard <= distrusted_until_) return HeardWithin::longer;
  return heard_within(now - member.heard, member.interval);
}

bool Witnesses::has_heard(ParticipantId id, Instant now) const {
  const auto member = find(id);
  const bool is_known = member != others_.cend() && member->id == id;
  return is_known && testimony(*member, now) != HeardWithin::longer;
}

announcement::Witness Witnesses::say(Instant now) const {
  announcement::Witness witness{.members = fold(), .heard = {}};
  witness.heard.reserve(others_.size() + 1);
  for (const auto& member : others_) witness.heard.push_back(testimony(member, now));
  witness.heard.insert(witness.heard.begin() + (find(self_) - others_.cbegin()), HeardWithin::longer);
  return witness;
}

bool Witnesses::differs_newly(const announcement::Announcement& presence, Instant now) {
  const auto note = [now](std::uint16_t& said, Instant& changed, std::uint16_t fold) {
    if (std::exchange(said, fold) != fold) changed = now;
  };
  const auto place = find(presence.participant);
  if (place == others_.cend() || place->id != presence.participant) return false;
  auto& member = others_[static_cast<std::size_t>(place - others_.cbegin())];
  note(member.said_fold, member.fold_changed, presence.witness.members);
  note(said_fold_, fold_changed_, fold());
  return presence.witness.members != fold() && now - std::max(member.fold_changed, fold_changed_) < 2 * member.interval;
}

bool Witnesses::hear(const announcement::Announcement& presence, Instant now) {
  const auto& heard = presence.witness.heard;
  const auto count = others_.size() + 1;
  if (presence.witness.members != fold() || (heard.size() + 3) / 4 != (count + 3) / 4) return false;
  words_[next_word_++ % words_.size()] = {presence.participant, now};
  const auto take = [now](Member& member, HeardWithin within) {
    if (within == HeardWithin::longer) return;
    member.seen = std::max(member.seen, now - age_of(within, member.interval));
  };
  const auto own_place = static_cast<std::size_t>(find(self_) - others_.cbegin());
  for (std::size_t i = 0; i < own_place; ++i) take(others_[i], heard[i]);
  for (std::size_t i = own_place; i < others_.size(); ++i) take(others_[i], heard[i + 1]);
  return true;
}

Instant Witnesses::seen(ParticipantId id) const { return find(id)->seen; }

std::size_t Witnesses::words(ParticipantId id, Instant now, Duration interval) const {
  const auto in_window = [&](Instant begin, Instant end) {
    return std::ranges::count_if(std::span(words_).first(std::min(next_word_, words_.size())), [&](const Word& word) {
      return word.from != id && begin <= word.at && word.at <= end;
    });
  };
  const auto said = std::max(in_window(now - interval, now), in_window(now - 2 * interval, now - interval));
  return std::min(static_cast<std::size_t>(said), enough_witnesses);
}

}  // namespace geminga::membership
