// Published ontologies, if the test data has them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::rdf {
namespace {

namespace fs = std::filesystem;

/// The folder of test data, or an empty path.
fs::path data_folder() {
  const char* named = std::getenv("GEMINGA_TEST_DATA");
  for (const fs::path& folder :
       {fs::path(named == nullptr ? "" : named), fs::path(GEMINGA_SOURCE_DIR) / ".." / "shared" / "data"}) {
    if (!folder.empty() && fs::is_directory(folder / "ontologies")) return folder;
  }
  return {};
}

struct Published {
  std::string path;
  std::uint64_t triples;
  std::size_t axioms;  ///< with declarations
  std::vector<std::string> left_out;
};

TEST(Published, OntologiesAreReadInFull) {
  const fs::path data = data_folder();
  if (data.empty()) GTEST_SKIP() << "no published ontologies in $GEMINGA_TEST_DATA or ../shared/data";
  // Counts of triples as rapper -c gives them; what is left out was looked at in the files and is wrong there.
  const std::vector<Published> all{
      {"galen/galen.owl", 37'531, 7'705, {}},
      {"soma/all-modules-merged.rdf", 6'404, 3'905, {}},
      {"ieee1872", 2'008, 475, {}},
      {"sosa-ssn", 2'142, 383, {"an owl:Restriction without a constraint", "a union of properties"}},
  };
  for (const Published& published : all) {
    const auto loaded = load(std::vector{(data / "ontologies" / published.path).string()});
    ASSERT_TRUE(loaded) << to_string(loaded.error());
    EXPECT_EQ(loaded->triples, published.triples) << published.path;
    EXPECT_EQ(loaded->source.axiom_count(), published.axioms) << published.path;
    std::vector<std::string> left_out;
    for (const auto& omission : loaded->source.omissions())
      left_out.emplace_back(loaded->source.name(omission.construct));
    EXPECT_THAT(left_out, testing::UnorderedElementsAreArray(published.left_out)) << published.path;
  }
}

}  // namespace
}  // namespace geminga::rdf
