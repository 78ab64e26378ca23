// Says where the ball is, ten times a second, to whoever asks for it: needs a gemingad with the soccer ontology.
#include <cstdlib>
#include <iostream>
#include <limits>

#include "geminga/node.hpp"

int main(int argc, char** argv) {
  const std::uint64_t count =
      argc > 1 ? std::strtoull(argv[1], nullptr, 10) : std::numeric_limits<std::uint64_t>::max();
  geminga::ClientOptions options;
  options.name = "hello-publisher";
  auto node = geminga::Node::open(options);
  if (!node) {
    std::cerr << "hello_publisher: " << node.error().text << '\n';
    return 2;
  }
  geminga::NamedPublication offer;
  offer.identity = geminga::ConceptNames{"soccer:BallInfo", ""};
  offer.mode = geminga::ChannelMode::one_to_many_pubsub;
  offer.attributes["camera"] = "front";
  auto ball = node->publish(offer);
  if (!ball) {
    std::cerr << "hello_publisher: " << ball.error().text << '\n';
    return 2;
  }
  while (ball->count().sent < count) {  // only what reaches somebody is counted
    const auto number = std::to_string(ball->count().sent + 1);
    if (const auto sent = ball->send(R"({"x": 1.5, "y": -0.2, "number": )" + number + "}"); !sent) {
      std::cerr << "hello_publisher: " << sent.error().text << '\n';
      return 3;
    }
    node->run_for(std::chrono::milliseconds(100));
  }
  return 0;
}
