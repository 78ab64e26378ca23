// Random ontologies: every explanation against all subsets of the axioms, as the naive reasoner judges them.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "base/random.hpp"
#include "reasoning/compiled/compiled_view.hpp"
#include "reasoning/explanation/laconic.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "support/reference.hpp"
#include "support/rounds.hpp"
#include "support/written.hpp"

namespace geminga::explanation {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The axioms of a few lines, and the closure of each subset by the naive reasoner.
class Subsets {
 public:
  explicit Subsets(std::vector<std::string> lines)
      : lines_(std::move(lines)), closures_(std::size_t{1} << lines_.size()) {}

  /// True if the lines of the mask entail that `t:sub` is below `t:super`.
  bool entails(std::size_t mask, const std::string& sub, const std::string& super) {
    const std::set<std::string>& closure = closure_of(mask);
    return closure.contains("inconsistent") || closure.contains(sub + " < Nothing") ||
           closure.contains("Thing < " + super) || closure.contains(sub + " < " + super);
  }
  /// The masks of all minimal subsets, ascending.
  std::vector<std::size_t> minimal(const std::string& sub, const std::string& super) {
    std::vector<std::size_t> found;
    for (std::size_t mask = 0; mask < closures_.size(); ++mask) {
      if (!entails(mask, sub, super)) continue;
      bool is_minimal = true;
      for (std::size_t bit = 1; bit < closures_.size(); bit *= 2) {
        if ((mask & bit) != 0 && entails(mask ^ bit, sub, super)) is_minimal = false;
      }
      if (is_minimal) found.push_back(mask);
    }
    return found;
  }

 private:
  const std::set<std::string>& closure_of(std::size_t mask) {
    auto& closure = closures_[mask];
    if (!closure) {
      std::string text;
      for (std::size_t line = 0; line < lines_.size(); ++line) {
        text += ((mask >> line) & 1) != 0 ? lines_[line] + "\n" : "\n";
      }
      const auto lines = owl::reference_closure(owl::written(text));
      closure.emplace(lines.begin(), lines.end());
    }
    return *closure;
  }

  std::vector<std::string> lines_;
  std::vector<std::optional<std::set<std::string>>> closures_;
};

/// The lines of the axioms as a mask.
std::size_t mask_of(Explainer& explainer, const AxiomSet& axioms) {
  std::size_t mask = 0;
  for (const std::uint32_t axiom : axioms) {
    mask |= std::size_t{1} << (explainer.module().source().axiom(axiom).line - 1);
  }
  return mask;
}

/// Calls `check(explainer, subsets, sub, super)` for pairs of classes of random ontologies of EL.
template <typename Check>
int for_random_pairs(std::uint64_t seeds, std::size_t axioms, Check&& check) {
  int checked = 0;
  for (std::uint64_t seed = 1; seed <= test::rounds(seeds); ++seed) {
    base::Random random(seed);
    const std::string text = owl::random_ontology(random, axioms);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
    const owl::Ontology source = owl::written(text);
    // The naive reasoner does not know ranges over chains.
    if (!owl::classified(source).unused.empty() || owl::has_range_over_chain(source)) continue;
    std::vector<std::string> lines = lines_of(text);
    const compiled::Ontology ontology = owl::loaded(source);
    if (ontology.axioms().axiom_count() != lines.size()) continue;  // two equal lines are one axiom
    Subsets subsets(std::move(lines));
    for (std::uint32_t sub = 0; sub < ontology.class_count(); ++sub) {
      for (std::uint32_t super = 0; super < ontology.class_count(); ++super) {
        const auto local = [&](std::uint32_t number) {
          const std::string_view iri = ontology.iri(taxonomy::ClassNumber{number});
          return std::string(iri.substr(iri.find('#') + 1));
        };
        if (sub == super || local(sub) == "Nothing" || local(super) == "Thing" || local(sub) == "Thing") continue;
        Explainer explainer(ontology, taxonomy::ClassNumber{sub}, taxonomy::ClassNumber{super});
        SCOPED_TRACE(local(sub) + " < " + local(super));
        check(explainer, subsets, local(sub), local(super));
        if (testing::Test::HasFatalFailure()) return checked;
        ++checked;
      }
    }
  }
  return checked;
}

TEST(RandomExplanations, AreMinimalByTheNaiveReasoner) {
  int explained = 0;
  for_random_pairs(40, 10, [&](Explainer& explainer, Subsets& subsets, const auto& sub, const auto& super) {
    const auto found = explainer.find_one();
    ASSERT_EQ(found.has_value(), subsets.entails((std::size_t{1} << 10) - 1, sub, super));
    if (!found) return;
    ++explained;
    const std::size_t mask = mask_of(explainer, *found);
    ASSERT_TRUE(subsets.entails(mask, sub, super));
    for (const std::uint32_t axiom : *found) {
      ASSERT_FALSE(subsets.entails(mask & ~mask_of(explainer, {axiom}), sub, super)) << "axiom " << axiom;
    }
  });
  EXPECT_GT(explained, test::rounds(300));
}

TEST(RandomExplanations, PartsOfThemFollowAreEnoughAndAreAllNeeded) {
  int weakened = 0;
  for_random_pairs(25, 10, [&](Explainer& explainer, Subsets&, const auto&, const auto&) {
    const auto found = explainer.find_one();
    if (!found) return;
    const Laconic laconic = find_laconic(explainer, *found);
    ASSERT_TRUE(laconic.is_laconic);
    const owl::Ontology& source = explainer.module().source();
    AxiomSet parts;
    for (const Laconic::PartOf& part : laconic.parts) {
      parts.push_back(part.axiom);
      if (part.is_whole) continue;
      ++weakened;
      const AxiomSet whole = {part.whole};
      const AxiomSet conclusion = {part.axiom};
      ASSERT_EQ(reasoner::entails_each(source, whole, conclusion).front().verdict, reasoner::Verdict::yes)
          << explainer.module().explained(part.axiom).text;
    }
    ASSERT_TRUE(explainer.oracle().holds(parts, explainer.sub(), explainer.super()));
    for (const std::uint32_t part : parts) {
      AxiomSet others = parts;
      std::erase(others, part);
      ASSERT_FALSE(explainer.oracle().holds(others, explainer.sub(), explainer.super()));
    }
  });
  EXPECT_GT(weakened, test::rounds(20));
}

TEST(RandomExplanations, AreAllThatThereAre) {
  int several = 0;
  for_random_pairs(100, 8, [&](Explainer& explainer, Subsets& subsets, const auto& sub, const auto& super) {
    const AllSets all = explainer.find_all({.sets = 1000, .nodes = 100'000});
    ASSERT_FALSE(all.may_have_more);
    std::vector<std::size_t> masks;
    for (const AxiomSet& set : all.sets) masks.push_back(mask_of(explainer, set));
    std::ranges::sort(masks);
    ASSERT_EQ(masks, subsets.minimal(sub, super));
    if (masks.size() > 1) ++several;
  });
  EXPECT_GT(several, test::rounds(20));
}

}  // namespace
}  // namespace geminga::explanation
