// Words for changes, and participants for table tests.
#include "discovery/membership/table_rig.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace geminga::membership {
namespace {

std::string word(Departure departure) {
  switch (departure) {
    case Departure::withdrawn:
      return "withdrawn";
    case Departure::expired:
      return "expired";
    case Departure::left:
      return "left";
  }
  return "?";
}

struct Line {
  std::string operator()(const PutPublication& put) const {
    return "put pub " + to_string(put.key) + " at " + put.publication.address;
  }
  std::string operator()(const PutSubscription& put) const { return "put sub " + to_string(put.key); }
  std::string operator()(const RemovePublication& gone) const {
    return "remove pub " + to_string(gone.key) + " " + word(gone.reason);
  }
  std::string operator()(const RemoveSubscription& gone) const {
    return "remove sub " + to_string(gone.key) + " " + word(gone.reason);
  }
  std::string operator()(const RemoveParticipant& gone) const {
    return "remove " + to_string(gone.participant) + " " + word(gone.reason);
  }
};

}  // namespace

std::string line_of(const Change& change) { return std::visit(Line{}, change); }

void Registry::take(NeighbourTable& table) {
  for (const auto& change : table.take_changes()) {
    if (const auto* publication = std::get_if<PutPublication>(&change)) {
      services[publication->key] = publication->publication.address + ":" +
                                   std::to_string(publication->publication.port) + " of " +
                                   publication->participant_name + "/" + publication->peer_name;
    } else if (const auto* subscription = std::get_if<PutSubscription>(&change)) {
      services[subscription->key] = "sub of " + subscription->participant_name + "/" + subscription->peer_name;
    } else if (const auto* lost = std::get_if<RemovePublication>(&change)) {
      EXPECT_EQ(services.erase(lost->key), 1U) << "removed what was never put: " << line_of(change);
    } else if (const auto* ended = std::get_if<RemoveSubscription>(&change)) {
      EXPECT_EQ(services.erase(ended->key), 1U) << "removed what was never put: " << line_of(change);
    } else {
      const auto gone = std::get<RemoveParticipant>(change).participant;
      std::erase_if(services, [&](const auto& item) { return item.first.participant == gone; });
    }
  }
}

announcement::Announcement speaker(std::uint32_t id, std::uint64_t revision,
                                   const std::vector<std::uint32_t>& numbers) {
  announcement::Announcement announcement;
  announcement.group = "default";
  announcement.participant = ParticipantId{id};
  announcement.boot = announcement::BootNonce{id};
  announcement.name = "robot" + std::to_string(id);
  announcement.revision = revision;
  announcement.addresses = {"10.0.0." + std::to_string(id)};
  announcement.peers.push_back({PeerId{1}, "vision", {}, {}, {}, {}});
  for (const auto number : numbers)
    announcement.peers[0].publications.push_back({number, announcement::simple_publication()});
  return announcement;
}

announcement::Announcement part_of(announcement::Announcement announcement, std::uint32_t part, std::uint32_t count,
                                   const std::vector<std::uint32_t>& numbers) {
  announcement.part = part;
  announcement.part_count = count;
  std::erase_if(announcement.peers[0].publications,
                [&](const auto& entry) { return std::ranges::find(numbers, entry.number) == numbers.end(); });
  return announcement;
}

}  // namespace geminga::membership
