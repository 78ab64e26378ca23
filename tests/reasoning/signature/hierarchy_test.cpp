// The information of concepts, counted by hand.
#include "reasoning/signature/hierarchy.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace geminga::signature {
namespace {

constexpr Concept vehicle{0};
constexpr Concept car{1};
constexpr Concept boat{2};
constexpr Concept amphibian{3};
constexpr Concept van{4};
constexpr Concept price{5};
constexpr Concept top{6};

/// Car and boat below vehicle, amphibian below both, van below car, and price for itself.
Hierarchy vehicles() {
  constexpr std::array<Inclusion, 7> inclusions{{{car, vehicle},
                                                 {boat, vehicle},
                                                 {amphibian, car},
                                                 {amphibian, boat},
                                                 {van, car},
                                                 {van, vehicle},
                                                 {vehicle, top}}};
  return {7, inclusions, top};
}

TEST(Hierarchy, GivesAConceptTheBitsOfAllThatIsAboveIt) {
  const Hierarchy hierarchy = vehicles();
  // Seven nodes and as many again are the world.
  EXPECT_DOUBLE_EQ(hierarchy.meaning(vehicle).bits, std::log2(14.0 / 5));
  EXPECT_DOUBLE_EQ(hierarchy.meaning(car).bits, std::log2(14.0 / 3));
  EXPECT_DOUBLE_EQ(hierarchy.meaning(van).bits, std::log2(14.0));
  EXPECT_DOUBLE_EQ(hierarchy.meaning(price).bits, std::log2(14.0));
  EXPECT_DOUBLE_EQ(hierarchy.meaning(top).bits, 0);
}

TEST(Hierarchy, CountsWhatIsBelowAllParentsWhereThereAreSeveral) {
  const Hierarchy hierarchy = vehicles();
  // Amphibians are exactly the things that are both car and boat, so that being one adds no information.
  EXPECT_DOUBLE_EQ(hierarchy.meaning(amphibian).bits, std::log2(14.0 / 5) + std::log2(5.0 / 3) + std::log2(5.0 / 2));
}

TEST(Hierarchy, SharesWhatStandsAboveBoth) {
  const Hierarchy hierarchy = vehicles();
  const auto shared = [&](Concept a, Concept b) {
    return hierarchy.shared_bits(hierarchy.meaning(a), hierarchy.meaning(b));
  };
  EXPECT_DOUBLE_EQ(shared(car, boat), std::log2(14.0 / 5));
  EXPECT_DOUBLE_EQ(shared(van, car), std::log2(14.0 / 3));
  EXPECT_DOUBLE_EQ(shared(van, price), 0);
  EXPECT_DOUBLE_EQ(shared(van, top), 0);
  EXPECT_TRUE(is_under(hierarchy.meaning(amphibian), hierarchy.meaning(vehicle)));
  EXPECT_TRUE(is_under(hierarchy.meaning(price), hierarchy.meaning(top)));
  EXPECT_FALSE(is_under(hierarchy.meaning(vehicle), hierarchy.meaning(car)));
  EXPECT_FALSE(is_under(hierarchy.meaning(top), hierarchy.meaning(car)));
}

TEST(Hierarchy, TakesConceptsThatIncludeEachOtherForOne) {
  constexpr Concept a{0};
  constexpr Concept b{1};
  constexpr Concept c{2};
  constexpr std::array<Inclusion, 3> inclusions{{{a, b}, {b, a}, {c, b}}};
  const Hierarchy hierarchy(3, inclusions);
  EXPECT_EQ(hierarchy.meaning(a).node, hierarchy.meaning(b).node);
  EXPECT_TRUE(is_under(hierarchy.meaning(c), hierarchy.meaning(a)));
  EXPECT_DOUBLE_EQ(hierarchy.meaning(a).bits, std::log2(4.0 / 2));
}

TEST(Hierarchy, HasTheSameWorldHoweverManyConceptsAreInNoOntology) {
  constexpr std::array<Inclusion, 2> inclusions{{{car, vehicle}, {boat, vehicle}}};
  const Hierarchy known(3, inclusions);
  const Hierarchy more(5, inclusions, {}, 2);
  for (const Concept one : {vehicle, car, boat}) EXPECT_EQ(known.meaning(one).bits, more.meaning(one).bits);
  const Meaning foreign = more.meaning(Concept{3});
  EXPECT_DOUBLE_EQ(foreign.bits, std::log2(6.0));
  EXPECT_EQ(more.shared_bits(foreign, more.meaning(Concept{4})), 0);
  EXPECT_EQ(more.shared_bits(foreign, more.meaning(car)), 0);
  EXPECT_DOUBLE_EQ(Hierarchy(2, {}, {}, 2).meaning(Concept{0}).bits, std::log2(2.0)) << "there is no ontology at all";
}

TEST(Hierarchy, IsTheSameWhateverTheOrderAndTheRepetitions) {
  constexpr std::array<Inclusion, 4> inclusions{{{car, vehicle}, {boat, vehicle}, {amphibian, boat}, {amphibian, car}}};
  constexpr std::array<Inclusion, 6> turned{
      {{amphibian, car}, {amphibian, vehicle}, {amphibian, boat}, {boat, vehicle}, {car, vehicle}, {car, vehicle}}};
  const Hierarchy one(5, inclusions);
  const Hierarchy other(5, turned);
  for (std::uint32_t number = 0; number < 5; ++number)
    EXPECT_DOUBLE_EQ(one.meaning(Concept{number}).bits, other.meaning(Concept{number}).bits) << number;
}

TEST(Hierarchy, CountsTheNearestAncestorsUpToTheLimit) {
  for (const std::size_t size :
       {Hierarchy::max_ancestors - 1, Hierarchy::max_ancestors, Hierarchy::max_ancestors + 1}) {
    std::vector<Inclusion> chain;
    for (std::uint32_t number = 1; number < size; ++number) chain.emplace_back(Concept{number - 1}, Concept{number});
    const Hierarchy hierarchy(static_cast<std::uint32_t>(size), chain);
    EXPECT_EQ(hierarchy.meaning(Concept{0}).ancestors.size(), std::min(size, Hierarchy::max_ancestors));
  }
}

}  // namespace
}  // namespace geminga::signature
