// Budgets of the EL closure: after one is spent, the conclusions by then follow and are said to be incomplete.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "base/random.hpp"
#include "reasoning/compiled/compile.hpp"
#include "support/reference.hpp"
#include "support/written.hpp"

namespace geminga::el {
namespace {

/// A line of parts, each within all following parts: the number of conclusions grows with the square of the parts.
std::string line_of_parts(int length) {
  std::string text = "TransitiveObjectProperty(p)\n";
  for (int at = 0; at < length; ++at) {
    const std::string name = "A" + std::to_string(at);
    text += "SubClassOf(" + name + " ObjectSomeValuesFrom(p A" + std::to_string(at + 1) + "))\n";
    text += "EquivalentClasses(In" + std::to_string(at) + " ObjectSomeValuesFrom(p " + name + "))\n";
  }
  return text;
}

std::vector<std::string> closure_of(const owl::Ontology& source, const taxonomy::Classification& classification) {
  auto ontology = compiled::Ontology::from_bytes(compiled::compile(source, classification));
  if (!ontology) ADD_FAILURE() << ontology.error().text;
  return owl::closure(*ontology);
}

taxonomy::Classification within(const owl::Ontology& source, base::Budget& budget, const ClassifyOptions& options) {
  ClassifyOptions with = options;
  with.budget = &budget;
  auto found = classify(source, with);
  if (!found) ADD_FAILURE() << found.error().text;
  return std::move(*found);
}

/// An unsatisfiable class has one line only.
bool follows(const std::string& line, const std::vector<std::string>& all) {
  return std::ranges::binary_search(all, line) ||
         std::ranges::binary_search(all, line.substr(0, line.find(' ')) + " < Nothing");
}

/// The left side of a closure's line.
std::string subject(const std::string& line) { return line.substr(0, line.find(' ')); }

std::string short_name(const owl::Ontology& source, const taxonomy::Classification& found, std::size_t of) {
  const std::string_view iri = source.name(found.classes[of]);
  return std::string(iri.substr(iri.find_last_of('#') + 1));
}

/// A classification within a budget is part of the whole, and has every subsumer of a class that it says is settled.
void expect_part(const owl::Ontology& source, const taxonomy::Classification& found,
                 const std::vector<std::string>& all) {
  const std::vector<std::string> some = closure_of(source, found);
  for (const std::string& line : some) ASSERT_TRUE(follows(line, all)) << line << " does not follow";
  if (!found.is_cut_off) {
    ASSERT_EQ(some, all);
    return;
  }
  for (std::size_t of = 0; of < found.is_settled.size(); ++of) {
    if (!found.is_settled[of]) continue;
    const std::string name = short_name(source, found, of);
    for (const std::string& line : all) {
      const bool is_found = subject(line) != name || std::ranges::binary_search(some, line);
      ASSERT_TRUE(is_found) << line << " is said not to follow";
    }
  }
}

struct Way {
  const char* name;
  ClassifyOptions options;
};
const Way ways[] = {
    {"inherited by one thread", {.threads = 1, .inherits = true}},
    {"inherited by three threads", {.threads = 3, .inherits = true}},
    {"saturated by one thread", {.threads = 1, .inherits = false}},
    {"saturated by three threads", {.threads = 3, .inherits = false}},
};

TEST(ABudgetOfTheClosure, IsSpentByAllWaysToDeriveIt) {
  const owl::Ontology source = owl::written(line_of_parts(150));
  const std::vector<std::string> all = closure_of(source, owl::classified(source));
  for (const Way& way : ways) {
    SCOPED_TRACE(way.name);
    base::Budget enough;
    const taxonomy::Classification whole = within(source, enough, way.options);
    EXPECT_FALSE(whole.is_cut_off);
    EXPECT_GT(enough.spent(), 10'000U);
    expect_part(source, whole, all);
    for (const std::uint64_t steps : {1U, 2'000U, 5'000U, 10'000U}) {
      base::Budget budget(steps);
      const taxonomy::Classification found = within(source, budget, way.options);
      EXPECT_TRUE(found.is_cut_off) << steps;
      EXPECT_TRUE(found.unused.empty());
      EXPECT_LT(budget.spent(), steps + 10'000) << "nobody works on behind the end";
      expect_part(source, found, all);
    }
  }
}

TEST(ABudgetOfTheClosure, IsEnoughWhereItIsWhatTheWorkCosts) {
  const owl::Ontology source = owl::written(line_of_parts(80));
  for (const Way& way : {ways[0], ways[2]}) {
    SCOPED_TRACE(way.name);
    base::Budget enough;
    EXPECT_FALSE(within(source, enough, way.options).is_cut_off);
    const std::uint64_t steps = enough.spent();
    ASSERT_GT(steps, 1U);
    base::Budget less(steps - 1);
    EXPECT_TRUE(within(source, less, way.options).is_cut_off);
    base::Budget same(steps);
    EXPECT_FALSE(within(source, same, way.options).is_cut_off);
    base::Budget more(steps + 1);
    EXPECT_FALSE(within(source, more, way.options).is_cut_off);
  }
}

TEST(ABudgetOfTheClosure, OfTimeThatIsOverLeavesWhatIsTold) {
  const owl::Ontology source = owl::written(line_of_parts(100) + "SubClassOf(B C)\nSubClassOf(C D)\n");
  for (const Way& way : ways) {
    base::Budget budget(base::Budget::unlimited, [] { return true; });
    const taxonomy::Classification found = within(source, budget, way.options);
    EXPECT_TRUE(found.is_cut_off) << way.name;
    const auto some = closure_of(source, found);
    EXPECT_TRUE(std::ranges::binary_search(some, "B < D")) << way.name;
  }
}

TEST(ABudgetOfTheClosure, OfAContradictionThatIsFoundLeavesNothingOpen) {
  const owl::Ontology source =
      owl::written("ClassAssertion(A i:x)\nClassAssertion(B i:x)\nDisjointClasses(A B)\n" + line_of_parts(20));
  base::Budget budget(1);
  const taxonomy::Classification found = within(source, budget, {});
  EXPECT_TRUE(found.is_cut_off || !found.is_consistent);
  EXPECT_FALSE(found.is_cut_off && !found.is_consistent);
}

TEST(ABudgetOfTheClosure, LeavesAPartOfWhatFollowsFromRandomOntologies) {
  int cut_off = 0;
  int settled = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    base::Random random(seed);
    const std::string text = owl::random_ontology(random, 30 + random.below(60)) + line_of_parts(40);
    const owl::Ontology source = owl::written(text);
    const taxonomy::Classification whole = owl::classified(source);
    const std::vector<std::string> all = closure_of(source, whole);
    if (!whole.is_consistent) continue;
    for (const Way& way : ways) {
      base::Budget budget(1 + random.below(6'000));
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + way.name);
      const taxonomy::Classification found = within(source, budget, way.options);
      if (found.is_cut_off) ++cut_off;
      if (found.is_cut_off) settled += static_cast<int>(std::ranges::count(found.is_settled, true));
      expect_part(source, found, all);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(cut_off, 50);
  EXPECT_GT(settled, 50);
}

/// A hand has fingers, which are parts of it: a successor context says what each finger learns of its hand.
std::string hands(int count) {
  std::string text = "InverseObjectProperties(p h)\nTransitiveObjectProperty(p)\nTransitiveObjectProperty(h)\n";
  for (int at = 0; at < count; ++at) {
    const std::string n = std::to_string(at);
    text += "SubClassOf(Hand" + n + " ObjectSomeValuesFrom(h Finger" + n + "))\nEquivalentClasses(OfHand" + n +
            " ObjectSomeValuesFrom(p Hand" + n + "))\nSubClassOf(ObjectSomeValuesFrom(h OfHand" + n + ") Whole" + n +
            ")\n";
  }
  return text;
}

TEST(ABudgetOfTheClosure, IsAskedBySuccessorContextsToo) {
  const owl::Ontology source = owl::written(hands(200));
  base::Budget enough;
  const taxonomy::Classification whole = within(source, enough, {});
  ASSERT_FALSE(whole.is_cut_off);
  const std::vector<std::string> all = closure_of(source, whole);
  ASSERT_TRUE(std::ranges::binary_search(all, "Hand0 < Whole0"));
  for (std::uint64_t steps = 1; steps < enough.spent(); steps += 1 + enough.spent() / 12) {
    base::Budget budget(steps);
    const taxonomy::Classification found = within(source, budget, {});
    EXPECT_TRUE(found.is_cut_off) << steps;
    EXPECT_FALSE(found.unused.empty()) << "what inverses say was not looked at to the end";
    expect_part(source, found, all);
  }
}

}  // namespace
}  // namespace geminga::el
