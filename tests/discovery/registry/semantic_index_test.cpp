// The semantic index against a model that looks at every entry, over random changes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "base/random.hpp"
#include "discovery/registry/entries.hpp"
#include "discovery/registry/table.hpp"

namespace geminga::registry {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SemanticIndex, APublicationIsFoundUnderEverySubsumer) {
  Publications table;
  table.set_class_count(4);
  const std::vector<ClassIndex> below{1, 2, 3};
  const auto& stored = table.insert(offer(key(1, 1, 1), semantic("c1")), {1, below});
  for (const ClassIndex number : below) {
    EXPECT_THAT(keys_of_filed(table.below(number)), ElementsAre(key(1, 1, 1))) << number;
  }
  EXPECT_THAT(keys_of_filed(table.below(0)), IsEmpty());
  EXPECT_THAT(keys_of_filed(table.own(1)), ElementsAre(key(1, 1, 1)));
  EXPECT_THAT(keys_of_filed(table.own(2)), IsEmpty());
  table.erase(stored);
  for (const ClassIndex number : below) EXPECT_THAT(keys_of_filed(table.below(number)), IsEmpty()) << number;
}

TEST(SemanticIndex, AClassOutsideTheOntologyHasNobody) {
  Publications table;
  EXPECT_THAT(keys_of_filed(table.below(0)), IsEmpty());
  table.set_class_count(1);
  EXPECT_THAT(keys_of_filed(table.below(0)), IsEmpty());
  EXPECT_THAT(keys_of_filed(table.below(1)), IsEmpty());
  EXPECT_THAT(keys_of_filed(table.own(1)), IsEmpty());
}

TEST(SemanticIndex, TwoOntologiesAreFiledBesideEachOther) {
  Publications table;
  table.set_class_count(2);
  const std::vector<ClassIndex> both{0, 1};
  const auto& stored = table.insert(offer(key(1, 1, 1), semantic("a")), {0, both});
  table.set_class_count(3, Generation::odd);
  EXPECT_THAT(keys_of_filed(table.below(1, Generation::odd)), IsEmpty());
  const std::vector<ClassIndex> last{2};
  table.refile(stored, {2, last, {}, Generation::odd});
  EXPECT_THAT(keys_of_filed(table.below(2, Generation::odd)), ElementsAre(key(1, 1, 1)));
  EXPECT_THAT(keys_of_filed(table.below(1)), ElementsAre(key(1, 1, 1)));
  EXPECT_THAT(keys_of_filed(table.below(2)), IsEmpty());
  table.unfile(stored, Generation::even);
  EXPECT_THAT(keys_of_filed(table.below(1)), IsEmpty());
  table.set_class_count(0);
  EXPECT_THAT(keys_of_filed(table.below(2, Generation::odd)), ElementsAre(key(1, 1, 1)));
  EXPECT_THAT(keys_of_filed(table.with_concept("http://example.org/a")), ElementsAre(key(1, 1, 1)));
  table.refile(stored, {{}, {}, {}, Generation::odd});
  EXPECT_THAT(keys_of_filed(table.below(2, Generation::odd)), IsEmpty());
  table.erase(stored);
  EXPECT_THAT(keys_of_filed(table.with_concept("http://example.org/a")), IsEmpty());
}

/// The expected answer of the index, found by looking at every entry.
struct Model {
  struct Filed {
    Identity identity;
    std::optional<ClassIndex> own;
    std::set<ClassIndex> below;
  };
  std::map<ServiceKey, Filed> entries;

  template <typename Wanted>
  std::vector<ServiceKey> keys(const Wanted& wanted) const {
    std::vector<ServiceKey> found;
    for (const auto& [one, filed] : entries) {
      if (wanted(filed)) found.push_back(one);
    }
    return found;
  }
};

constexpr std::uint32_t class_count = 12;

Model::Filed random_filing(base::Random& random) {
  Model::Filed filed;
  const auto number = static_cast<ClassIndex>(random.below(class_count));
  filed.identity = semantic("c" + std::to_string(number), random.chance(0.5) ? "r" : "");
  if (random.chance(0.2)) filed.identity = TextIdentity{"t" + std::to_string(number)};
  if (random.chance(0.2)) return filed;
  filed.own = number;
  for (ClassIndex wider = 0; wider < class_count; ++wider) {
    if (wider == number || random.chance(0.3)) filed.below.insert(wider);
  }
  return filed;
}

void expect_equal(const Publications& table, const Model& model) {
  for (ClassIndex number = 0; number < class_count; ++number) {
    ASSERT_EQ(keys_of_filed(table.below(number)),
              model.keys([number](const auto& filed) { return filed.below.contains(number); }));
    ASSERT_EQ(keys_of_filed(table.own(number)),
              model.keys([number](const auto& filed) { return filed.own == number; }));
    const auto concept_name = "c" + std::to_string(number);
    ASSERT_EQ(keys_of_filed(table.with_concept("http://example.org/" + concept_name)),
              model.keys([&](const auto& filed) {
                return filed.identity == semantic(concept_name) || filed.identity == semantic(concept_name, "r");
              }));
    for (const Identity& identity :
         {semantic(concept_name), semantic(concept_name, "r"), Identity(TextIdentity{"t" + std::to_string(number)})}) {
      ASSERT_EQ(keys_of_filed(table.with_identity(identity, id32(identity))),
                model.keys([&](const auto& filed) { return filed.identity == identity; }));
    }
  }
}

TEST(SemanticIndex, AgreesWithLookingAtEveryEntry) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    base::Random random(seed);
    Publications table;
    Model model;
    table.set_class_count(class_count);
    for (int step = 0; step < 400; ++step) {
      const auto one = key(1, 1, static_cast<std::uint32_t>(random.below(40)));
      const auto filed = random_filing(random);
      const std::vector<ClassIndex> below(filed.below.begin(), filed.below.end());
      const StoredPublication* known = table.find(one);
      if (known == nullptr) {
        table.insert(offer(one, filed.identity), {filed.own, below});
        model.entries[one] = filed;
      } else if (random.chance(0.5)) {
        table.erase(*known);
        model.entries.erase(one);
      } else if (random.chance(0.5)) {
        table.replace(*known, offer(one, filed.identity), {filed.own, below});
        model.entries[one] = filed;
      } else {
        table.refile(*known, {filed.own, below});
        model.entries[one].own = filed.own;
        model.entries[one].below = filed.below;
      }
      ASSERT_NO_FATAL_FAILURE(expect_equal(table, model)) << "step " << step;
    }
  }
}

}  // namespace
}  // namespace geminga::registry
