// One module of the robot soccer team as a process of its own: offers and asks for what team.tsv says, prints what it
// is told. Usage: robot_module TEAM.tsv HOST-KIND MODULE HOST-NAME
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include "geminga/client.hpp"

namespace {

/// One row of team.tsv.
struct Row {
  std::string kind, module, direction, concept_name, mode, scope, period;
  std::uint16_t port = 0;
  std::int32_t priority = 0;
};

bool read_row(const std::string& line, Row& row) {
  std::istringstream fields(line);
  return static_cast<bool>(fields >> row.kind >> row.module >> row.direction >> row.concept_name >> row.mode >>
                           row.scope >> row.port >> row.priority >> row.period);
}

std::expected<std::uint32_t, geminga::ClientError> request(geminga::Client& client, const Row& row,
                                                           const std::string& host) {
  const auto mode = geminga::channel_mode(row.mode).value_or(geminga::ChannelMode::one_to_many_stream);
  const geminga::NamedIdentity identity = geminga::ConceptNames{row.concept_name, ""};
  if (row.direction == "pub") {
    geminga::NamedPublication publication;
    publication.identity = identity;
    publication.mode = mode;
    publication.port = row.port;
    publication.priority = row.priority;
    publication.attributes["period"] = row.period;
    return client.publish(publication);
  }
  geminga::NamedSubscription subscription;
  subscription.identity = identity;
  subscription.mode = mode;
  subscription.port = row.port;
  if (row.scope == "self") subscription.providers.push_back({.participant = host, .peer = ""});
  return client.subscribe(subscription);
}

void print(const geminga::Event& event) {
  if (const auto* service = std::get_if<geminga::ServiceEvent>(&event.what)) {
    std::cout << "service " << to_string(service->change) << ' ' << to_string(service->service) << ' '
              << service->reason << '\n'
              << std::flush;
  } else if (const auto* consumer = std::get_if<geminga::ConsumerEvent>(&event.what)) {
    std::cout << "consumer " << to_string(consumer->change) << ' ' << to_string(consumer->subscription) << ' '
              << consumer->reason << '\n'
              << std::flush;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::cerr << "robot_module: four arguments are needed: TEAM.tsv HOST-KIND MODULE HOST-NAME\n";
    return 2;
  }
  const std::string kind = argv[2];
  const std::string module = argv[3];
  geminga::ClientOptions options;
  options.name = module;
  auto client = geminga::Client::connect(options);
  if (!client) {
    std::cerr << "robot_module: " << client.error().text << '\n';
    return 3;
  }
  std::ifstream team(argv[1]);
  for (std::string line; std::getline(team, line);) {
    Row row;
    if (line.starts_with('#') || !read_row(line, row) || row.kind != kind || row.module != module) continue;
    if (const auto number = request(*client, row, argv[4]); !number) {
      std::cerr << "robot_module: " << row.concept_name << ": " << number.error().text << '\n';
      return 2;
    }
  }
  for (;;) {  // until the daemon goes or somebody ends us
    const auto event = client->next_event(std::chrono::hours(1));
    if (!event) return 3;
    if (event->has_value()) print(**event);
  }
}
