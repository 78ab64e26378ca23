// Each pair Name.ttl and Name.types of the folders below this one: the realisation is exactly these lines, and
// complete.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/text.hpp"
#include "reasoning/realization/realization.hpp"
#include "reasoning/reasoner/reasoner.hpp"
#include "reasoning/syntax/rdf/load.hpp"

namespace geminga::cases {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

const fs::path cases_folder = fs::path(GEMINGA_SOURCE_DIR) / "tests" / "cases";

std::vector<fs::path> cases_with_types() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(cases_folder)) {
    if (entry.path().extension() == ".types")
      files.push_back(fs::relative(entry.path(), cases_folder).replace_extension());
  }
  std::ranges::sort(files);
  return files;
}

std::string local(std::string_view iri) { return std::string(iri.substr(iri.find_last_of("/#") + 1)); }

std::string lines_of(const owl::Ontology& source, const taxonomy::Classification& classification,
                     const realization::Realization& realization) {
  std::string lines;
  for (std::uint32_t at = 0; at < realization.individuals.size(); ++at) {
    if (realization.representative[at] != at) continue;
    std::vector<std::string> names;
    for (std::uint32_t other = 0; other < realization.individuals.size(); ++other) {
      if (realization.representative[other] == at)
        names.push_back(local(source.name_of(realization.individuals[other])));
    }
    std::vector<std::string> types;
    for (const auto of : realization::most_specific(classification, realization.type_sets[realization.types[at]])) {
      std::vector<std::string> equal;
      for (std::size_t member = 0; member < classification.class_count(); ++member) {
        if (classification.representative[member] == of)
          equal.push_back(local(source.name(classification.classes[member])));
      }
      types.push_back(base::joined(equal, " = "));
    }
    if (types.empty()) types.emplace_back("Thing");
    lines += base::joined(names, " = ") + ": " + base::joined(types, ", ") + '\n';
  }
  return lines;
}

class Types : public testing::TestWithParam<fs::path> {};

TEST_P(Types, AreThoseOfTheCase) {
  const fs::path name = cases_folder / GetParam();
  std::ifstream file(name.string() + ".types", std::ios::binary);
  const std::string expected{std::istreambuf_iterator<char>(file), {}};
  auto loaded = rdf::load(std::vector{name.string() + ".ttl"});
  ASSERT_TRUE(loaded) << syntax::to_string(loaded.error());
  const auto classification = reasoner::classify(loaded->source);
  ASSERT_TRUE(classification) << classification.error().text;
  const auto realization = realization::realize(loaded->source, *classification);
  EXPECT_EQ(lines_of(loaded->source, *classification, realization), expected);
  EXPECT_THAT(realization.gaps, IsEmpty());
  EXPECT_THAT(realization.undecided, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Individuals, Types, testing::ValuesIn(cases_with_types()),
                         [](const auto& param) { return param.param.filename().string(); });

}  // namespace
}  // namespace geminga::cases
