// Writes states as teams announce them into a folder, one a file, for tools/dev/train-dictionary.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "discovery/announcement/codec.hpp"

namespace {

using namespace geminga;

/// One line of examples/robot-soccer/team.tsv.
struct Row {
  std::string module;
  bool is_publication = false;
  std::string term;
};

std::vector<Row> read_team() {
  std::ifstream file(GEMINGA_SOURCE_DIR "/examples/robot-soccer/team.tsv");
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    std::string host;
    std::string direction;
    std::string name;
    Row row;
    words >> host >> row.module >> direction >> name;
    row.is_publication = direction == "pub";
    row.term = name.substr(name.find(':') + 1);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Half of all services are named by concepts, a quarter each by texts and numbers.
Identity identity_of(const Row& row, base::Random& random) {
  switch (random.below(4)) {
    case 0:
      return TextIdentity{row.term};
    case 1:
      return NumericIdentity{static_cast<std::uint32_t>(random.next())};
    default:
      return SemanticIdentity{"https://geminga.example/soccer#" + row.term,
                              random.chance(0.3) ? "https://geminga.example/soccer#CartesianFieldFrame" : ""};
  }
}

announcement::Announcement state_of(const std::vector<Row>& team, base::Random& random) {
  announcement::Announcement state;
  state.group = "default";
  state.participant = ParticipantId(1 + static_cast<std::uint32_t>(random.below(0xffffffff)));
  state.boot = announcement::BootNonce(random.next());
  state.sequence = random.below(10'000);
  state.revision = random.below(100);
  state.ontology_digest = random.next();
  state.name = "robot" + std::to_string(random.below(30));
  state.addresses = {"192.168." + std::to_string(random.below(256)) + '.' + std::to_string(random.below(256))};
  std::uint32_t number = 0;
  for (const Row& row : team) {
    if (random.chance(0.6)) continue;
    const bool is_same = !state.peers.empty() && state.peers.back().name == row.module;
    if (!is_same) {
      announcement::PeerState peer;
      peer.id = PeerId{static_cast<std::uint32_t>(state.peers.size() + 1)};
      peer.name = row.module;
      state.peers.push_back(std::move(peer));
    }
    if (row.is_publication) {
      Publication publication;
      publication.identity = identity_of(row, random);
      publication.mode = random.chance(0.7) ? ChannelMode::one_to_many_stream : ChannelMode::one_to_many_pubsub;
      publication.port = static_cast<std::uint16_t>(1024 + random.below(60'000));
      if (random.chance(0.3)) publication.attributes = {{"rate", std::to_string(random.below(100))}};
      state.peers.back().publications.push_back({++number, std::move(publication)});
    } else {
      Subscription subscription;
      subscription.identity = identity_of(row, random);
      subscription.mode = random.chance(0.7) ? ChannelMode::one_to_many_stream : ChannelMode::one_to_one;
      state.peers.back().subscriptions.push_back({++number, std::move(subscription)});
    }
  }
  return state;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 || !std::filesystem::is_directory(argv[1])) {
    std::cerr << "usage: " << argv[0] << " FOLDER\n";
    return 2;
  }
  const std::vector<Row> team = read_team();
  base::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    int part = 0;
    for (const announcement::Datagram& datagram : announcement::encode(state_of(team, random))) {
      const std::string name = std::to_string(i) + '-' + std::to_string(part++);
      std::ofstream(std::filesystem::path(argv[1]) / name, std::ios::binary)
          .write(reinterpret_cast<const char*>(datagram.data()), static_cast<std::streamsize>(datagram.size()));
    }
  }
}
