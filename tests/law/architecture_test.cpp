// Compares the tables of folders, in ARCHITECTURE.md and in the READMEs of folders with rooms, with the DEPENDS of the
// modules.
#include <gtest/gtest.h>

#include <regex>

#include "law/source_tree.hpp"

namespace geminga::law {
namespace {

/// Adds the rows of a document's table of folders: those that begin with a folder of src/ or tools/. The last column is
/// what the folder may include, named as in the law.
void read_table(const SourceFile& document, Law& law) {
  static const std::regex row(R"(\| (?:src/)?((?!include)[a-z/]+)/ \|.*\| ([^|]+) \|)");
  static const std::regex word(R"([a-z/]+)");
  for (const std::string& line : document.lines) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    const std::string last = match[2];
    auto& depends = law[match[1]];
    for (auto w = std::sregex_iterator(last.begin(), last.end(), word); w != std::sregex_iterator(); ++w)
      depends.insert(w->str());
  }
}

/// The table of ARCHITECTURE.md, and those of the READMEs that tell of the rooms within a folder.
Law read_tables() {
  Law law;
  for (const SourceFile& document : files_below("", {"ARCHITECTURE.md", "README.md"})) {
    const std::string& path = document.path;
    if (path == "ARCHITECTURE.md" || path.starts_with("src/") || path.starts_with("tools/")) read_table(document, law);
  }
  return law;
}

TEST(Architecture, TellsOfEveryModuleAndWhatItMayInclude) {
  const Law law = read_law();
  const Law table = read_tables();
  for (const auto& [module, depends] : law) {
    const auto row = table.find(module);
    ASSERT_NE(row, table.end()) << module << "/ has no row";
    EXPECT_EQ(row->second, depends) << module;
  }
  for (const auto& [folder, depends] : table) EXPECT_TRUE(law.contains(folder)) << folder << "/ is no module";
}

}  // namespace
}  // namespace geminga::law
