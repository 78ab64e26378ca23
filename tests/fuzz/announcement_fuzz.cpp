// Any octets as a datagram: decoding, encoding again and taking in must stay within every limit.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "discovery/announcement/codec.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "discovery/membership/schedule/deadline.hpp"

namespace {

using namespace geminga;
using namespace geminga::announcement;
using namespace geminga::membership;

void require(bool condition) {
  if (!condition) std::abort();
}

/// An accepted announcement can be encoded again and is decoded as the same: a presence as a whole, of a state the
/// header.
void check_round_trip(Announcement announcement) {
  announcement.part = 0;
  announcement.part_count = 1;
  // Services that were written tighter than we write them may take a second datagram; each must be readable.
  const auto datagrams = encode(announcement);
  for (const auto& datagram : datagrams) {
    require(datagram.size() <= announcement::max_datagram_bytes);
    const auto again = announcement::decode(datagram);
    require(again.has_value());
    require(again->participant == announcement.participant && again->name == announcement.name);
    require(announcement.kind != Kind::presence || datagrams.size() > 1 || *again == announcement);
    require(announcement.kind != Kind::relayed || again->relayed == announcement.relayed);
  }
}

/// A table that has received it keeps its limits, and forgets it at its deadline.
void check_table(const Announcement& announcement) {
  membership::NeighbourTable table(announcement.group);
  table.set_self(ParticipantId{1}, announcement::BootNonce{1});
  const base::Instant now{std::chrono::hours(1)};
  for (int i = 0; i < 2; ++i) (void)table.hear(announcement, {env::InterfaceIndex{1}, "eth0", "10.0.0.1", now});
  table.neighbours().for_each([&](const Neighbour& neighbour) {
    require(neighbour.publications + neighbour.subscriptions <= max_services_per_participant);
    require(neighbour.paths.size() <= max_paths);
    require(neighbour.deadline > now && neighbour.deadline <= now + membership::patience(max_interval, {.loss = 1}));
  });
  require(table.take_changes().size() <= 2 * announcement::max_services_per_participant);
  table.expire(now + membership::patience(announcement::max_interval, {.loss = 1}));
  require(table.neighbours().size() == 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  const auto announcement = announcement::decode(std::as_bytes(std::span(octets, size)));
  if (!announcement) {
    require(!to_string(announcement.error()).empty());
    return 0;
  }
  check_round_trip(*announcement);
  check_table(*announcement);
  return 0;
}
