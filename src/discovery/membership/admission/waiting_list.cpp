#include "discovery/membership/admission/waiting_list.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "discovery/announcement/limits.hpp"

namespace geminga::membership {
namespace {

constexpr std::size_t bucket_size = 4;

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

WaitingList::Stranger& WaitingList::entry_of(std::uint64_t key) {
  if (strangers_.empty()) strangers_.resize(announcement::max_waiting);
  const auto bucket =
      std::span(strangers_).subspan(key % (announcement::max_waiting / bucket_size) * bucket_size, bucket_size);
  const auto same = std::ranges::find(bucket, key, &Stranger::key);
  if (same != bucket.end()) return *same;
  return *std::ranges::min_element(bucket, {}, [](const Stranger& each) { return each.standing.rank(); });
}

std::optional<Standing> WaitingList::hear(const announcement::Announcement& announcement, base::Instant now) {
  const auto key = key_of(announcement.participant, announcement.boot);
  auto& stranger = entry_of(key);
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
  entry_of(key) = {key, sequence, standing};
}

}  // namespace geminga::membership
