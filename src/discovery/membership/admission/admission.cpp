// Shares by source, and rank within a share.
#include "discovery/membership/admission/admission.hpp"

#include <algorithm>
#include <utility>

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {
namespace {

using base::Instant;

/// A longer silence means that a participant did not announce itself in each interval, or that a datagram was lost.
constexpr base::Duration longest_pause = announcement::stranger_interval + announcement::stranger_interval / 4;

}  // namespace

void Admission::order() {
  if (std::exchange(is_ordered_, true)) return;
  for (auto& [id, member] : members_) insert(member);
}

void Admission::insert(Member& member) {
  auto& share = shares_[member.source];
  const auto before = share.count++;
  if (!share.unseasoned.empty()) by_count_.erase({before, member.source});
  member.filed = member.standing;
  if (!member.is_seasoned) {
    share.unseasoned.emplace(member.filed.rank(), member.id);
    unseasoned_.emplace(member.filed.rank(), member.id);
  }
  if (!share.unseasoned.empty()) by_count_.emplace(share.count, member.source);
  by_silence_.emplace(member.filed.last, member.id);
}

void Admission::erase(const Member& member) {
  const auto found = shares_.find(member.source);
  auto& share = found->second;
  if (!share.unseasoned.empty()) by_count_.erase({share.count, member.source});
  --share.count;
  if (!member.is_seasoned) {
    share.unseasoned.erase({member.filed.rank(), member.id});
    unseasoned_.erase({member.filed.rank(), member.id});
  }
  if (!share.unseasoned.empty()) by_count_.emplace(share.count, member.source);
  by_silence_.erase({member.filed.last, member.id});
  if (share.count == 0) shares_.erase(found);
}

Admission::Member& Admission::add(ParticipantId id, const std::string& source, const Standing& standing) {
  auto& member = members_[id];
  member = {.id = id, .source = source, .standing = standing, .filed = standing, .added = ++added_};
  if (is_ordered_) insert(member);
  return member;
}

void Admission::update(Member& member, const Standing& standing) {
  if (member.standing.last == standing.last) return;
  member.standing = standing;
  if (is_ordered_ && !std::exchange(member.is_moved, true)) moved_.push_back(&member);
  if (member.is_seasoned || standing.last - standing.first < announcement::seasoned_after) return;
  auto& seasoned_of_source = seasoned_of_[member.source];
  if (seasoned_of_source >= announcement::max_seasoned_per_source) return;
  ++seasoned_of_source;
  ++seasoned_;
  if (is_ordered_) erase(member);
  member.is_seasoned = true;
  if (is_ordered_) insert(member);
}

void Admission::refile() {
  for (auto* member : moved_) {
    erase(*member);
    member->is_moved = false;
    insert(*member);
  }
  moved_.clear();
}

void Admission::remove(ParticipantId id) {
  refile();
  const auto member = members_.find(id);
  if (is_ordered_) erase(member->second);
  if (member->second.is_seasoned) {
    const auto of_source = seasoned_of_.find(member->second.source);
    if (--of_source->second == 0) seasoned_of_.erase(of_source);
    --seasoned_;
  }
  members_.erase(member);
}

bool Admission::is_seasoned(ParticipantId id) const {
  const auto member = members_.find(id);
  return member != members_.end() && member->second.is_seasoned;
}

std::vector<ParticipantId> Admission::newest_unseasoned(std::size_t most) const {
  std::vector<const Member*> strangers;
  for (const auto& [id, member] : members_) {
    if (!member.is_seasoned) strangers.push_back(&member);
  }
  std::ranges::sort(strangers, std::ranges::greater{}, &Member::added);
  std::vector<ParticipantId> ids;
  for (const Member* one : strangers) {
    if (ids.size() < most) ids.push_back(one->id);
  }
  return ids;
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

Admission::Decision Admission::decide(const announcement::Announcement& newcomer, std::string_view source,
                                      Instant now) {
  order();
  refile();
  if (const auto gives_way = from_greedier(source)) return {gives_way, std::nullopt};
  const auto standing = waiting_.hear(newcomer, now);
  if (!standing) return {};
  return {decide(source, *standing, now), standing};
}

std::optional<ParticipantId> Admission::decide(std::string_view source, const Standing& standing, Instant now) {
  order();
  refile();
  if (const auto gives_way = from_greedier(source)) return gives_way;
  const auto own = shares_.find(source);
  // If the newcomer's address has no place, every other address has exactly one.
  const auto& others = own != shares_.end() ? own->second.unseasoned : unseasoned_;
  if (!others.empty()) {
    const auto& [rank, id] = *others.begin();
    // Of two that have proved themselves the member stays, as long as it keeps announcing itself.
    const auto ahead = members_.at(id).standing.is_proved() ? longest_pause : base::Duration::zero();
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
  const auto last = std::ranges::max_element(members_, {}, [](const auto& each) { return each.second.added; });
  const auto own = shares_.find(source);
  const bool is_greedier =
      shares_.find(last->second.source)->second.count > (own == shares_.end() ? 0 : own->second.count);
  return is_greedier && !last->second.is_seasoned ? std::optional(last->first) : std::nullopt;
}

}  // namespace geminga::membership
