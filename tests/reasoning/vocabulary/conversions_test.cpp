// The cheapest chain of conversions: small cases, and random ones against all chains that there are.
#include "reasoning/vocabulary/conversions.hpp"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "base/random.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"
#include "support/rounds.hpp"
#include "support/written.hpp"

namespace geminga::vocabulary {
namespace {

using Declared = std::vector<std::tuple<std::string, std::string, int>>;

Vocabulary with(std::string_view axioms, const Declared& declared) {
  owl::Ontology source = owl::written(axioms);
  for (const auto& [from, to, cost] : declared) {
    source.add_conversion("https://t.example/#" + from, "https://t.example/#" + to, std::to_string(cost),
                          owl::FileId{0}, 1);
  }
  return Vocabulary(owl::loaded(source));
}

/// "A>B>C cost distance" or "none".
std::string chain(const Vocabulary& vocabulary, std::string_view offered, std::string_view requested) {
  const auto found = vocabulary.conversion(*vocabulary.find(offered), *vocabulary.find(requested));
  if (found == nullptr) return "none";
  std::string words;
  for (const ClassNumber one : found->classes) words += (words.empty() ? "" : ">") + vocabulary.short_name(one);
  return words + " " + std::to_string(found->cost) + " " + std::to_string(found->distance);
}

TEST(Conversions, AreOnlyThoseThatAreDeclared) {
  const Vocabulary frames = with("SubClassOf(A T)\nSubClassOf(B T)\nSubClassOf(C T)", {{"A", "B", 2}});
  EXPECT_EQ(chain(frames, "t:A", "t:B"), "t:A>t:B 2 0");
  EXPECT_EQ(chain(frames, "t:B", "t:A"), "none");
  EXPECT_EQ(chain(frames, "t:A", "t:C"), "none");
  EXPECT_EQ(chain(frames, "t:T", "t:B"), "none") << "what is in T need not be in A";
  EXPECT_EQ(chain(frames, "t:A", "t:T"), "t:A>t:B 2 1");
  EXPECT_EQ(chain(Vocabulary(owl::loaded("SubClassOf(A B)")), "t:A", "t:B"), "none");
}

TEST(Conversions, TakeTheCheapestChainAndOfThoseTheShortest) {
  const Vocabulary frames = with("SubClassOf(A T)\nSubClassOf(B T)\nSubClassOf(C T)\nSubClassOf(D T)",
                                 {{"A", "B", 2}, {"B", "C", 3}, {"A", "C", 6}, {"C", "D", 1}, {"B", "D", 4}});
  EXPECT_EQ(chain(frames, "t:A", "t:C"), "t:A>t:B>t:C 5 0");
  EXPECT_EQ(chain(frames, "t:A", "t:D"), "t:A>t:B>t:D 6 0");
}

TEST(Conversions, TakeOfThoseTheOneThatClimbsTheLeast) {
  // A is offered, which is below B, and B is below C. E is requested, and D is below it.
  const std::string axioms = "SubClassOf(A B)\nSubClassOf(B C)\nSubClassOf(D E)\nSubClassOf(X T)\nSubClassOf(Y T)";
  EXPECT_EQ(chain(with(axioms, {{"C", "E", 1}, {"B", "E", 1}, {"C", "D", 1}}), "t:A", "t:E"), "t:B>t:E 1 1");
  EXPECT_EQ(chain(with(axioms, {{"B", "D", 1}, {"A", "D", 1}}), "t:A", "t:E"), "t:A>t:D 1 1");
  EXPECT_EQ(chain(with(axioms, {{"C", "X", 1}, {"X", "E", 1}, {"A", "Y", 1}, {"Y", "E", 1}}), "t:A", "t:E"),
            "t:A>t:Y>t:E 2 0");
  EXPECT_EQ(chain(with(axioms, {{"C", "E", 1}, {"A", "X", 1}, {"X", "E", 1}}), "t:A", "t:E"), "t:C>t:E 1 2")
      << "what is cheaper comes before";
}

TEST(Conversions, GoOnFromWhatIsBelow) {
  const Vocabulary frames = with(
      "SubClassOf(Offered A)\nSubClassOf(B Above)\nSubClassOf(Above Top)\nSubClassOf(C Wanted)\n"
      "EquivalentClasses(Wanted Asked)",
      {{"A", "B", 1}, {"Above", "C", 1}});
  EXPECT_EQ(chain(frames, "t:Offered", "t:Asked"), "t:A>t:B>t:C 2 3");
  EXPECT_EQ(chain(frames, "t:Offered", "t:Above"), "t:A>t:B 1 2");
}

TEST(Conversions, LeadInCirclesWithoutEnd) {
  const Vocabulary frames = with("SubClassOf(A T)\nSubClassOf(B T)\nSubClassOf(C T)",
                                 {{"A", "A", 1}, {"A", "B", 1}, {"B", "A", 1}, {"B", "B", 1}});
  EXPECT_EQ(chain(frames, "t:A", "t:B"), "t:A>t:B 1 0");
  EXPECT_EQ(chain(frames, "t:A", "t:C"), "none");
}

TEST(Conversions, AreNotOfWhatCanHaveNoInstance) {
  const Vocabulary frames =
      with("SubClassOf(A T)\nSubClassOf(B T)\nSubClassOf(Ghost Nothing)", {{"A", "Ghost", 1}, {"Ghost", "B", 1}});
  EXPECT_EQ(chain(frames, "t:A", "t:B"), "none");
  EXPECT_EQ(chain(frames, "t:A", "t:T"), "none");
}

TEST(Conversions, AreEightInOneChainAtMost) {
  std::string axioms;
  Declared declared;
  for (char name = 'A'; name < 'K'; ++name) {
    axioms += "SubClassOf(" + std::string(1, name) + " Top)\n";
    declared.emplace_back(std::string(1, name), std::string(1, static_cast<char>(name + 1)), 1);
  }
  axioms += "SubClassOf(K Top)";
  const Vocabulary frames = with(axioms, declared);
  EXPECT_EQ(chain(frames, "t:A", "t:H"), "t:A>t:B>t:C>t:D>t:E>t:F>t:G>t:H 7 0");
  EXPECT_EQ(chain(frames, "t:A", "t:I"), "t:A>t:B>t:C>t:D>t:E>t:F>t:G>t:H>t:I 8 0");
  EXPECT_EQ(chain(frames, "t:A", "t:J"), "none");
}

TEST(Conversions, HaveAMarkThatTellsTheirClasses) {
  const Vocabulary one = with("SubClassOf(A T)\nSubClassOf(B T)", {{"A", "B", 2}, {"B", "A", 2}});
  const Vocabulary other = with("SubClassOf(A T)\nSubClassOf(B T)\nSubClassOf(AA T)", {{"A", "B", 2}});
  const auto mark = [](const Vocabulary& of, const char* from, const char* to) {
    return of.conversion(*of.find(from), *of.find(to))->mark;
  };
  EXPECT_EQ(mark(one, "t:A", "t:B"), mark(other, "t:A", "t:B"));
  EXPECT_NE(mark(one, "t:A", "t:B"), mark(one, "t:B", "t:A"));
}

/// The least cost of all chains of up to `left` conversions, or nothing.
std::optional<std::uint32_t> least(const compiled::Ontology& ontology, ClassNumber offered, ClassNumber requested,
                                   std::size_t left) {
  std::optional<std::uint32_t> best;
  for (const taxonomy::Conversion& one : ontology.conversions()) {
    if (!ontology.is_subsumed(offered, ClassNumber{one.from})) continue;
    const bool is_end = ontology.is_subsumed(ClassNumber{one.to}, requested);
    const auto rest = is_end     ? std::optional<std::uint32_t>(0)
                      : left > 1 ? least(ontology, ClassNumber{one.to}, requested, left - 1)
                                 : std::nullopt;
    if (rest && (!best || one.cost + *rest < *best)) best = one.cost + *rest;
  }
  return best;
}

TEST(Conversions, CostAsMuchAsTheCheapestOfAllChains) {
  for (std::uint64_t seed = 1; seed <= test::rounds(40U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    base::Random random(seed);
    const auto name = [&] { return std::string(1, static_cast<char>('A' + random.below(9))); };
    owl::Ontology source = owl::written("SubClassOf(A Top)\nSubClassOf(B Top)\nSubClassOf(C Top)");
    std::string axioms;
    for (char each = 'A'; each <= 'I'; ++each) axioms += "SubClassOf(" + std::string(1, each) + " Top)\n";
    for (int count = 0; count < 6; ++count) axioms += "SubClassOf(" + name() + " " + name() + ")\n";
    owl::write_into(source, axioms, "more.ofn");
    for (int count = 0; count < 7; ++count) {
      source.add_conversion("https://t.example/#" + name(), "https://t.example/#" + name(),
                            std::to_string(1 + random.below(9)), owl::FileId{0}, 1);
    }
    const auto ontology = std::make_shared<const compiled::Ontology>(owl::loaded(source));
    const Conversions conversions(ontology);
    for (std::uint32_t from = 0; from < ontology->class_count(); ++from) {
      for (std::uint32_t to = 0; to < ontology->class_count(); ++to) {
        const ClassNumber offered{from};
        const ClassNumber requested{to};
        if (!ontology->is_satisfiable(offered) || !ontology->is_satisfiable(requested)) continue;
        const auto found = conversions.cheapest(offered, requested);
        const auto wanted = least(*ontology, offered, requested, max_chain_conversions);
        ASSERT_EQ(found != nullptr, wanted.has_value()) << from << " to " << to;
        if (found == nullptr) continue;
        EXPECT_EQ(found->cost, *wanted) << from << " to " << to;
        EXPECT_LE(found->classes.size(), max_chain_conversions + 1);
        EXPECT_EQ(conversions.cheapest(offered, requested), found) << "it is remembered";
      }
    }
  }
}

}  // namespace
}  // namespace geminga::vocabulary
