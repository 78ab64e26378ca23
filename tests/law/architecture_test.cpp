// Compares the table of folders in ARCHITECTURE.md with the DEPENDS of the modules.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>

#include "law/source_tree.hpp"

namespace geminga::law {
namespace {

/// What the table says: the last column of each row that begins with a folder of src/ or tools/, named as in the law.
Law read_table() {
  static const std::regex row(R"(\| (?:src/)?((?!include)[a-z/]+)/ \|.*\| ([^|]+) \|)");
  static const std::regex word(R"([a-z/]+)");
  std::ifstream file(std::string(GEMINGA_SOURCE_DIR) + "/ARCHITECTURE.md");
  Law law;
  for (std::string line; std::getline(file, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    auto& depends = law[match[1]];
    const std::string last = match[2];
    for (auto w = std::sregex_iterator(last.begin(), last.end(), word); w != std::sregex_iterator(); ++w)
      depends.insert(w->str());
  }
  return law;
}

TEST(Architecture, TellsOfEveryModuleAndWhatItMayInclude) {
  const Law law = read_law();
  const Law table = read_table();
  for (const auto& [module, depends] : law) {
    const auto row = table.find(module);
    ASSERT_NE(row, table.end()) << module << "/ has no row";
    EXPECT_EQ(row->second, depends) << module;
  }
  for (const auto& [folder, depends] : table) EXPECT_TRUE(law.contains(folder)) << folder << "/ is no module";
}

}  // namespace
}  // namespace geminga::law
