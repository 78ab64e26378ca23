// The stages of a change from one vocabulary to another.
#include "discovery/matching/editions.hpp"

#include <gtest/gtest.h>

#include "discovery/matching/taxonomy.hpp"

namespace geminga::matching {
namespace {

TEST(Editions, GoThroughTheStagesOfAChangeAndEndWithTheNextOneAlone) {
  const auto first = soccer();
  const auto next = soccer([](Taxonomy& taxonomy) { taxonomy.sub("Car", "Tracked"); });
  Editions editions(first);
  EXPECT_EQ(editions.stage(), ChangeStage::none);
  EXPECT_EQ(editions.other().converters, nullptr);
  editions.begin_filing(next);
  EXPECT_TRUE(editions.are_both_filed());
  EXPECT_TRUE(editions.in_force().vocabulary.has_ontology_of(first));
  EXPECT_TRUE(editions.other().vocabulary.has_ontology_of(next));
  EXPECT_NE(editions.in_force().generation, editions.other().generation);
  editions.begin_rematching();
  EXPECT_TRUE(editions.are_both_filed());
  EXPECT_TRUE(editions.in_force().vocabulary.has_ontology_of(next));
  EXPECT_EQ(&editions.by_generation(editions.in_force().generation), &editions.in_force());
  EXPECT_EQ(&editions.by_generation(editions.other().generation), &editions.other());
  editions.begin_unfiling();
  EXPECT_FALSE(editions.are_both_filed());
  editions.end_change();
  EXPECT_EQ(editions.stage(), ChangeStage::none);
  EXPECT_TRUE(editions.in_force().vocabulary.has_ontology_of(next));
  EXPECT_EQ(editions.other().converters, nullptr) << "the former one is released";
}

}  // namespace
}  // namespace geminga::matching
