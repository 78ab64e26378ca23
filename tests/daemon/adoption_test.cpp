// The folders of adopted ontologies that count.
#include "daemon/adoption/adoption.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>

#include "daemon/configuration/configuration.hpp"

namespace geminga::daemon {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::expected<Configuration, std::vector<std::string>> adopting(const std::vector<std::string>& publishers,
                                                                const std::string& state_folder) {
  Layer layer;
  for (const std::string& publisher : publishers) layer.values["adopt-from"].push_back({publisher, "--adopt-from"});
  if (!state_folder.empty()) layer.values["state-folder"].push_back({state_folder, "--state-folder"});
  return resolve({&layer}, "host");
}

TEST(ConfigurationOfAdoption, NamesParticipantsAndNeedsAStateFolder) {
  EXPECT_EQ(adopting({}, "/s")->adopted, Adopted());
  const auto from = adopting({"base", "a b", "base"}, "/s");
  ASSERT_TRUE(from);
  EXPECT_EQ(from->adopted, (Adopted{"/s/adopted", {"base", "a b"}}));
  EXPECT_THAT(to_toml(*from), HasSubstr("adopt-from = [\"base\", \"a b\"]\n"));
  EXPECT_THAT(adopting({"base"}, "").error(), ElementsAre(HasSubstr("give --state-folder")));
  for (const char* name : {"", ".", "..", "../a", "a/b", "a\n", ".hidden"})
    EXPECT_FALSE(adopting({name}, "/s")) << name;
}

TEST(ConfigurationOfAdoption, HasAMostOfParticipants) {
  std::vector<std::string> names;
  while (names.size() < 15) names.push_back("robot" + std::to_string(names.size()));
  EXPECT_TRUE(adopting(names, "/s"));
  names.emplace_back("sixteenth");
  EXPECT_TRUE(adopting(names, "/s"));
  names.emplace_back("seventeenth");
  EXPECT_FALSE(adopting(names, "/s"));
}

class AdoptedVersions : public testing::Test {
 protected:
  AdoptedVersions() {
    std::string path = fs::temp_directory_path() / "geminga-adoption-XXXXXX";
    if (::mkdtemp(path.data()) != nullptr) folder_ = path;
  }
  ~AdoptedVersions() override { fs::remove_all(folder_); }

  /// The versions at a level, without the folder of the test.
  [[nodiscard]] std::vector<std::string> at(std::size_t level) const {
    std::vector<std::string> found;
    for (const std::string& one : adopted_versions({folder_, {"base", "nobody", "other"}}, level))
      found.push_back(fs::path(one).lexically_relative(folder_));
    return found;
  }

  fs::path folder_;
};

TEST_F(AdoptedVersions, AreTheNewestOfEachPublisherAndThenThoseBefore) {
  for (const char* name : {"base/9", "base/10", "base/2", "other/1", "stranger/5"})
    fs::create_directories(folder_ / name);
  EXPECT_THAT(at(0), ElementsAre("base/10", "other/1"));
  EXPECT_THAT(at(1), ElementsAre("base/9"));
  EXPECT_THAT(at(2), ElementsAre("base/2"));
  EXPECT_THAT(at(3), IsEmpty());
}

TEST_F(AdoptedVersions, AreFoldersNamedByWholeNumbers) {
  for (const char* name : {"base/.7.0123456789abcdef.part", "base/007", "base/8x", "base/-3"})
    fs::create_directories(folder_ / name);
  fs::create_directory_symlink("/", folder_ / "base" / "12");
  EXPECT_THAT(at(0), IsEmpty());
  EXPECT_THAT(adopted_versions({}, 0), IsEmpty());
}

}  // namespace
}  // namespace geminga::daemon
