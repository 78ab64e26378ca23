// Ontologies that others have published: as many subsumptions as the reference reasoner finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "reasoning/dl/consequence/written.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::consequence {
namespace {

struct Published {
  const char* path;
  std::size_t lines;  ///< as Konclude 0.7 has them: `Konclude classification -w 2`, closed under transitivity
  std::size_t unsatisfiable;
};
// The lines of an unsatisfiable class are one; what is above owl:Thing is not counted.
constexpr Published ontologies[] = {
    {"ontologies/galen/galen.owl", 27997, 0},
    {"ontologies/soma/all-modules-merged.rdf", 4506, 8},
};

/// $GEMINGA_TEST_DATA, or shared/data beside the project; empty where there is neither.
std::filesystem::path data_folder() {
  if (const char* named = std::getenv("GEMINGA_TEST_DATA"); named != nullptr) return named;
  const std::filesystem::path beside = std::filesystem::path(GEMINGA_SOURCE_DIR) / "../shared/data";
  return std::filesystem::exists(beside) ? beside : std::filesystem::path();
}

TEST(PublishedOntologies, HaveTheClosureOfTheReferenceReasoner) {
  const std::filesystem::path folder = data_folder();
  if (folder.empty()) GTEST_SKIP() << "no published ontologies in $GEMINGA_TEST_DATA or ../shared/data";
  for (const Published& published : ontologies) {
    SCOPED_TRACE(published.path);
    auto loaded = rdf::load(std::vector{(folder / published.path).string()});
    ASSERT_TRUE(loaded.has_value());
    const clauses::ClauseSet clauses = clauses_of(loaded->source);
    std::vector<std::string> before;
    for (const unsigned threads : {1U, 2U}) {
      const Closure closure = saturate(loaded->source, clauses, named_classes(clauses), {.threads = threads});
      std::vector<std::string> lines = lines_of(loaded->source, clauses, closure);
      std::erase_if(lines, [](const std::string& line) { return line.starts_with("Thing "); });
      EXPECT_EQ(lines.size(), published.lines);
      EXPECT_EQ(static_cast<std::size_t>(
                    std::ranges::count_if(lines, [](const std::string& line) { return line.ends_with(" Nothing"); })),
                published.unsatisfiable);
      EXPECT_TRUE(threads == 1 || lines == before);
      before = std::move(lines);
    }
  }
}

}  // namespace
}  // namespace geminga::consequence
