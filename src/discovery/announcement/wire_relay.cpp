#include "discovery/announcement/wire_relay.hpp"

#include <algorithm>
#include <ranges>
#include <utility>

#include "base/address.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/announcement/varint.hpp"
#include "discovery/announcement/wire_entry.hpp"

namespace geminga::announcement {
namespace {

using std::chrono::milliseconds;

constexpr unsigned hops_bits = 3;
constexpr unsigned hops_mask = (1U << hops_bits) - 1;
constexpr unsigned most_lost = 15;
static_assert(max_hops <= hops_mask);

/// Whole milliseconds, rounded up: an age may be said too old, and never too young.
std::uint32_t age_ms(base::Duration age) {
  const auto bound = std::clamp<base::Duration>(age, base::Duration(0), max_relayed_age);
  return static_cast<std::uint32_t>(std::chrono::ceil<milliseconds>(bound).count());
}

bool is_age(std::uint32_t ms) { return milliseconds(ms) <= max_relayed_age; }

/// The octets of the four lists beside their entries: a tag of two octets and a length of up to two each.
constexpr std::size_t lists_bytes = 16;

}  // namespace

void write_relayed(const Relayed& relayed, wire::Announcement& message) {
  message.set_word(relayed.word.data(), relayed.word.size());
  message.set_age_ms(age_ms(relayed.age));
  for (const auto id : relayed.through) message.add_through(std::to_underlying(id));
  if (!relayed.source.empty()) message.set_source(address_octets(relayed.source));
}

std::optional<Relayed> read_relayed(const wire::Announcement& message) {
  Relayed relayed;
  const auto& word = message.word();
  if (word.empty() || word.size() > max_word_bytes || !is_age(message.age_ms())) return std::nullopt;
  const auto octets = std::as_bytes(std::span(word));
  relayed.word.assign(octets.begin(), octets.end());
  relayed.age = milliseconds(message.age_ms());
  const auto& through = message.through();
  if (through.empty() || through.size() > static_cast<int>(max_hops)) return std::nullopt;
  for (const auto number : through) {
    const ParticipantId id{number};
    if (number == 0 || std::ranges::find(relayed.through, id) != relayed.through.end()) return std::nullopt;
    relayed.through.push_back(id);
  }
  if (relayed.through.back() != ParticipantId{message.participant()}) return std::nullopt;
  if (message.source().empty()) return relayed;
  auto source = address_of(message.source());
  if (!source || base::address_scope(*source) == base::AddressScope::multicast) return std::nullopt;
  relayed.source = std::move(*source);
  return relayed;
}

std::size_t write_behind(std::span<const Behind> behind, std::size_t room, wire::Announcement& message) {
  std::size_t octets = message.ByteSizeLong() + lists_bytes;
  std::size_t count = 0;
  for (const Behind& one : behind | std::views::take(max_behind)) {
    const auto age = age_ms(one.age);
    octets += sizeof(std::uint32_t) + varint_bytes(one.revision) + varint_bytes(age) + 1;
    if (octets > room) break;
    message.add_behind(std::to_underlying(one.participant));
    message.add_behind_revisions(one.revision);
    message.add_behind_ages_ms(age);
    message.add_behind_ways(one.hops | std::min<unsigned>(one.lost, most_lost) << hops_bits);
    ++count;
  }
  return count;
}

bool read_behind(const wire::Announcement& message, std::vector<Behind>& behind) {
  const int count = message.behind_size();
  if (count > static_cast<int>(max_behind) || message.behind_revisions_size() != count ||
      message.behind_ages_ms_size() != count || message.behind_ways_size() != count)
    return false;
  for (int i = 0; i < count; ++i) {
    const std::uint32_t ways = message.behind_ways(i);
    const std::uint32_t hops = ways & hops_mask;
    const std::uint32_t lost = ways >> hops_bits;
    if (message.behind(i) == 0 || hops == 0 || hops > max_hops || lost > most_lost) return false;
    if (!is_age(message.behind_ages_ms(i))) return false;
    behind.push_back({.participant = ParticipantId{message.behind(i)},
                      .revision = message.behind_revisions(i),
                      .age = milliseconds(message.behind_ages_ms(i)),
                      .hops = static_cast<std::uint8_t>(hops),
                      .lost = static_cast<std::uint8_t>(lost)});
  }
  return true;
}

}  // namespace geminga::announcement
