#include "base/numbered_folders.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace geminga::base {
namespace {

namespace fs = std::filesystem;

TEST(NumberedFolders, AreThoseThatANumberNamesAlone) {
  const fs::path folder = fs::path(testing::TempDir()) / ("geminga-numbered-folders-" + std::to_string(::getpid()));
  fs::remove_all(folder);
  for (const char* name : {"10", "9", "007", "+1", "1a", "-3", ".5", "18446744073709551615", "18446744073709551616"})
    fs::create_directories(folder / name);
  std::ofstream(folder / "8") << "a file";
  fs::create_directory_symlink(folder / "9", folder / "7");
  EXPECT_THAT(numbered_folders(folder.string()), testing::ElementsAre(9, 10, 18446744073709551615U));
  EXPECT_THAT(numbered_folders((folder / "nowhere").string()), testing::IsEmpty());
  fs::remove_all(folder);
}

}  // namespace
}  // namespace geminga::base
