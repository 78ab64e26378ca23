// Services that convert between hosts that lose datagrams: whoever asks is told the truth of them, however many ask.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "discovery/matching/matcher.hpp"
#include "sim/client.hpp"
#include "sim/host.hpp"
#include "sim/small_ontology.hpp"
#include "sim/world.hpp"

namespace geminga::participant {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::EndsWith;
using testing::HasSubstr;

constexpr int requests = static_cast<int>(matching::max_rejudged_at_once) + 40;

/// A camera and those who ask for its balls in another frame on one host, a converter on the other.
class ConvertersOnTheAir : public testing::Test {
 protected:
  ConvertersOnTheAir() {
    for (sim::Host* host : {&robot1, &robot2}) {
      host->ontology = sim::small_ontology("frames");
      host->switch_on();
    }
    world.run_for(seconds(3));
    camera.connect(robot1);
    model.connect(robot1);
    frames.connect(robot2);
    model.on_line = [this](std::string_view line, const gcnp::Statement& statement) {
      if (statement.command != "pub") return;
      ++told;
      if (statement.subcommand == "del") {
        EXPECT_EQ(matched.erase(statement.id), 1U) << line;
        EXPECT_THAT(std::string(line), EndsWith("reason=changed"));
      } else {
        EXPECT_EQ(matched.contains(statement.id), statement.subcommand == "modify") << line;
        matched[statement.id] = statement.value("via").value_or("");
      }
    };
    camera.say("1 pub create mode=otm/stream concept=soccer:Ball representation=soccer:CameraPixels port=5000");
    for (int number = 1; number <= requests; ++number) {
      model.say(std::to_string(number) +
                " sub create mode=otm/stream concept=soccer:Ball representation=soccer:FieldPolar convert=yes");
    }
    world.run_for(seconds(1));
    EXPECT_EQ(told, 0);
  }

  /// Whether all requests are met by a chain that is told with these words, and by nothing else.
  void expect_all_by(const std::string& words) {
    EXPECT_EQ(matched.size(), static_cast<std::size_t>(requests));
    for (const auto& [number, via] : matched) EXPECT_THAT(via, HasSubstr(words)) << number;
  }

  static sim::Air lossy() {
    sim::Air air;
    air.loss = 0.3;
    return air;
  }

  sim::World world{sim::World::seed_or(1), lossy()};
  sim::Host& robot1 = world.add_host("robot1");
  sim::Host& robot2 = world.add_host("robot2");
  sim::Client& camera = world.add_client("camera");
  sim::Client& model = world.add_client("model");
  sim::Client& frames = world.add_client("frames");
  std::map<std::uint32_t, std::string> matched;  ///< by number of the request: via
  int told = 0;
};

TEST_F(ConvertersOnTheAir, AreStepsForAllWhoAskForAsLongAsTheyLive) {
  frames.say("1 pub create mode=oto text=pixels port=6000 converts=soccer:CameraPixels>soccer:FieldCartesian cost=2");
  world.run_for(seconds(5));
  expect_all_by(":6000/");
  EXPECT_EQ(told, requests) << "each once";
  frames.say("2 pub create mode=oto text=pixels port=6001 converts=soccer:CameraPixels>soccer:FieldPolar cost=2");
  world.run_for(seconds(5));
  expect_all_by(":6001/");
  EXPECT_EQ(told, 2 * requests);
  robot2.crash();
  world.run_for(seconds(30));
  EXPECT_TRUE(matched.empty());
  EXPECT_EQ(told, 3 * requests) << "nobody is told of the other converter in between: both are gone";
}

TEST_F(ConvertersOnTheAir, ComeBackWithTheirHost) {
  frames.say("1 pub create mode=oto text=pixels port=6000 converts=soccer:CameraPixels>soccer:FieldCartesian cost=2");
  world.run_for(seconds(5));
  world.cut(robot2, robot1);
  world.run_for(seconds(30));
  EXPECT_TRUE(matched.empty());
  world.mend(robot2, robot1);
  world.run_for(seconds(10));
  expect_all_by(":6000/");
  robot1.reload(sim::small_ontology("soccer"));
  world.run_for(seconds(1));
  EXPECT_TRUE(matched.empty()) << "the frames are unknown to the ontology";
  robot1.reload(sim::small_ontology("frames"));
  world.run_for(seconds(1));
  expect_all_by(":6000/");
}

}  // namespace
}  // namespace geminga::participant
