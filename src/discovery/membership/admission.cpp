// Shares by source, and rank within a share.
#include "discovery/membership/admission.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {
namespace {

using base::Instant;

constexpr std::size_t bucket_size = 4;
/// A stranger that was silent for so long begins anew. A participant that was silent for so long loses its place when
/// all places are wanted.
constexpr base::Duration longest_silence = 5 * announcement::stranger_interval;

/// Who is silent for longer than this has not announced itself in each interval, or a datagram of it was lost.
constexpr base::Duration longest_pause = announcement::stranger_interval + announcement::stranger_interval / 4;

/// The finalizer of splitmix64: every bit of the result depends on every bit of `bits`.
std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
  return bits ^ (bits >> 31);
}

}  // namespace

std::uint64_t WaitingList::key_of(ParticipantId id, announcement::BootNonce boot) const {
  return mixed(mixed(secret_ ^ std::to_underlying(id)) ^ std::to_underlying(boot));
}

WaitingList::Stranger& WaitingList::place_of(std::uint64_t key) {
  if (strangers_.empty()) strangers_.resize(announcement::max_waiting);
  const auto bucket =
      std::span(strangers_).subspan(key % (announcement::max_waiting / bucket_size) * bucket_size, bucket_size);
  const auto same = std::ranges::find(bucket, key, &Stranger::key);
  if (same != bucket.end()) return *same;
  return *std::ranges::min_element(bucket, {}, [](const Stranger& each) { return each.standing.rank(); });
}

std::optional<Standing> WaitingList::hear(const announcement::Announcement& announcement, Instant now) {
  const auto key = key_of(announcement.participant, announcement.boot);
  auto& stranger = place_of(key);
  if (stranger.key != key || now - stranger.standing.last >= longest_silence) {
    stranger = {key, announcement.sequence, {now, now}};
    return std::nullopt;
  }
  if (announcement.sequence == stranger.sequence) return std::nullopt;
  stranger.sequence = announcement.sequence;
  stranger.standing.hear(now);
  return stranger.standing;
}

void WaitingList::put(ParticipantId id, announcement::BootNonce boot, std::uint64_t sequence,
                      const Standing& standing) {
  if (!standing.is_confirmed) return;
  const auto key = key_of(id, boot);
  place_of(key) = {key, sequence, standing};
}

void Admission::insert(Place& place) {
  auto& share = shares_[place.source];
  const auto before = share.count++;
  if (!share.unseasoned.empty()) by_count_.erase({before, place.source});
  place.filed = place.standing;
  if (place.is_seasoned) {
    ++share.seasoned;
  } else {
    share.unseasoned.emplace(place.filed.rank(), place.id);
    unseasoned_.emplace(place.filed.rank(), place.id);
  }
  if (!share.unseasoned.empty()) by_count_.emplace(share.count, place.source);
  by_silence_.emplace(place.filed.last, place.id);
}

void Admission::erase(const Place& place) {
  const auto found = shares_.find(place.source);
  auto& share = found->second;
  if (!share.unseasoned.empty()) by_count_.erase({share.count, place.source});
  --share.count;
  if (place.is_seasoned) {
    --share.seasoned;
  } else {
    share.unseasoned.erase({place.filed.rank(), place.id});
    unseasoned_.erase({place.filed.rank(), place.id});
  }
  if (!share.unseasoned.empty()) by_count_.emplace(share.count, place.source);
  by_silence_.erase({place.filed.last, place.id});
  if (share.count == 0) shares_.erase(found);
}

Admission::Place& Admission::add(ParticipantId id, const std::string& source, const Standing& standing) {
  auto& place = places_[id];
  place = {.id = id, .source = source, .standing = standing, .filed = standing, .added = ++added_};
  insert(place);
  return place;
}

void Admission::update(Place& place, const Standing& standing) {
  if (place.standing.last == standing.last) return;
  place.standing = standing;
  if (!std::exchange(place.is_moved, true)) moved_.push_back(&place);
  if (place.is_seasoned || standing.last - standing.first < announcement::seasoned_after) return;
  if (shares_.find(place.source)->second.seasoned >= announcement::max_seasoned_per_source) return;
  erase(place);
  place.is_seasoned = true;
  insert(place);
}

void Admission::refile() {
  for (auto* place : moved_) {
    erase(*place);
    place->is_moved = false;
    insert(*place);
  }
  moved_.clear();
}

void Admission::remove(ParticipantId id) {
  refile();
  const auto place = places_.find(id);
  erase(place->second);
  places_.erase(place);
}

bool Admission::is_seasoned(ParticipantId id) const {
  const auto place = places_.find(id);
  return place != places_.end() && place->second.is_seasoned;
}

const Admission::Share* Admission::greediest() const {
  return by_count_.empty() ? nullptr : &shares_.find(by_count_.rbegin()->second)->second;
}

std::optional<ParticipantId> Admission::from_greedier(std::string_view source) const {
  const auto own = shares_.find(source);
  const auto count = own == shares_.end() ? 0 : own->second.count;
  const auto* most = greediest();
  // The source that gives one place away keeps at least as many as the newcomer's source then has.
  if (most == nullptr || most->count < count + 2) return std::nullopt;
  return most->unseasoned.begin()->second;
}

Admission::Decision Admission::decide(const announcement::Announcement& newcomer, const Arrival& arrival) {
  refile();
  if (const auto gives_way = from_greedier(arrival.source)) return {gives_way, std::nullopt};
  const auto standing = waiting_.hear(newcomer, arrival.now);
  if (!standing) return {};
  return {decide(arrival.source, *standing, arrival.now), standing};
}

std::optional<ParticipantId> Admission::decide(std::string_view source, const Standing& standing, Instant now) {
  refile();
  if (const auto gives_way = from_greedier(source)) return gives_way;
  const auto own = shares_.find(source);
  // If the newcomer's address has no place, every other address has exactly one.
  const auto& others = own != shares_.end() ? own->second.unseasoned : unseasoned_;
  if (!others.empty()) {
    const auto& [rank, id] = *others.begin();
    // Of two that have proved themselves the known one stays, as long as it keeps announcing itself.
    const auto ahead = places_.at(id).standing.is_proved() ? longest_pause : base::Duration::zero();
    if (rank + ahead < standing.rank()) return id;
  }
  const auto& [last, id] = *by_silence_.begin();
  if (now - last >= longest_silence) return id;
  return std::nullopt;
}

std::optional<ParticipantId> Admission::decide_return(std::string_view source, Standing standing, Instant now) {
  standing.hear(now);
  if (const auto gives_way = decide(source, standing, now)) return gives_way;
  if (!standing.is_proved()) return std::nullopt;
  const auto last = std::ranges::max_element(places_, {}, [](const auto& each) { return each.second.added; });
  const auto own = shares_.find(source);
  const bool is_greedier =
      shares_.find(last->second.source)->second.count > (own == shares_.end() ? 0 : own->second.count);
  return is_greedier && !last->second.is_seasoned ? std::optional(last->first) : std::nullopt;
}

}  // namespace geminga::membership
