// The matcher against the model over random lives of a team. A failure is reported as the shortest life that fails.
// GEMINGA_SEED chooses another first seed.
#include "discovery/matching/random_team.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <map>

#include "discovery/matching/degrees/degree.hpp"
#include "discovery/matching/taxonomy.hpp"
#include "support/rounds.hpp"

namespace geminga::matching {
namespace {

std::vector<vocabulary::Vocabulary> ontologies() {
  const auto first = soccer([](Taxonomy& frames) {
    frames.sub("F1", "Frame")
        .sub("F2", "Frame")
        .sub("F3", "Frame")
        .sub("NewFrame", "Frame")
        .sub("Twin5106", "Ball")
        .sub("Fan", "Tracked")
        .some("Fan", "has", "OwnBall")
        .disjoint("OwnRobot", "Ball")
        .convert("PolarFieldFrame", "NewFrame")
        .convert("NewFrame", "PolarFieldFrame", 2);
  });
  Taxonomy taxonomy;
  taxonomy.sub("OwnBall", "Round").sub("Round", "Tracked").sub("OwnRobot", "Robot").sub("Robot", "Team");
  taxonomy.equivalent("Team", "Round").sub("New", "Ball").sub("Frame", "FieldFrame").unsatisfiable("Sphere");
  taxonomy.some("Robot", "has", "Ball").disjoint("New", "Robot").sub("Twin101771", "New");
  taxonomy.sub("F1", "Round")
      .sub("F2", "F1")
      .sub("F3", "Team")
      .convert("NewFrame", "Pitch", 2)
      .convert("FieldFrame", "PolarFieldFrame", 3);
  return {first.with_expressions(), taxonomy.classified().with_expressions(), {}};
}

std::string in_words(const Life& life, const std::string& wrong) {
  std::string words = wrong + "\nteam " + std::to_string(life.team) + ", steps";
  for (const std::uint64_t seed : life.steps) words += " " + std::to_string(seed) + "U,";
  return words;
}

TEST(RandomTeam, IsToldExactlyWhatWorkingEverythingOutSays) {
  const auto all = ontologies();
  const char* chosen = std::getenv("GEMINGA_SEED");
  const std::uint64_t first = chosen == nullptr ? 1 : std::strtoull(chosen, nullptr, 10);
  for (std::uint64_t seed = first; seed < first + test::rounds(8U); ++seed) {
    const Life life = random_life(seed, 1500);
    if (live(life, all).wrong.empty()) continue;
    const Life least = shortest(life, all);
    FAIL() << in_words(least, live(least, all).wrong);
  }
}

TEST(RandomTeam, IsCaughtTellingTooLittleInAFewSteps) {
  const auto all = ontologies();
  const Sabotage forget = [](std::vector<Event>& events) {
    std::erase_if(events, [](const Event& event) { return event.reason == Reason::outranked; });
  };
  const Life life = random_life(1, 1500);
  ASSERT_NE(live(life, all, forget).wrong, "");
  const Life least = shortest(life, all, forget);
  EXPECT_NE(live(least, all, forget).wrong, "");
  EXPECT_LE(least.steps.size(), 12) << in_words(least, "");
}

/// Whether random lives use a rule: where its events are suppressed, the model notices.
TEST(RandomTeam, ComesToAllThatMatchingKnows) {
  const auto all = ontologies();
  const auto is_numeric = [](const Event& event) {
    const auto* asked = std::get_if<1>(&event.about);
    const auto* number = asked == nullptr ? nullptr : std::get_if<NumericIdentity>(&(*asked)->subscription.identity);
    return number != nullptr && *number == NumericIdentity{id32(semantic("Ball"))};
  };
  const auto is_expression = [](const Event& event) {
    const auto* asked = std::get_if<1>(&event.about);
    return asked != nullptr && has_expression((*asked)->subscription.identity);
  };
  const auto is_offered_expression = [](const Event& event) {
    const auto* offered = std::get_if<0>(&event.about);
    return offered != nullptr && has_expression((*offered)->publication.identity);
  };
  const std::map<std::string, std::function<bool(const Event&)>> rules{
      {"numbers of concepts", is_numeric},
      {"expressions", is_expression},
      {"offered expressions", is_offered_expression},
      {"overlapping", [](const Event& event) { return event.match.degree == Degree::overlapping; }},
      {"conversions", [](const Event& event) { return event.match.cost != 0; }},
      {"converters", [](const Event& event) { return event.chain != nullptr && !event.chain->via.empty(); }}};
  for (const auto& [rule, is_about] : rules) {
    const Sabotage forget = [&](std::vector<Event>& events) { std::erase_if(events, is_about); };
    bool is_noticed = false;
    for (std::uint64_t seed = 3; seed <= 8 && !is_noticed; ++seed)
      is_noticed = !live(random_life(seed, 1500), all, forget).wrong.empty();
    EXPECT_TRUE(is_noticed) << rule;
  }
}

}  // namespace
}  // namespace geminga::matching
