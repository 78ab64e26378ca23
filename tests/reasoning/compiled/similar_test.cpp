// Names that are nearly right, in small ontologies and in ones that are too large to be compared as a whole.
#include "reasoning/compiled/similar.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <string>
#include <utility>

#include "base/random.hpp"
#include "support/written.hpp"

namespace geminga::compiled {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(Similar, GivesTheNearestNamesFirst) {
  owl::Ontology source =
      owl::written("SubClassOf(Camera Sensor)\nSubClassOf(Cameras Sensor)\nSubClassOf(Lidar Sensor)\n");
  source.add_label("https://t.example/#Lidar", "laser scanner", "en");
  const Ontology ontology = owl::loaded(source);
  EXPECT_THAT(find_similar(ontology, "t:Camrea"), ElementsAre("t:Camera", "t:Cameras"));
  EXPECT_THAT(find_similar(ontology, "t:Camrea", {.names = 1}), ElementsAre("t:Camera"));
  EXPECT_THAT(find_similar(ontology, "laser scaner"), ElementsAre("t:Lidar"));
  EXPECT_THAT(find_similar(ontology, "t:Elephant"), IsEmpty());
  EXPECT_EQ(did_you_mean({}), "");
  EXPECT_EQ(did_you_mean({"a"}), ": did you mean a?");
  EXPECT_EQ(did_you_mean({"a", "b", "c"}), ": did you mean a, b or c?");
}

TEST(Similar, FindsASlipAnywhereInANameWhereThereAreTooManyClassesToCompare) {
  std::string text;
  for (int number = 1000; number < 1300; ++number) text += "SubClassOf(Class" + std::to_string(number) + "x A)\n";
  const owl::Ontology source = owl::written(text);
  const Ontology ontology = owl::loaded(source);
  EXPECT_THAT(find_similar(ontology, "t:Class1234", {.classes = 16}), Contains("t:Class1234x"));
  EXPECT_THAT(find_similar(ontology, "t:Class1299", {.classes = 16}), Contains("t:Class1299x")) << "at the end";
  EXPECT_THAT(find_similar(ontology, "t:Class1000", {.classes = 16}), Contains("t:Class1000x")) << "at the begin";
  EXPECT_THAT(find_similar(ontology, "t:Zlass1234x", {.classes = 16}), Contains("t:Class1234x")) << "the first letter";
  EXPECT_THAT(find_similar(ontology, "Clsas1234x", {.classes = 16}), Contains("t:Class1234x")) << "without its prefix";
  EXPECT_THAT(find_similar(ontology, "t:Elephant", {.classes = 16}), IsEmpty());
}

TEST(Similar, ASlipChangesSixBitsOfASignatureAtMost) {
  base::Random random(11);
  for (int round = 0; round < 2000; ++round) {
    std::string word;
    for (std::uint64_t size = 1 + random.below(20); word.size() < size;)
      word += static_cast<char>('a' + random.below(26));
    std::string slip = word;
    const std::size_t at = random.below(word.size());
    switch (random.below(4)) {
      case 0:
        slip[at] = static_cast<char>('A' + random.below(26));
        break;
      case 1:
        slip.erase(at, 1);
        break;
      case 2:
        slip.insert(at, 1, static_cast<char>('a' + random.below(26)));
        break;
      default:
        if (at > 0) std::swap(slip[at], slip[at - 1]);
    }
    EXPECT_LE(std::popcount(signature_of(word) ^ signature_of(slip)), 6) << word << ' ' << slip;
  }
  EXPECT_EQ(signature_of("BallInfo"), signature_of("ballinfo"));
}

}  // namespace
}  // namespace geminga::compiled
