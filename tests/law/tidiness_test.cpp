// The parts of the house style that a program can see, and a test of the test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <string>

#include "law/source_tree.hpp"

namespace geminga::law {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr std::size_t max_lines = 400;
constexpr std::size_t max_sources = 45;

/// False where none of the expressions below can match: they are slow.
bool may_be_untidy(const std::string& line) {
  return std::ranges::any_of(std::array{"sleep", "TODO", "FIXME", "XXX", "HACK", "DISABLED_", "GTEST_SKIP"},
                             [&](const char* word) { return line.contains(word); });
}

std::vector<std::string> untidiness(const SourceFile& file) {
  // asyncio.sleep and a promise of a timer wait for the loop's own, possibly virtual, time.
  static const std::regex sleep(R"(\b(sleep_for|sleep_until|usleep|nanosleep)\b|\b(time|Thread)\.sleep\b)");
  static const std::regex todo(R"(\b(TODO|FIXME|XXX|HACK)\b)");
  // A test that cannot run here says why; ctest then counts it as skipped.
  static const std::regex skip(R"(\bDISABLED_|\bGTEST_SKIP\b(?!\(\) << ))");
  std::vector<std::string> found;
  if (file.lines.size() > max_lines) found.push_back(file.path + ": has over 400 lines: which two things live in it?");
  const bool is_header = file.path.ends_with(".hpp") || file.path.ends_with(".h");
  if (is_header && (file.lines.empty() || !file.lines[0].starts_with("// "))) {
    found.push_back(file.path + ":1: does not open with a sentence that says what it is for");
  }
  const bool is_this = file.path.ends_with("tidiness_test.cpp");
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const std::string place = file.path + ':' + std::to_string(i + 1) + ": ";
    if (file.lines[i].find('\t') != std::string::npos) found.push_back(place + "has a tab");
    if (is_this || !may_be_untidy(file.lines[i])) continue;
    if (std::regex_search(file.lines[i], sleep)) found.push_back(place + "sleeps: time comes from Env");
    if (std::regex_search(file.lines[i], todo)) found.push_back(place + "has a mark without an owner");
    if (std::regex_search(file.lines[i], skip)) found.push_back(place + "skips a test without a reason");
  }
  return found;
}

/// The folders that hold more sources than a reader keeps in mind.
std::vector<std::string> crowded_folders(const std::vector<SourceFile>& files) {
  std::map<std::string, std::size_t> sources;
  for (const SourceFile& file : files) ++sources[file.path.substr(0, file.path.rfind('/'))];
  std::vector<std::string> found;
  for (const auto& [folder, count] : sources) {
    if (count > max_sources) found.push_back(folder + ": has over 45 sources: which rooms does it have?");
  }
  return found;
}

TEST(Tidiness, HoldsForEveryFileOfTheProject) {
  for (const SourceFile& file : all_sources()) {
    // The examples of other languages say something ten times a second.
    if (file.path.starts_with("examples/")) continue;
    EXPECT_THAT(untidiness(file), IsEmpty());
  }
  for (const auto& file : source_files("examples")) EXPECT_THAT(untidiness(file), IsEmpty());
}

TEST(Tidiness, HoldsForEveryFolderOfTheProject) { EXPECT_THAT(crowded_folders(all_sources()), IsEmpty()); }

TEST(Tidiness, FindsWhatItLooksFor) {
  EXPECT_THAT(untidiness({"src/a.hpp", {"#ifndef A"}}), SizeIs(1));
  EXPECT_THAT(untidiness({"src/a.cpp", {"\tint x;"}}), SizeIs(1));
  EXPECT_THAT(untidiness({"src/a.cpp", {"std::this_thread::sleep_for(1s);"}}), SizeIs(1));
  EXPECT_THAT(untidiness({"src/a.py", {"    time.sleep(1)"}}), SizeIs(1));
  EXPECT_THAT(untidiness({"src/A.java", {"    Thread.sleep(100);"}}), SizeIs(1));
  EXPECT_THAT(untidiness({"src/a.py", {"    await asyncio.sleep(0)"}}), IsEmpty());
  EXPECT_THAT(untidiness({"src/a.cpp", {"// TODO later"}}), SizeIs(1));
  EXPECT_THAT(untidiness({"tests/a.cpp", {"GTEST_SKIP();"}}), SizeIs(1));
  EXPECT_THAT(untidiness({"tests/a.cpp", {"TEST(A, DISABLED_B) {"}}), SizeIs(1));
  EXPECT_THAT(untidiness({"tests/a.cpp", {"GTEST_SKIP() << \"no network namespace may be made here\";"}}), IsEmpty());
  EXPECT_THAT(untidiness({"src/a.cpp", std::vector<std::string>(401)}), SizeIs(1));
  EXPECT_THAT(untidiness({"src/a.cpp", std::vector<std::string>(400)}), IsEmpty());
  EXPECT_THAT(crowded_folders(std::vector<SourceFile>(45, {"src/a/b.cpp", {}})), IsEmpty());
  EXPECT_THAT(crowded_folders(std::vector<SourceFile>(46, {"src/a/b.cpp", {}})), SizeIs(1));
}

}  // namespace
}  // namespace geminga::law
