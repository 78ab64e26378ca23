// One small file a construct, and the axioms that it must become.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/random.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/syntax/rdf/functional.hpp"
#include "reasoning/syntax/rdf/load.hpp"
#include "reasoning/syntax/rdf/scratch.hpp"

namespace geminga::rdf {
namespace {

namespace fs = std::filesystem;

const fs::path cases = fs::path(GEMINGA_SOURCE_DIR) / "tests/reasoning/syntax/rdf/cases";

std::vector<fs::path> case_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(cases)) {
    if (entry.path().extension() != ".axioms") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

std::vector<std::string> lines_of(const fs::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// Axioms, then what was left out, in the form of the .axioms files.
std::vector<std::string> found_in(const Loaded& loaded) {
  std::vector<std::string> found = functional(loaded.source);
  for (const owl::Ontology::Omission& omission : loaded.source.omissions())
    found.push_back("left out: " + std::string(loaded.source.name(omission.construct)) + ", " +
                    std::to_string(omission.count) + ", line " + std::to_string(omission.line));
  return found;
}

class Case : public testing::TestWithParam<fs::path> {};

TEST_P(Case, BecomesItsAxioms) {
  const auto loaded = load(std::vector{GetParam().string()});
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  std::vector<std::string> expected = lines_of(fs::path(GetParam()).replace_extension(".axioms"));
  ASSERT_FALSE(expected.empty());
  std::vector<std::string> found = found_in(*loaded);
  std::ranges::sort(expected);
  std::ranges::sort(found);
  EXPECT_EQ(found, expected);
}

INSTANTIATE_TEST_SUITE_P(Construct, Case, testing::ValuesIn(case_files()),
                         [](const auto& param) { return param.param.stem().string(); });

TEST(Mapping, DoesNotDependOnTheOrderOfTriples) {
  const std::vector<std::string> triples = lines_of(cases / "SubClassOfTriples.nt");
  base::Random random(20261121);
  std::vector<std::string> expected;
  for (int round = 0; round < 20; ++round) {
    std::vector<std::string> shuffled = triples;
    for (std::size_t place = shuffled.size(); place > 1; --place)
      std::swap(shuffled[place - 1], shuffled[random.below(place)]);
    std::string text;
    for (const std::string& line : shuffled) text += line + '\n';
    const Scratch scratch;
    const auto loaded = load(std::vector{scratch.write("shuffled.nt", text)});
    ASSERT_TRUE(loaded) << to_string(loaded.error());
    std::vector<std::string> found = functional(loaded->source);
    std::ranges::sort(found);
    if (round == 0) expected = found;
    EXPECT_EQ(found, expected) << "round " << round << " of seed 20261121";
  }
  EXPECT_EQ(expected.size(), 2U);
}

TEST(Mapping, KeepsFileAndLineOfEveryAxiom) {
  const Scratch scratch;
  const std::string a =
      scratch.write("a.nt", "<http://e/A> <http://www.w3.org/2000/01/rdf-schema#subClassOf> <http://e/B> .\n");
  const std::string b =
      scratch.write("b.nt", "\n\n<http://e/B> <http://www.w3.org/2000/01/rdf-schema#subClassOf> <http://e/C> .\n");
  const auto loaded = load(std::vector{a, b});
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  ASSERT_EQ(loaded->source.axiom_count(), 2U);
  const auto place = [&](std::size_t index) {
    const owl::Axiom axiom = loaded->source.axiom(index);
    return loaded->source.files()[static_cast<std::size_t>(axiom.file)].path + ':' + std::to_string(axiom.line);
  };
  EXPECT_EQ(place(0), a + ":1");
  EXPECT_EQ(place(1), b + ":3");
}

TEST(Mapping, NeverTakesABlankNodeOfOneFileForThatOfAnother) {
  const Scratch scratch;
  const std::string prefix = "@prefix : <http://e/> . @prefix owl: <http://www.w3.org/2002/07/owl#> .\n";
  const std::string a = scratch.write("a.ttl", prefix + ":p a owl:ObjectProperty . _:x :p :i .\n");
  const std::string b = scratch.write("b.ttl", prefix + "_:x :p :j . [] :p :k . _:g1 :p :l . _:genid1 :p :m .\n");
  const auto loaded = load(std::vector{a, b});
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_EQ(functional(loaded->source),
            (std::vector<std::string>{"ObjectPropertyAssertion(:p _:1 :i)", "ObjectPropertyAssertion(:p _:2 :j)",
                                      "ObjectPropertyAssertion(:p _:3 :k)", "ObjectPropertyAssertion(:p _:4 :l)",
                                      "ObjectPropertyAssertion(:p _:5 :m)"}));
}

}  // namespace
}  // namespace geminga::rdf
