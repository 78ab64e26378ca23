// Memory that runs out in one of several threads ends the question and not the process.
#include <gtest/gtest.h>

#include <cstdint>
#include <new>
#include <optional>
#include <string>
#include <string_view>

#include "base/random.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "scarce_memory.hpp"
#include "support/written.hpp"

namespace geminga::reasoner {
namespace {

/// Classes below and beside each other, so that several threads have something to do.
std::string many_classes(int count) {
  base::Random random(7);
  std::string text = "TransitiveObjectProperty(r0)\nSubObjectPropertyOf(r1 r0)\n";
  const auto name = [](std::uint64_t number) { return "C" + std::to_string(number); };
  for (std::uint64_t at = 1; at < static_cast<std::uint64_t>(count); ++at) {
    text += "SubClassOf(" + name(at) + " " + name(at / 3) + ")\n";
    text += "SubClassOf(" + name(at) + " ObjectSomeValuesFrom(r" + std::to_string(random.below(3)) + " " +
            name(random.below(at)) + "))\n";
    text += "SubClassOf(ObjectSomeValuesFrom(r0 " + name(random.below(at)) + ") D" + std::to_string(at % 7) + ")\n";
  }
  return text;
}

/// Asks with memory that runs out in ever later allocations until none has failed; gives how often one did. `asked` is
/// given the number of the first that fails, and says whether one did.
template <typename Asked>
int exhaust(Asked&& asked) {
  int failures = 0;
  for (std::uint64_t first = 1; asked(first); first += 1 + first / 4) ++failures;
  return failures;
}

TEST(Threads, AFailedAllocationInTheEngineOfElReachesTheCaller) {
  for (const std::string more : {"", "FunctionalObjectProperty(f)\nSubClassOf(C1 ObjectSomeValuesFrom(f C2))\n"}) {
    const owl::Ontology source = owl::written(many_classes(3000) + more);
    int thrown = 0;
    const int failures = exhaust([&](std::uint64_t first) {
      const ScarceMemory scarce(first);
      try {
        EXPECT_TRUE(classify(source, {.threads = 3, .progress = {}})->is_consistent);
      } catch (const std::bad_alloc&) {
        ++thrown;
      }
      return scarce.has_failed();
    });
    EXPECT_GT(failures, 3) << more;
    EXPECT_EQ(thrown, failures) << more;
  }
}

TEST(Threads, AFailedAllocationInTheClausesLeavesWhatElHasFound) {
  // Inverses, which only the clauses know.
  std::string text = many_classes(300) + "InverseObjectProperties(r0 q)\nSubClassOf(C1 ObjectAllValuesFrom(q C2))\n";
  for (int at = 0; at < 60; ++at) {
    const std::string number = std::to_string(at);
    text += "SubClassOf(E" + number + " ObjectSomeValuesFrom(r1 C" + std::to_string(at % 40) + "))\nSubClassOf(C" +
            std::to_string(at % 40) + " ObjectAllValuesFrom(q F" + number + "))\n";
  }
  const owl::Ontology source = owl::written(text);
  int fallen_back = 0;
  const int failures = exhaust([&](std::uint64_t first) {
    std::optional<ScarceMemory> scarce;
    const auto begin_with_the_clauses = [&](std::string_view phase, double) {
      if (phase == "deriving consequences") scarce.emplace(first);
    };
    const auto found = classify(source, {.threads = 3, .progress = begin_with_the_clauses});
    for (const std::string& gap : found->gaps) fallen_back += gap.starts_with("there is not enough memory") ? 1 : 0;
    return scarce && scarce->has_failed();
  });
  EXPECT_GT(failures, 0);
  EXPECT_EQ(fallen_back, failures);
}

}  // namespace
}  // namespace geminga::reasoner
