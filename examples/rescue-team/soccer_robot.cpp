// A robot of the soccer team: its vision tells where the ball is, and its world model asks for everything that moves,
// in the soccer team's words and field coordinates. Of the rescue team it knows only how to read its places
// (places.hpp). Usage: soccer_robot [COUNT]: ends after COUNT messages that had to be converted.
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>
#include <string>

#include "geminga/node.hpp"
#include "places.hpp"

namespace {

constexpr std::string_view field = "soccer:CartesianFieldFrame";
/// The time between two places of the ball. What is received must not set the pace: the own ball comes back, too.
constexpr std::chrono::milliseconds interval(100);

/// The facts about a provider, and whether its first message was printed.
struct Provider {
  std::string concept_name;
  bool is_converted = false;
  bool was_shown = false;
};

class World {
 public:
  World(geminga::Node& node, geminga::Subscriber& objects) : node_(node), objects_(objects) {}

  /// Sends where the ball is, and prints events, until so many converted messages have come.
  void run(geminga::Publisher& ball, std::uint64_t count) {
    auto next = std::chrono::steady_clock::now();
    while (count > 0) {
      if (const auto now = std::chrono::steady_clock::now(); now >= next) {
        (void)ball.send("1.50 -0.20");
        next = now + interval;
      }
      const auto message = objects_.receive(interval);
      while (const auto event = node_.next_event()) take(*event);
      if (!message) continue;
      Provider& provider = providers_[message->life];
      if (!std::exchange(provider.was_shown, true)) {
        std::cout << provider.concept_name << " is at " << text_of(message->payload) << " on the field\n" << std::flush;
      }
      if (provider.is_converted) --count;
    }
  }

 private:
  void take(const geminga::ChannelEvent& event) {
    if (const auto* problem = std::get_if<geminga::Problem>(&event)) std::cout << problem->text << '\n' << std::flush;
    const auto* change = std::get_if<geminga::ProviderChange>(&event);
    if (change == nullptr) return;
    const geminga::ServiceEvent& service = change->service;
    const auto* names = std::get_if<geminga::ConceptNames>(&service.publication.identity);
    Provider& provider = providers_[change->life];
    provider.concept_name = names != nullptr ? names->concept_name : "?";
    provider.is_converted = !service.convert.empty();
    std::cout << to_string(change->what) << ' ' << provider.concept_name << " of " << service.participant_name;
    if (change->what == geminga::ProviderChange::What::removed) {
      std::cout << ": " << change->reason << '\n';
    } else if (provider.is_converted) {
      std::cout << ", converted at cost " << service.cost << ": " << service.convert << '\n';
    } else {
      std::cout << ", as it is\n";
    }
    std::cout << std::flush;
  }

  geminga::Node& node_;
  geminga::Subscriber& objects_;
  std::map<geminga::Life, Provider> providers_;
};

}  // namespace

int main(int argc, char** argv) {
  geminga::ClientOptions options;
  options.name = "WorldModel";
  auto node = geminga::Node::open(options);
  if (!node) {
    std::cerr << "soccer_robot: " << node.error().text << '\n';
    return 3;
  }
  geminga::NamedPublication ball;
  ball.identity = geminga::ConceptNames{"soccer:BallInfo", std::string(field)};
  ball.mode = geminga::ChannelMode::one_to_many_stream;
  ball.attributes = {{"range", "6 m"}};
  auto vision = node->publish(ball);

  geminga::NamedSubscription wish;
  wish.identity = geminga::ConceptNames{"geminga:TrackedObject", std::string(field)};
  wish.mode = geminga::ChannelMode::one_to_many_stream;
  wish.weakest = geminga::Degree::narrower;
  wish.where = "range >= 3 m";
  wish.convert = 10;
  auto objects = node->subscribe(wish, {{"sar:SiteRangeAndBearing>sar:SiteEastAndNorth", map_of_bearing},
                                        {"sar:SiteEastAndNorth>soccer:CartesianFieldFrame", field_of_map}});
  if (!vision || !objects) {
    std::cerr << "soccer_robot: " << (vision ? objects.error() : vision.error()).text << '\n';
    return 2;
  }
  World(*node, *objects)
      .run(*vision, argc > 1 ? std::strtoull(argv[1], nullptr, 10) : std::numeric_limits<std::uint64_t>::max());
  return 0;
}
