#include "discovery/membership/witnesses/witnesses.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "base/hash.hpp"
#include "discovery/membership/schedule/deadline.hpp"

namespace geminga::membership {
namespace {

using announcement::HeardWithin;
using base::Duration;
using base::Instant;

HeardWithin heard_within(Duration age, Duration interval) {
  if (age > interval) return HeardWithin::longer;
  if (age > interval / 2) return HeardWithin::interval;
  return age > interval / 4 ? HeardWithin::half : HeardWithin::quarter;
}

/// The greatest age of a sign of life that was heard within this share of the interval.
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
  settle();
  self_ = {.id = id, .boot = boot, .revision = self_.revision};
  begin_anew();
}

void Witnesses::set_revision(std::uint64_t revision) { self_.revision = revision; }

std::size_t Witnesses::place_of(ParticipantId id) const {
  return static_cast<std::size_t>(std::ranges::lower_bound(ids_, id) - ids_.begin());
}

void Witnesses::begin_anew() {
  own_place_ = place_of(self_.id);
  ++places_;
  pending_.resize(ids_.size() + 1);
}

void Witnesses::add(ParticipantId id, announcement::BootNonce boot) {
  settle();
  const auto place = static_cast<std::ptrdiff_t>(place_of(id));
  ids_.insert(ids_.begin() + place, id);
  Member member;
  member.boot = boot;
  others_.insert(others_.begin() + place, member);
  others_fold_ = static_cast<std::uint16_t>(others_fold_ ^ folded(static_cast<std::size_t>(place)).fold());
  begin_anew();
}

void Witnesses::remove(ParticipantId id) {
  settle();
  const auto place = static_cast<std::ptrdiff_t>(place_of(id));
  others_fold_ = static_cast<std::uint16_t>(others_fold_ ^ folded(static_cast<std::size_t>(place)).fold());
  ids_.erase(ids_.begin() + place);
  others_.erase(others_.begin() + place);
  begin_anew();
}

void Witnesses::update(ParticipantId id, Instant heard, Duration interval, std::uint64_t revision) {
  const auto place = place_of(id);
  if (others_[place].revision != revision) {
    others_fold_ = static_cast<std::uint16_t>(others_fold_ ^ folded(place).fold());
    others_[place].revision = revision;
    others_fold_ = static_cast<std::uint16_t>(others_fold_ ^ folded(place).fold());
  }
  if (others_[place].interval != interval) settle();  // what is pending was said of the interval before
  others_[place].heard = heard;
  others_[place].interval = interval;
}

std::uint16_t Witnesses::fold() const { return static_cast<std::uint16_t>(others_fold_ ^ self_.fold()); }

std::uint16_t Witnesses::difference(const announcement::Announcement& presence) const {
  const auto its_own = folded(place_of(presence.participant));
  return static_cast<std::uint16_t>(presence.witness.members ^ fold() ^ its_own.fold() ^
                                    its_own.fold_of(presence.revision));
}

HeardWithin Witnesses::testimony(const Member& member, Instant now) const {
  if (member.heard <= distrusted_until_) return HeardWithin::longer;
  return heard_within(now - member.heard, member.interval);
}

bool Witnesses::has_heard(ParticipantId id, Instant now) const {
  const auto place = place_of(id);
  return is_at(place, id) && testimony(others_[place], now) != HeardWithin::longer;
}

announcement::Witness Witnesses::say(Instant now) const {
  announcement::Witness witness{.members = fold(), .heard = {}};
  witness.heard.reserve(others_.size() + 1);
  for (std::size_t place = 0; place < others_.size(); ++place) {
    if (place == own_place_) witness.heard.push_back(HeardWithin::longer);
    witness.heard.push_back(testimony(others_[place], now));
  }
  if (own_place_ == others_.size()) witness.heard.push_back(HeardWithin::longer);
  return witness;
}

Difference Witnesses::explain(const announcement::Announcement& presence) const {
  const auto differs = difference(presence);
  if (differs == 0) return {.is_of_revisions = true};
  // Among so many nobody but ourselves is told apart.
  if (others_.size() > max_told_revised) return explain_among_many(differs, self_);
  std::vector<Folded> others;
  others.reserve(others_.size());
  for (std::size_t place = 0; place < others_.size(); ++place) {
    if (ids_[place] != presence.participant) others.push_back(folded(place));
  }
  return membership::explain(differs, self_, others);
}

Difference Witnesses::compare(const announcement::Announcement& presence, Instant now) {
  const auto note = [now](std::uint16_t& said, Instant& changed, std::uint16_t fold) {
    if (std::exchange(said, fold) != fold) changed = now;
  };
  const auto place = place_of(presence.participant);
  if (!is_at(place, presence.participant)) return {};
  auto& member = others_[place];
  note(member.said_fold, member.fold_changed, presence.witness.members);
  note(said_fold_, fold_changed_, fold());
  unlike_until_ = {};
  const auto newly_until = std::max(member.fold_changed, fold_changed_) + 2 * member.interval;
  if (difference(presence) == 0 || now >= newly_until) return {};
  const auto explained = explain(presence);
  if (explained.unknown == Unknown::unclear) {
    unlike_fold_ = presence.witness.members;
    unlike_until_ = newly_until;
  }
  return explained;
}

bool Witnesses::is_of_same(const announcement::Announcement& presence) const {
  constexpr auto per_octet = announcement::HeardList::per_octet;
  const bool has_places = presence.witness.heard.octets().size() == (others_.size() + 1 + per_octet - 1) / per_octet;
  return has_places && (presence.witness.members == fold() || explain(presence).is_of_revisions);
}

bool Witnesses::misses_us(const announcement::Announcement& presence, Instant since, Duration interval, Instant now) {
  const auto place = place_of(presence.participant);
  if (!is_at(place, presence.participant) || !is_of_same(presence)) return false;
  auto& heard_us = others_[place].heard_us;
  const auto within = presence.witness.heard[own_place_];
  if (within != HeardWithin::longer) heard_us = std::max(heard_us, now - age_of(within, interval));
  return within == HeardWithin::longer && heard_us < since;
}

void Witnesses::hear_of_us(const announcement::Announcement& presence, Instant now) {
  const auto place = place_of(presence.participant);
  if (!is_at(place, presence.participant) || presence.witness.heard.octets().empty()) return;
  Member& member = others_[place];
  // It knows all that we know but us, or nobody but itself. Presences do not say of others whether they know us.
  const bool knows_only_itself = presence.witness.members == folded(place).fold_of(presence.revision);
  const bool is_deaf = is_of_same(presence) ? presence.witness.heard[own_place_] == HeardWithin::longer
                                            : knows_only_itself || difference(presence) == self_.fold();
  member.is_deaf.note(is_deaf, now);
  member.knows_others.note(!is_of_same(presence), now);
}

void Witnesses::Saying::note(bool is_said, Instant now) {
  if (!is_said || since == base::never) since = is_said ? now : base::never;
  until = now;
}

bool Witnesses::says_for(ParticipantId id, int intervals) const {
  const auto place = place_of(id);
  return is_at(place, id) && others_[place].is_deaf.lasts(intervals * others_[place].interval);
}

bool Witnesses::knows_others(ParticipantId id) const {
  const auto place = place_of(id);
  if (!is_at(place, id) || others_[place].is_deaf.since != base::never) return false;
  return others_[place].knows_others.lasts(deaf_intervals * others_[place].interval);
}

bool Witnesses::anybody_knows_others() const {
  return std::ranges::any_of(ids_, [this](ParticipantId id) { return knows_others(id); });
}

bool Witnesses::hear(const announcement::Announcement& presence, Instant now) {
  hear_of_us(presence, now);
  if (!is_of_same(presence)) return false;
  words_[next_word_++ % words_.size()] = {presence.participant, now};
  if (pending_.is_full()) settle();
  pending_.add(presence.witness.heard.octets(), now);
  auto& witness = others_[place_of(presence.participant)];
  witness.said = presence.witness.heard;
  witness.said_at = now;
  witness.said_places = places_;
  return true;
}

std::optional<NamedTestimony> Witnesses::last_word(ParticipantId witness) const {
  const auto own = place_of(witness);
  if (!is_at(own, witness) || others_[own].said_places != places_) return std::nullopt;
  const Member& member = others_[own];
  NamedTestimony testimony{.said = member.said_at, .heard = {}};
  testimony.heard.reserve(ids_.size());
  // The places are those of all, ourselves among them; decode() fills the list up to a multiple of four.
  for (std::size_t place = 0; place < std::min(member.said.size(), ids_.size() + 1); ++place) {
    const ParticipantId id = place == own_place_ ? self_.id : ids_[place < own_place_ ? place : place - 1];
    if (id != witness) testimony.heard.emplace_back(id, member.said[place]);
  }
  return testimony;
}

void Witnesses::settle() {
  pending_.read([this](std::size_t place, HeardWithin within, Instant said) {
    if (place == own_place_ || place > others_.size()) return;
    auto& member = others_[place < own_place_ ? place : place - 1];
    member.seen = std::max(member.seen, said - age_of(within, member.interval));
  });
  pending_.clear();
}

Instant Witnesses::seen(ParticipantId id) const {
  const auto place = place_of(id);
  const auto& member = others_[place];
  auto seen = member.seen;
  pending_.read_one(place < own_place_ ? place : place + 1, [&](HeardWithin within, Instant said) {
    seen = std::max(seen, said - age_of(within, member.interval));
  });
  return seen;
}

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
