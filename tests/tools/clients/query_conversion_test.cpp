// What geminga-query shows of services whose representation has to be converted.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <string>
#include <vector>

#include "tools/clients/bench.hpp"

namespace geminga::tools {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

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
  const auto why = bench.json({"why", "--concept", "soccer:GoalInfo", "--representation", "soccer:CartesianRobotFrame",
                               "--convert", "1", "--service", found.at("service").as_string().c_str()});
  EXPECT_EQ(why.at("degree"), "converted");
  EXPECT_EQ(why.at("convert"), "soccer:PolarRobotFrame>soccer:CartesianRobotFrame");
  EXPECT_EQ(why.at("cost").as_int64(), 1);
}

}  // namespace
}  // namespace geminga::tools
