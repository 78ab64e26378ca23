// The program's runs: the same seed is the same run, scenarios and random faults find nothing, and what is broken is
// found.
#include "scenarios/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/text.hpp"
#include "scenarios/moment.hpp"
#include "scenarios/random_faults.hpp"
#include "scenarios/scenarios.hpp"
#include "scenarios/script.hpp"
#include "scenarios/seeds.hpp"
#include "scenarios/tables.hpp"
#include "scenarios/traffic.hpp"
#include "sim/robots.hpp"
#include "support/rounds.hpp"

namespace geminga::scenarios {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;
using testing::Contains;
using testing::IsEmpty;
using testing::StartsWith;

/// $GEMINGA_SEED moves all of them.
std::uint64_t first_seed() { return sim::World::seed_or(1); }

TEST(Seeds, OfRandomFaultsFindNothing) {
  const Seeds seeds{.first = first_seed(), .last = first_seed() + test::rounds(200U) - 1};
  const auto failure = run_seeds(seeds, 2, random_conditions);
  EXPECT_FALSE(failure.has_value()) << "tools/simulate --faults --seed " << failure->seed << "\n" << failure->violation;
}

TEST(Seeds, GiveTheSameRunTwiceAndAnotherOneEach) {
  std::set<std::uint64_t> hashes;
  const std::size_t count = std::max(2U, test::rounds(10U));
  for (std::uint64_t seed = first_seed(); seed < first_seed() + count; ++seed) {
    const std::uint64_t hash = simulate(random_conditions(seed)).trace_hash;
    EXPECT_EQ(simulate(random_conditions(seed)).trace_hash, hash) << "seed " << seed;
    hashes.insert(hash);
  }
  EXPECT_EQ(hashes.size(), count);
}

TEST(Seeds, StopAtTheFirstOneThatFindsSomething) {
  const auto conditions = [](std::uint64_t seed) {
    Conditions one;
    one.seed = seed;
    one.participants = 2;
    one.time = seconds(5);
    one.air.loss = seed >= 4 ? 1 : 0;
    return one;
  };
  const auto failure = run_seeds({.first = 1, .last = 1000}, 2, conditions);
  ASSERT_TRUE(failure.has_value());
  EXPECT_EQ(failure->seed, 4U);
  EXPECT_FALSE(run_seeds({.first = 1, .last = 3}, 2, conditions).has_value());
}

class Named : public testing::TestWithParam<std::string> {};

TEST_P(Named, FindsNothing) {
  Conditions conditions = find_scenario(GetParam())->conditions;
  conditions.seed = first_seed();
  std::vector<std::string> lines;
  const Result result = simulate(conditions, [&](const std::string& line) { lines.push_back(line); });
  EXPECT_THAT(result.violations, IsEmpty()) << testing::PrintToString(lines);
}

std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const Scenario& one : all_scenarios()) names.emplace_back(one.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Scenarios, Named, testing::ValuesIn(names()), [](const auto& one) {
  std::string name = one.param;
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST(Simulation, TellsWhatHappened) {
  std::vector<std::string> lines;
  Conditions conditions = find_scenario("tunnel")->conditions;
  conditions.time = minutes(2);
  (void)simulate(conditions, [&](const std::string& line) { lines.push_back(line); });
  EXPECT_THAT(lines, Contains("  1:10.000  cut off from the others: robot1"));
  EXPECT_THAT(lines, Contains("  1:50.000  hear the others again: robot1"));
}

TEST(Simulation, MeasuresADeathAndComplainsOfNothing) {
  Conditions conditions;
  conditions.time = seconds(30);
  conditions.write = [](Script& script, base::Random&) { script.crash(seconds(12), 3); };
  const Result result = simulate(conditions);
  EXPECT_THAT(result.violations, IsEmpty());
  ASSERT_FALSE(result.delays.crashed.empty());
  EXPECT_GT(quantile(result.delays.crashed, 0), seconds(2));
  EXPECT_LT(quantile(result.delays.crashed, 100), seconds(6));
}

TEST(Simulation, ComplainsWhenATeamDoesNotAgree) {
  Conditions conditions;
  conditions.participants = 2;
  conditions.time = seconds(5);
  conditions.air.loss = 1;
  const Result result = simulate(conditions);
  EXPECT_THAT(result.violations, Contains(StartsWith("agreement")));
}

/// A team whose complaints are kept.
struct Kept {
  std::vector<std::string> complaints;
  sim::World world{first_seed(), {}, [this](const std::string& words) { complaints.push_back(words); }};
  sim::Team team{world};
  Kept() {
    for (const char* name : {"robot1", "robot2"}) sim::furnish(team, world.add_host(name));
    for (const auto& host : world.hosts()) host->switch_on();
    for (const auto& module : team.modules()) module->run();
  }
};

TEST(Traffic, IsFoundWhereItIsTooMuch) {
  Kept kept;
  const Traffic strict(kept.world, 3);
  const Traffic usual(kept.world);
  kept.world.run_for(seconds(31));
  EXPECT_THAT(kept.complaints, Contains(StartsWith("traffic: robot1 sent ")));
  EXPECT_THAT(kept.complaints, testing::Not(Contains(testing::HasSubstr(std::to_string(most_datagrams)))));
}

TEST(Tables, FindWhoIsKeptThoughHeIsGone) {
  Kept kept;
  Tables tables(kept.world, kept.team);
  kept.world.run_for(seconds(20));
  tables.check_all();
  EXPECT_THAT(kept.complaints, IsEmpty());
  kept.world.hosts()[1]->crash();
  tables.check_all();  // within the deadline
  EXPECT_THAT(kept.complaints, Contains(StartsWith("tables: robot1 knows 2 participants, and there are 1")));
}

}  // namespace
}  // namespace geminga::scenarios
