// geminga-query and services whose representation has to be converted.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <string>
#include <vector>

#include "tools/clients/bench.hpp"

namespace geminga::tools {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;
using testing::UnorderedElementsAre;

TEST(QueryConversion, IsShownInWordsAndAsJson) {
  Bench bench;
  Talk peer = bench.talk();
  peer.say("5 pub create mode=oto concept=soccer:GoalInfo representation=soccer:PolarRobotFrame port=5002 cost=7");
  EXPECT_THAT(peer.lines_until_pong(), IsEmpty());
  const std::vector<std::string> query{"match", "soccer:GoalInfo", "--representation", "soccer:CartesianRobotFrame"};
  EXPECT_EQ(bench.query(query).status, 1);
  auto converting = query;
  converting.insert(converting.end(), {"--convert", "yes"});
  const auto found = bench.json(converting).at(0);
  EXPECT_EQ(found.at("degree"), "converted");
  EXPECT_EQ(found.at("convert"), "soccer:PolarRobotFrame>soccer:CartesianRobotFrame");
  EXPECT_EQ(found.at("cost").as_int64(), 1);
  EXPECT_EQ(found.at("attributes").at("cost"), "7") << "its own attribute of that name";
  EXPECT_THAT(bench.query(converting).out, HasSubstr("CONVERT"));
  const auto nothing = bench.query(
      {"match", "soccer:GoalInfo", "--representation", "soccer:CartesianRobotFrame", "--degree", "narrower"});
  EXPECT_EQ(nothing.status, 1);
  EXPECT_THAT(nothing.errors, testing::HasSubstr("geminga-query: nothing matches: "));
  EXPECT_THAT(nothing.errors, testing::HasSubstr("ask with convert=1, the cost of turning it into what is asked for"));
  const auto why = bench.json({"why", "--concept", "soccer:GoalInfo", "--representation", "soccer:CartesianRobotFrame",
                               "--convert", "1", "--service", found.at("service").as_string().c_str()});
  EXPECT_EQ(why.at("degree"), "converted");
  EXPECT_EQ(why.at("convert"), "soccer:PolarRobotFrame>soccer:CartesianRobotFrame");
  EXPECT_EQ(why.at("cost").as_int64(), 1);
}

TEST(QueryConversion, FindsAConverterThatIsOfferedFromAShell) {
  Bench bench;
  Talk peer = bench.talk();
  peer.say("5 pub create mode=oto concept=soccer:GoalInfo representation=soccer:PixelCameraFrame port=5002");
  peer.say("6 sub create mode=oto concept=soccer:GoalInfo representation=soccer:CartesianFieldFrame convert=3");
  EXPECT_THAT(peer.lines_until_pong(), IsEmpty());
  const auto publisher =
      bench.start("geminga-publish", {"--text", "frames", "--mode", "oto", "--port", "6000", "cost=3",
                                      "converts=soccer:PixelCameraFrame>soccer:CartesianFieldFrame"});
  const auto told = peer.line_with({"6 pub add "});
  ASSERT_TRUE(told);
  EXPECT_THAT(*told, HasSubstr(" convert=soccer:PixelCameraFrame>soccer:CartesianFieldFrame cost=3 via=udp://"));
  EXPECT_THAT(bench.query({"requests"}).out, AllOf(HasSubstr("ALSO"), HasSubstr("convert=3")));
  EXPECT_THAT(bench.query({"services", "--unused"}).out, Not(HasSubstr("frames"))) << "a chain goes through it";
}

TEST(QueryConversion, SaysWhichServiceConverts) {
  Bench bench;
  Talk peer = bench.talk();
  peer.say("5 pub create mode=oto concept=soccer:GoalInfo representation=soccer:PolarRobotFrame port=5002 via=tunnel");
  peer.say("6 sub create mode=oto concept=soccer:GoalInfo representation=soccer:CartesianFieldFrame convert=yes");
  EXPECT_THAT(peer.lines_until_pong(), UnorderedElementsAre(HasSubstr("6 pub add "), HasSubstr("5 sub add ")));
  peer.say(
      "7 pub create mode=oto text=frames port=6000 address=10.0.0.7 "
      "converts=soccer:PolarRobotFrame>soccer:CartesianFieldFrame cost=2");
  const auto told = peer.lines_until_pong();
  ASSERT_EQ(told.size(), 1U);
  EXPECT_THAT(told.front(), HasSubstr(" convert=soccer:PolarRobotFrame>soccer:CartesianFieldFrame cost=2 "
                                      "via=udp://10.0.0.7:6000/"));
  EXPECT_THAT(told.front(), HasSubstr(" attr.via=tunnel"));
  const std::vector<std::string> query{
      "match", "soccer:GoalInfo", "--representation", "soccer:CartesianFieldFrame", "--convert", "yes"};
  const auto found = bench.json(query).at(0);
  EXPECT_EQ(found.at("cost").as_int64(), 2);
  EXPECT_THAT(std::string(found.at("via").as_string()), StartsWith("udp://10.0.0.7:6000/"));
  EXPECT_EQ(found.at("attributes").at("via"), "tunnel");
  EXPECT_THAT(bench.query(query).out, HasSubstr("udp://10.0.0.7:6000/"));
  const auto why = bench.json({"why", "--concept", "soccer:GoalInfo", "--representation", "soccer:CartesianFieldFrame",
                               "--convert", "2", "--service", found.at("service").as_string().c_str()});
  EXPECT_EQ(why.at("via"), found.at("via"));
  peer.say("7 pub remove");
  EXPECT_THAT(peer.lines_until_pong(), ElementsAre(HasSubstr("soccer:CartesianFieldFrame cost=11 attr.via=tunnel")));
}

}  // namespace
}  // namespace geminga::tools
