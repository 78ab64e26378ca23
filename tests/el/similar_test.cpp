// Names that are nearly right, in small ontologies and in ones that are too large to be compared as a whole.
#include "el/similar.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "written.hpp"

namespace geminga::el {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;

TEST(Similar, GivesTheNearestNamesFirst) {
  OntologySource source = written("SubClassOf(Camera Sensor)\nSubClassOf(Cameras Sensor)\nSubClassOf(Lidar Sensor)\n");
  source.add_label("https://t.example/#Lidar", "laser scanner", "en");
  const Ontology ontology = loaded(source);
  EXPECT_THAT(find_similar(ontology, "t:Camrea"), ElementsAre("t:Camera", "t:Cameras"));
  EXPECT_THAT(find_similar(ontology, "t:Camrea", {.names = 1}), ElementsAre("t:Camera"));
  EXPECT_THAT(find_similar(ontology, "laser scaner"), ElementsAre("t:Lidar"));
  EXPECT_THAT(find_similar(ontology, "t:Elephant"), IsEmpty());
  EXPECT_EQ(did_you_mean({}), "");
  EXPECT_EQ(did_you_mean({"a"}), ": did you mean a?");
  EXPECT_EQ(did_you_mean({"a", "b", "c"}), ": did you mean a, b or c?");
}

TEST(Similar, ComparesWithTheNeighboursOfTheNameWhereThereAreTooManyClasses) {
  std::string text;
  for (int number = 1000; number < 1300; ++number) text += "SubClassOf(Class" + std::to_string(number) + "x A)\n";
  const OntologySource source = written(text);
  const Ontology ontology = loaded(source);
  EXPECT_THAT(find_similar(ontology, "t:Class1234", {.classes = 16}), Contains("t:Class1234x"));
  EXPECT_THAT(find_similar(ontology, "t:Class1299", {.classes = 16}), Contains("t:Class1299x")) << "at the end";
  EXPECT_THAT(find_similar(ontology, "t:Class1000", {.classes = 16}), Contains("t:Class1000x")) << "at the begin";
  EXPECT_THAT(find_similar(ontology, "t:Zlass1234x", {.classes = 16}), Not(Contains("t:Class1234x")))
      << "it is elsewhere";
  EXPECT_THAT(find_similar(ontology, "t:Zlass1234x"), Contains("t:Class1234x"));
}

}  // namespace
}  // namespace geminga::el
