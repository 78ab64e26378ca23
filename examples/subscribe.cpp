// Asks for whatever tracked object somebody offers, prints where the first one can be had, and ends.
#include <iostream>

#include "geminga/client.hpp"

int main() {
  geminga::ClientOptions options;
  options.name = "world-model";
  auto client = geminga::Client::connect(options);
  if (!client) {
    std::cerr << "subscribe: " << client.error().text << '\n';
    return 3;
  }

  geminga::NamedSubscription tracked;
  tracked.identity = geminga::ConceptNames{"soccer:TrackedObject", "soccer:CartesianFieldFrame"};
  tracked.mode = geminga::ChannelMode::one_to_many_pubsub;
  tracked.where = "rate >= 10";
  tracked.port = 6000;  // where the provider reaches us
  const auto request = client->subscribe(tracked);
  if (!request) {
    std::cerr << "subscribe: " << request.error().text << '\n';
    return 2;
  }

  const auto event = client->next_event(std::chrono::seconds(30));
  if (!event) {
    std::cerr << "subscribe: " << event.error().text << '\n';
    return 3;
  }
  if (!*event) {
    std::cerr << "subscribe: nobody offers a tracked object\n";
    return 4;
  }
  if (const auto* service = std::get_if<geminga::ServiceEvent>(&(*event)->what)) {
    const auto& names = std::get<geminga::ConceptNames>(service->publication.identity);
    std::cout << names.concept_name << " from " << service->peer_name << " at " << service->publication.address << ':'
              << service->publication.port << ", match " << to_string(service->degree) << '\n';
  }
  return 0;
}
