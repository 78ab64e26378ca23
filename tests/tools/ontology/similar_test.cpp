// Misspelled names are answered with similar ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json.hpp>

#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

TEST(Similar, AWrongNameIsAnsweredWithTheNearest) {
  const Program program;
  program.turtle("a.ttl",
                 ":Camera rdfs:subClassOf :Sensor . :Cameras rdfs:subClassOf :Sensor .\n"
                 ":Lidar rdfs:subClassOf :Sensor ; rdfs:label \"laser scanner\" .\n");
  const auto said = [&](const std::string& name) {
    const Outcome outcome = program.run({"subsumes", "a.ttl", "--sub", name, "--super", "e:Sensor"});
    EXPECT_EQ(outcome.status, 2);
    return outcome.err;
  };
  EXPECT_THAT(said("e:Camrea"), EndsWith(": did you mean e:Camera or e:Cameras?\n"));
  EXPECT_THAT(said("<http://e/camera>"), HasSubstr("did you mean e:Camera"));
  EXPECT_THAT(said("laser scaner"), EndsWith(": did you mean e:Lidar?\n"));
  EXPECT_THAT(said("e:Elephant"), Not(HasSubstr("did you mean")));
}

TEST(Similar, SubsumesAnswersInJsonWhateverIsWrong) {
  const Program program;
  program.turtle("a.ttl", ":Camera rdfs:subClassOf :Sensor .\n");
  const auto asked = [&](const std::string& sub) {
    return boost::json::parse(program.run({"subsumes", "--json", "a.ttl", "--sub", sub, "--super", "e:Sensor"}).out);
  };
  EXPECT_EQ(asked("e:Camera").at("subsumed"), true);
  EXPECT_EQ(asked("e:Sensor and e:Camera").at("subsumed"), true);
  EXPECT_THAT(boost::json::value_to<std::string>(asked("e:Camrea").at("error")), HasSubstr("did you mean e:Camera?"));
  EXPECT_THAT(boost::json::value_to<std::string>(asked("e:Camera and and").at("error")), HasSubstr("column "));
}

}  // namespace
}  // namespace geminga::ontology
