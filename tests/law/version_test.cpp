// The version of the project stands in CMakeLists.txt. Files that other tools read, and the numbers of protocols in
// documents, say the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

namespace geminga::law {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
  std::ifstream in(fs::path(GEMINGA_SOURCE_DIR) / file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The first group of an expression that a file contains; empty where it does not.
std::string found(const fs::path& file, const std::string& expression) {
  const std::string text = contents(file);
  std::smatch match;
  return std::regex_search(text, match, std::regex(expression)) ? match[1].str() : "";
}

std::string version() { return found("CMakeLists.txt", R"(project\(Geminga VERSION (\S+))"); }

TEST(Version, IsTheSameInTheFilesOfEachLanguage) {
  ASSERT_THAT(version(), testing::MatchesRegex("[0-9]+[.][0-9]+[.][0-9]+"));
  EXPECT_EQ(found("src/client/python/geminga/__init__.py", "__version__ = \"([^\"]+)\""), version());
  EXPECT_EQ(found("src/client/python/pyproject.toml", "version = \"([^\"]+)\""), version());
  EXPECT_EQ(found("src/client/javascript/package.json", "\"version\": \"([^\"]+)\""), version());
  EXPECT_EQ(found("src/client/javascript/README.md", R"(geminga-(\d+\.\d+\.\d+)\.tgz)"), version());
}

TEST(Version, HasItsSectionAndItsDayInTheChangelog) {
  const std::string expression =
      R"(\n## \[)" + std::regex_replace(version(), std::regex(R"(\.)"), "\\.") + R"(\] - (\S+)\n)";
  const std::time_t day = std::stoll("0" + found("CMakeLists.txt", R"(SOURCE_DATE_EPOCH\} (\d+))"));
  std::tm parts{};
  ::gmtime_r(&day, &parts);
  char date[11] = {};
  std::strftime(date, sizeof date, "%Y-%m-%d", &parts);
  EXPECT_EQ(found("CHANGELOG.md", expression), date) << "packages bear this day";
  EXPECT_THAT(contents("CHANGELOG.md"), testing::HasSubstr("\n## [Unreleased]\n")) << "for what comes next";
}

TEST(Version, OfEachProtocolIsWhatItsDocumentAndContributingSay) {
  struct Protocol {
    const char* constant;
    const char* home;
    const char* document;
    const char* sentence;  ///< with the number as its group
    const char* row;       ///< of the table in CONTRIBUTING.md
  };
  const Protocol protocols[]{
      {"format_major", "src/discovery/announcement/version.hpp", "src/discovery/announcement/ANNOUNCEMENT.md",
       R"(the major version (\d+))", R"(\| announcements \| (\d+) \|)"},
      {"envelope_version", "src/discovery/sealing/version.hpp", "src/discovery/sealing/SEALING.md",
       R"(the version (\d+) in the upper four bits)", R"(\| seals \| (\d+) \|)"},
      {"gcnp_version", "src/discovery/gcnp/version.hpp", "src/discovery/gcnp/GCNP.md", R"(0 msg hello version=(\d+))",
       R"(\| GCNP \| (\d+) \|)"},
      {"compiled_version", "src/reasoning/compiled/container.hpp", "src/reasoning/compiled/COMPILED.md",
       R"(Version (\d+)\.)", R"(\| compiled ontologies \| (\d+) \|)"},
  };
  for (const Protocol& protocol : protocols) {
    const std::string number = found(protocol.home, std::string(protocol.constant) + R"( = (\d+);)");
    EXPECT_NE(number, "") << protocol.home;
    EXPECT_EQ(found(protocol.document, protocol.sentence), number) << protocol.document;
    EXPECT_EQ(found("CONTRIBUTING.md", protocol.row), number) << protocol.constant;
  }
}

}  // namespace
}  // namespace geminga::law
