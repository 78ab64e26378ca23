// Saturation by many threads: the same result as by one, with no rule left to fire; and its limits.
#include "base/parallel/threads.hpp"

#include <gtest/gtest.h>

#include <string>

#include "base/random.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/el/closure/inheritance.hpp"
#include "reasoning/el/index/index_builder.hpp"
#include "saturated.hpp"
#include "support/reference.hpp"
#include "support/rounds.hpp"
#include "support/written.hpp"

namespace geminga::el {
namespace {

std::string functional_properties(base::Random& random) {
  std::string text;
  for (int role = 0; role < 4; ++role) {
    if (random.chance(0.3)) text += "FunctionalObjectProperty(r" + std::to_string(role) + ")\n";
    if (random.chance(0.2)) text += "SubClassOf(C1 ObjectMaxCardinality(1 r" + std::to_string(role) + "))\n";
  }
  return text;
}

std::string individuals(base::Random& random) {
  std::string text;
  const auto name = [&] { return "i:a" + std::to_string(random.below(4)); };
  for (std::uint64_t count = random.below(6); count > 0; --count) {
    const std::string role = "r" + std::to_string(random.below(4));
    switch (random.below(5)) {
      case 0:
        text += "ClassAssertion(C" + std::to_string(random.below(6)) + " " + name() + ")\n";
        break;
      case 1:
        text += "ObjectPropertyAssertion(" + role + " " + name() + " " + name() + ")\n";
        break;
      case 2:
        text += "SubClassOf(C" + std::to_string(random.below(6)) + " ObjectHasValue(" + role + " " + name() + "))\n";
        break;
      case 3:
        text += "SubClassOf(C" + std::to_string(random.below(6)) + " ObjectOneOf(" + name() + "))\n";
        break;
      default:
        text += "SubClassOf(ObjectHasValue(" + role + " " + name() + ") C" + std::to_string(random.below(6)) + ")\n";
    }
  }
  return text;
}

TEST(Saturation, LeavesNoRuleToFire) {
  for (std::uint64_t seed = 1; seed <= test::rounds(300U); ++seed) {
    base::Random random(seed);
    std::string text = owl::random_ontology(random, 4 + random.below(24));
    if (random.chance(0.4)) text += functional_properties(random);
    if (random.chance(0.4)) text += individuals(random);
    const unsigned threads = 1 + static_cast<unsigned>(seed % 3);
    const Saturated found(owl::written(text), threads);
    // The run ends early if the ontology is inconsistent.
    if (!found.saturation->is_consistent()) continue;
    ASSERT_EQ(rule_left_to_fire(found.index, *found.saturation), "")
        << "seed " << seed << ", " << threads << " threads\n"
        << text;
  }
}

TEST(Saturation, IsValidatedByOneThatSeesWhatIsMissing) {
  const owl::Ontology source = owl::written(
      "SubClassOf(A ObjectSomeValuesFrom(r B))\nSubClassOf(B C)\n"
      "SubClassOf(ObjectSomeValuesFrom(r C) D)\nSubClassOf(D ObjectSomeValuesFrom(s A))");
  const Saturated whole(source, 1);
  EXPECT_EQ(rule_left_to_fire(whole.index, *whole.saturation), "");
  const Saturated cut(source, 1, SaturationLimits{.conclusions = 3});
  EXPECT_TRUE(cut.saturation->is_over_limit());
  EXPECT_NE(rule_left_to_fire(cut.index, *cut.saturation), "");
}

TEST(Threads, GiveTheSameBytesInAnyNumberAndOrder) {
  for (std::uint64_t seed = 1; seed <= test::rounds(60U); ++seed) {
    base::Random random(seed);
    std::string text = owl::random_ontology(random, 8 + random.below(30));
    if (random.chance(0.3)) text += functional_properties(random);
    const owl::Ontology source = owl::written(text);
    const auto bytes_of = [&](unsigned threads) {
      ClassifyOptions options;
      options.threads = threads;
      return compiled::compile(source, *classify(source, options));
    };
    const auto one = bytes_of(1);
    for (const unsigned threads : {2U, 5U}) {
      ASSERT_EQ(one, bytes_of(threads)) << "seed " << seed << ", " << threads << " threads\n" << text;
    }
  }
}

/// A tree of classes with links across: enough contexts for threads to meet.
std::string wide_ontology(base::Random& random, std::uint64_t classes) {
  std::string text = "TransitiveObjectProperty(r0)\nSubObjectPropertyOf(r1 r0)\n";
  const auto name = [](std::uint64_t number) { return "C" + std::to_string(number); };
  for (std::uint64_t at = 1; at < classes; ++at) {
    text += "SubClassOf(" + name(at) + " " + name(at / 3) + ")\n";
    const std::string some =
        "ObjectSomeValuesFrom(r" + std::to_string(random.below(3)) + " " + name(random.below(at)) + ")";
    if (random.chance(0.3)) text += "SubClassOf(" + name(at) + " " + some + ")\n";
    if (random.chance(0.2)) {
      text += "EquivalentClasses(" + name(random.below(classes)) + " ObjectIntersectionOf(" + name(random.below(at)) +
              " " + some + "))\n";
    }
  }
  return text;
}

TEST(Threads, AgreeOnWhatIsLargeEnoughToBeShared) {
  for (std::uint64_t seed = 1; seed <= test::rounds(3U); ++seed) {
    base::Random random(seed);
    const owl::Ontology source = owl::written(wide_ontology(random, 400));
    const Saturated one(source, 1);
    const Saturated many(source, 4);
    ASSERT_EQ(one.saturation->contexts().size(), many.saturation->contexts().size()) << "seed " << seed;
    EXPECT_EQ(one.saturation->conclusion_count(), many.saturation->conclusion_count()) << "seed " << seed;
    EXPECT_EQ(one.saturation->link_count(), many.saturation->link_count()) << "seed " << seed;
    ClassifyOptions options;
    options.threads = parallel::max_threads + 1;
    EXPECT_EQ(compiled::compile(source, owl::classified(source)), compiled::compile(source, *classify(source, options)))
        << "seed " << seed;
  }
}

TEST(Threads, FindTheClassesOfALargeSourceWhileItsAxiomsAreAdded) {
  std::string text;
  for (int at = 1; at <= 11'000; ++at)
    text += "SubClassOf(C" + std::to_string(at) + " C" + std::to_string(at / 3) + ")\n";
  const owl::Ontology source = owl::written(text);
  ClassifyOptions options;
  options.threads = 2;
  EXPECT_EQ(compiled::compile(source, owl::classified(source)), compiled::compile(source, *classify(source, options)));
}

/// The start of a closure: the index of a source and the atoms that are asked for.
struct Indexed {
  explicit Indexed(const owl::Ontology& source) {
    IndexBuilder builder;
    RuleNormaliser normaliser(source, builder);
    for (std::uint32_t axiom = 0; axiom < source.axiom_count(); ++axiom) (void)normaliser.add(axiom);
    for (std::uint32_t id = 0; id < source.term_count(); ++id) {
      if (source.kind(owl::TermId{id}) == owl::TermKind::named_class)
        asked.push_back(normaliser.expression(owl::TermId{id}));
    }
    (void)normaliser.finish();
    index = *builder.finish(1000000);
    for (ExprId& expr : asked) expr = index.representative(expr);
  }
  IndexedOntology index;
  std::vector<ExprId> asked;
};

TEST(Inheritance, FindsWhatSaturationFinds) {
  for (std::uint64_t seed = 1; seed <= test::rounds(200U); ++seed) {
    base::Random random(seed);
    std::string text = owl::random_ontology(random, 8 + random.below(40));
    if (random.chance(0.3)) text += wide_ontology(random, 60);
    if (random.chance(0.2)) text += "ReflexiveObjectProperty(r0)\nSubClassOf(ObjectHasSelf(r0) C1)\n";
    if (random.chance(0.2)) text += "ClassAssertion(C1 i:a)\nObjectPropertyAssertion(r1 i:b i:c)\n";
    const owl::Ontology source = owl::written(text);
    const unsigned threads = 1 + static_cast<unsigned>(seed % 3);
    ClassifyOptions by_saturation;
    by_saturation.inherits = false;
    ClassifyOptions by_inheritance;
    by_inheritance.threads = threads;
    taxonomy::Classification saturated = *classify(source, by_saturation);
    const taxonomy::Classification inherited = *classify(source, by_inheritance);
    // The rules leave a range over irregular chains out, which the test of ranges may find to change nothing.
    if (inherited.unused.size() < saturated.unused.size()) saturated.unused = inherited.unused;
    ASSERT_EQ(compiled::compile(source, saturated), compiled::compile(source, inherited))
        << "seed " << seed << ", " << threads << " threads\n"
        << text;
  }
}

TEST(Inheritance, StopsAtTheLimitOfConclusionsAndNotBefore) {
  base::Random random(1);
  const owl::Ontology source = owl::written(wide_ontology(random, 600));
  const Indexed indexed(source);
  ASSERT_TRUE(Inheritance::is_for(indexed.index));
  Inheritance all(indexed.index, {}, indexed.asked);
  ASSERT_TRUE(all.run());
  for (const unsigned threads : {1U, 3U}) {
    Inheritance enough(indexed.index, {.conclusions = all.conclusion_count() * 2}, indexed.asked);
    EXPECT_TRUE(enough.run(threads)) << threads;
    Inheritance too_few(indexed.index, {.conclusions = all.conclusion_count() / 4}, indexed.asked);
    EXPECT_FALSE(too_few.run(threads)) << threads;
  }
}

TEST(Inheritance, LetsGoOfWhatNobodyWillAskFor) {
  // One class with many classes above it has many leaves below it.
  std::string text;
  for (int at = 1; at <= 50; ++at) {
    const std::string number = std::to_string(at);
    text += "SubClassOf(A B" + number + ")\nSubClassOf(ObjectIntersectionOf(B" + number + " X) Y)\n" + "SubClassOf(C" +
            number + " A)\nSubClassOf(C" + number + " ObjectSomeValuesFrom(r D" + number + "))\n";
  }
  const owl::Ontology source = owl::written(text);
  const Indexed indexed(source);
  Inheritance inheritance(indexed.index, {}, indexed.asked);
  ASSERT_TRUE(inheritance.run());
  std::size_t kept = 0;
  for (const Node& node : inheritance.nodes()) kept += node.items.size();
  EXPECT_GT(inheritance.conclusion_count(), 50U * 50U);
  EXPECT_LT(kept, 1000U);
}

TEST(Threads, StopTogetherAtTheLimitOfConclusions) {
  base::Random random(1);
  const owl::Ontology source = owl::written(wide_ontology(random, 600));
  const std::size_t all = Saturated(source, 1).saturation->conclusion_count();
  for (const unsigned threads : {1U, 3U}) {
    EXPECT_FALSE(Saturated(source, threads, {.conclusions = all}).saturation->is_over_limit()) << threads;
    EXPECT_TRUE(Saturated(source, threads, {.conclusions = all / 4}).saturation->is_over_limit()) << threads;
  }
}

TEST(Threads, StopTogetherWhereTheOntologyIsInconsistent) {
  base::Random random(1);
  const owl::Ontology source =
      owl::written(wide_ontology(random, 500) + "ClassAssertion(C400 i:a)\nDisjointClasses(C44 C14)");
  for (const unsigned threads : {1U, 4U}) EXPECT_FALSE(Saturated(source, threads).saturation->is_consistent());
}

/// A counter of n bits, in which a bit is one of two kinds of successors of a functional role: each number is a
/// context.
std::string counter(int bits) {
  std::string text;
  for (int bit = 0; bit < bits; ++bit) {
    const std::string number = std::to_string(bit);
    for (const char* kind : {"X", "Y"}) {
      const std::string name = kind + number;
      text += std::string("SubClassOf(A ObjectSomeValuesFrom(f B))\n") + "SubClassOf(" + name +
              " ObjectSomeValuesFrom(f " + name + "))\nSubClassOf(" + name + " ObjectSomeValuesFrom(g " + name + "))\n";
    }
    text += "SubClassOf(B ObjectSomeValuesFrom(f X" + number + "))\nSubClassOf(B ObjectSomeValuesFrom(g Y" + number +
            "))\n";
  }
  text += "SubClassOf(B ObjectSomeValuesFrom(f B))\nSubClassOf(B ObjectSomeValuesFrom(g B))\n";
  return text + "FunctionalObjectProperty(f)\nFunctionalObjectProperty(g)\n";
}

TEST(Merging, IsLimitedAndSaidToBe) {
  const owl::Ontology source = owl::written(counter(6));
  const Saturated all(source, 1);
  ASSERT_TRUE(all.saturation->is_consistent());
  ASSERT_FALSE(all.saturation->is_over_limit());
  std::size_t merged = 0;
  for (const Context& context : all.saturation->contexts()) merged += context.together.size();
  ASSERT_GT(merged, 10U);
  EXPECT_FALSE(Saturated(source, 1, {.merged_atoms = merged}).saturation->is_over_merged());
  EXPECT_TRUE(Saturated(source, 1, {.merged_atoms = merged - 1}).saturation->is_over_merged());
  ClassifyOptions options;
  options.limits.merged_atoms = merged;
  EXPECT_TRUE(classify(source, options)->unused.empty());
  options.limits.merged_atoms = merged - 1;
  const auto weaker = classify(source, options);
  ASSERT_EQ(weaker->unused.size(), 2U);
  EXPECT_EQ(weaker->unused.front().construct, "functional properties with too many successors");
}

}  // namespace
}  // namespace geminga::el
