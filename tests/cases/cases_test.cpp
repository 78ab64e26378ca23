// Each pair Name.ttl and Name.taxonomy of the folders below this one: the classified file is exactly the tree, and is
// known to be complete.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "cases/taxonomy.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::cases {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

const fs::path folder = fs::path(GEMINGA_SOURCE_DIR) / "tests" / "cases";

/// The names of the cases, without extension, as in `chains/LongChain`.
std::vector<fs::path> files_with(std::string_view extension) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == extension) files.push_back(fs::relative(entry.path(), folder).replace_extension());
  }
  std::ranges::sort(files);
  return files;
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class Case : public testing::TestWithParam<fs::path> {};

TEST_P(Case, IsClassifiedAsItsTaxonomy) {
  const fs::path name = folder / GetParam();
  const auto expected = read_tree(text_of(name.string() + ".taxonomy"));
  ASSERT_TRUE(expected) << expected.error();
  const auto loaded = rdf::load(std::vector{name.string() + ".ttl"});
  ASSERT_TRUE(loaded) << syntax::to_string(loaded.error());
  ASSERT_THAT(loaded->source.omissions(), IsEmpty());
  const auto classification = reasoner::classify(loaded->source);
  ASSERT_TRUE(classification) << classification.error().text;
  const Closure found = closure_of(loaded->source, *classification);
  EXPECT_THAT(unsound(found, *expected), IsEmpty()) << "derived, though it does not follow";
  EXPECT_THAT(without(*expected, found), IsEmpty()) << "follows, and is not derived";
  EXPECT_THAT(superfluous_edges(loaded->source, *classification), IsEmpty()) << "the taxonomy is not reduced";
  for (const taxonomy::UnusedAxiom& unused : classification->unused)
    ADD_FAILURE() << "left out: " << unused.construct << " in line " << loaded->source.axiom(unused.axiom).line;
  EXPECT_THAT(classification->gaps, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Construct, Case, testing::ValuesIn(files_with(".ttl")),
                         [](const auto& param) { return param.param.filename().string(); });

TEST(Cases, AreAllPairs) {
  EXPECT_EQ(files_with(".ttl"), files_with(".taxonomy"));
  EXPECT_GE(files_with(".ttl").size(), 80U);
}

TEST(Tree, IsReadAsTheClosureThatItMeans) {
  EXPECT_EQ(read_tree("Thing = E\n  A = B\n    C\nNothing = D\n").value(),
            (Closure{"A < B", "A < E", "B < A", "B < E", "C < A", "C < B", "C < E", "D < Nothing", "Thing < E"}));
  EXPECT_EQ(read_tree("Thing\n  A\n    C\n  B\n    C\n").value(), (Closure{"C < A", "C < B"}));
  EXPECT_EQ(read_tree("# why\ninconsistent\n").value(), Closure{"inconsistent"});
}

TEST(Tree, IsRefusedWithItsLineWhereItIsNone) {
  EXPECT_EQ(read_tree("Thing\n    A\n").error(), "line 2: not two spaces deeper than the line above it");
  EXPECT_EQ(read_tree("Thing\n A\n").error(), "line 2: not two spaces deeper than the line above it");
  EXPECT_EQ(read_tree("Thing\n  A B\n").error(), "line 2: no names separated by ` = `");
}

}  // namespace
}  // namespace geminga::cases
