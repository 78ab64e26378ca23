// A robot of the rescue team: it offers the findings of its thermal camera and its laser range finder, in the words of
// its own team.
#include <array>
#include <chrono>
#include <iostream>
#include <vector>

#include "geminga/node.hpp"

namespace {

/// A finding of one sensor: range and bearing from the team's pole, in metres and degrees from north.
struct Finding {
  const char* concept_name;
  const char* sensor;
  const char* range;  ///< the reach of the sensor
  const char* line;
};

constexpr std::array findings = {
    Finding{"sar:LimbSighting", "thermal camera", "4000 cm", "5.0 53.13"},
    Finding{"sar:HeatSpot", "thermal camera", "4000 cm", "12.0 10.0"},
    Finding{"sar:LaserContact", "laser range finder", "250 cm", "2.0 90.0"},
};

}  // namespace

int main() {
  geminga::ClientOptions options;
  options.name = "Sensors";
  auto node = geminga::Node::open(options);
  if (!node) {
    std::cerr << "rescue_robot: " << node.error().text << '\n';
    return 3;
  }
  std::vector<geminga::Publisher> publishers;
  for (const Finding& finding : findings) {
    geminga::NamedPublication offer;
    offer.identity = geminga::ConceptNames{finding.concept_name, "sar:SiteRangeAndBearing"};
    offer.mode = geminga::ChannelMode::one_to_many_stream;
    offer.attributes = {{"sensor", finding.sensor}, {"range", finding.range}};
    auto publisher = node->publish(offer);
    if (!publisher) {
      std::cerr << "rescue_robot: " << finding.concept_name << ": " << publisher.error().text << '\n';
      return 2;
    }
    publishers.push_back(std::move(*publisher));
  }
  std::cout << "sensors on\n" << std::flush;
  for (;;) {
    for (std::size_t i = 0; i < findings.size(); ++i) (void)publishers[i].send(findings[i].line);
    node->run_for(std::chrono::milliseconds(100));
  }
}
