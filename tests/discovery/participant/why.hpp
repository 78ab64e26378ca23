// One host with somebody who offers and somebody who asks why, for tests of `query why`.
#ifndef GEMINGA_TESTS_DISCOVERY_PARTICIPANT_WHY_HPP
#define GEMINGA_TESTS_DISCOVERY_PARTICIPANT_WHY_HPP

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/client.hpp"
#include "sim/host.hpp"
#include "sim/small_ontology.hpp"
#include "sim/world.hpp"

namespace geminga::participant {

class WhyTest : public testing::Test {
 protected:
  WhyTest() {
    host.settings.limits.services_per_peer = 1024;
    host.settings.limits.statements_per_second = 1'000'000;
    host.ontology = sim::small_ontology("soccer");
    host.switch_on();
    world.run_for(std::chrono::milliseconds(200));
    provider.connect(host);
    asking.connect(host);
    provider.say("0 sys hello");
    world.run_for(std::chrono::milliseconds(1));
    provider.lines.clear();
  }

  void offer(int number, const std::string& what) { provider.say(std::to_string(number) + " pub create " + what); }

  /// The lines of an answer, its end the last.
  std::vector<std::string> ask(const std::string& query) {
    world.run_for(std::chrono::milliseconds(20));
    asking.lines.clear();
    asking.say("900 query " + query);
    world.run_for(std::chrono::milliseconds(50));
    std::vector<std::string> answer;
    for (const std::string& line : asking.lines) {
      if (line.starts_with("900 ")) answer.push_back(line);
    }
    return answer;
  }

  sim::World world{sim::World::seed_or(1)};
  sim::Host& host = world.add_host("robot1");
  sim::Client& provider = world.add_client("provider");
  sim::Client& asking = world.add_client("asking");
};

}  // namespace geminga::participant

#endif
