// ontology/capability.ttl: what a robot can do follows from its parts, and its links make nothing of SOMA and IEEE 1872
// impossible.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::cases {
namespace {

namespace fs = std::filesystem;

const fs::path ontologies = fs::path(GEMINGA_SOURCE_DIR) / "ontology";

/// $GEMINGA_TEST_DATA, or shared/data beside the project; empty where there is neither.
fs::path published() {
  if (const char* named = std::getenv("GEMINGA_TEST_DATA"); named != nullptr) return named;
  const fs::path beside = fs::path(GEMINGA_SOURCE_DIR) / "../shared/data";
  return fs::exists(beside) ? beside : fs::path();
}

owl::Ontology loaded(const std::vector<std::string>& files) {
  auto read = rdf::load(files);
  EXPECT_TRUE(read) << syntax::to_string(read.error());
  return read ? std::move(read->source) : owl::Ontology();
}

/// The IRIs of the classes that can have no instance.
std::vector<std::string> impossible(const owl::Ontology& source) {
  const auto classified = reasoner::classify(source);
  EXPECT_TRUE(classified) << classified.error().text;
  std::vector<std::string> names;
  const auto& representative = classified->representative;
  const auto nothing = static_cast<std::size_t>(classified->nothing);
  for (std::size_t number = 0; number < classified->class_count(); ++number) {
    if (number == nothing || representative[number] != representative[nothing]) continue;
    names.emplace_back(source.name(classified->classes[number]));
  }
  return names;
}

TEST(CapabilityOntology, SaysByTheirPartsWhatRobotsCanDo) {
  owl::Ontology source = loaded({(ontologies / "capability.ttl").string()});
  const auto classified = reasoner::classify(source);
  ASSERT_TRUE(classified);
  EXPECT_THAT(classified->gaps, testing::IsEmpty());
  EXPECT_TRUE(classified->unused.empty());
  const std::string space = "https://geminga.example/capability#";
  const auto some = [&](const char* property, owl::TermId filler) {
    return source.term(owl::TermKind::object_some_values_from, {source.object_property(space + property), filler});
  };
  const auto named = [&](const char* name) { return source.named_class(space + name); };
  const auto all = [&](std::vector<owl::TermId> parts) {
    return source.term(owl::TermKind::object_intersection_of, parts);
  };
  const owl::TermId arm = all({named("Arm"), some("hasPart", named("Gripper"))});
  const owl::TermId robot = all({named("Robot"), some("hasPart", arm), some("hasPart", named("TrackedDrive"))});
  const auto follows = [&](owl::TermId super) {
    return reasoner::entails(source, std::nullopt, robot, super).verdict == reasoner::Verdict::yes;
  };
  EXPECT_TRUE(follows(named("MobileManipulator"))) << "the gripper of an arm is a part of the robot";
  EXPECT_TRUE(follows(some("canPerform", named("ClearingRubble"))));
  EXPECT_FALSE(follows(some("canPerform", named("Fetching")))) << "it does not know where it is";
  EXPECT_FALSE(follows(named("AerialRobot")));
}

TEST(CapabilityOntology, IsConsistentWithIeee1872AndSoma) {
  const fs::path folder = published() / "ontologies";
  if (published().empty()) GTEST_SKIP() << "no published ontologies in $GEMINGA_TEST_DATA or ../shared/data";
  std::vector<std::string> files = {(ontologies / "capability.ttl").string(),
                                    (fs::path(GEMINGA_SOURCE_DIR) / "examples" / "links" / "capability.ttl").string()};
  auto with_soma = files;
  for (const auto& entry : fs::directory_iterator(folder / "ieee1872")) {
    if (entry.path().extension() == ".owl") files.push_back(entry.path().string());
  }
  EXPECT_THAT(impossible(loaded(files)), testing::IsEmpty());
  with_soma.push_back((folder / "soma" / "all-modules-merged.rdf").string());
  const auto names = impossible(loaded(with_soma));
  EXPECT_EQ(names.size(), 8U) << "as in SOMA alone";
  EXPECT_THAT(names, testing::Each(testing::StartsWith("http://www.ease-crc.org/ont/SOMA.owl#")));
}

}  // namespace
}  // namespace geminga::cases
