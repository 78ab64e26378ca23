// Prints where the ball is, whoever in the team knows it: needs a gemingad with the soccer ontology.
#include <cstdlib>
#include <iostream>
#include <limits>

#include "geminga/node.hpp"

int main(int argc, char** argv) {
  const std::uint64_t count =
      argc > 1 ? std::strtoull(argv[1], nullptr, 10) : std::numeric_limits<std::uint64_t>::max();
  geminga::ClientOptions options;
  options.name = "hello-subscriber";
  auto node = geminga::Node::open(options);
  if (!node) {
    std::cerr << "hello_subscriber: " << node.error().text << '\n';
    return 2;
  }
  geminga::NamedSubscription wish;
  wish.identity = geminga::ConceptNames{"soccer:TrackedObject", ""};
  wish.mode = geminga::ChannelMode::one_to_many_pubsub;
  auto balls = node->subscribe(wish);
  if (!balls) {
    std::cerr << "hello_subscriber: " << balls.error().text << '\n';
    return 2;
  }
  node->on_event([](const geminga::ChannelEvent& event) {
    if (const auto* change = std::get_if<geminga::ProviderChange>(&event)) {
      std::cerr << change->service.peer_name << " on " << change->service.participant_name << ' '
                << to_string(change->what) << ' ' << change->reason << '\n';
    }
  });
  for (std::uint64_t number = 0; number < count;) {
    const auto ball = balls->receive(std::chrono::hours(1));
    if (balls->has_ended()) {
      std::cerr << "hello_subscriber: the daemon took the request back\n";
      return 3;
    }
    if (!ball) continue;  // an hour of silence
    std::cout.write(reinterpret_cast<const char*>(ball->payload.data()),
                    static_cast<std::streamsize>(ball->payload.size()))
        << '\n'
        << std::flush;
    ++number;
  }
  return 0;
}
