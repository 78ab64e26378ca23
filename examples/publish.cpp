// Offers the ball as robot 2 sees it, and says who listens, until Ctrl-C or the daemon's end.
#include <iostream>

#include "geminga/client.hpp"

int main() {
  geminga::ClientOptions options;
  options.name = "vision";
  auto client = geminga::Client::connect(options);
  if (!client) {
    std::cerr << "publish: " << client.error().text << '\n';
    return 3;
  }

  geminga::NamedPublication ball;
  ball.identity = geminga::ConceptNames{"soccer:BallInfo", "soccer:CartesianFieldFrame"};
  ball.mode = geminga::ChannelMode::one_to_many_pubsub;
  ball.port = 5000;
  ball.attributes["rate"] = "30";
  const auto request = client->publish(ball);
  if (!request) {
    std::cerr << "publish: " << request.error().text << '\n';
    return 2;
  }
  std::cout << "offering the ball" << '\n' << std::flush;

  while (true) {
    const auto event = client->next_event(std::chrono::hours(1));
    if (!event) {
      std::cerr << "publish: " << event.error().text << '\n';
      return 3;
    }
    if (!*event) continue;  // an hour of silence
    if (const auto* consumer = std::get_if<geminga::ConsumerEvent>(&(*event)->what)) {
      std::cout << to_string(consumer->change) << " consumer " << to_string(consumer->subscription) << ' '
                << consumer->peer_name << '\n'
                << std::flush;
    }
  }
}
