// The file that a daemon reads and writes in its state folder.
#include "daemon/state_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "daemon/layer.hpp"

namespace geminga::daemon {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct StateFolder : testing::Test {
  StateFolder() {
    std::string path = std::filesystem::temp_directory_path() / "geminga-state-XXXXXX";
    if (::mkdtemp(path.data()) != nullptr) above = path;
  }
  ~StateFolder() override { std::filesystem::remove_all(above); }

  [[nodiscard]] std::string folder() const { return above / "state"; }
  void write(const std::string& text) const {
    std::filesystem::create_directory(folder());
    std::ofstream(folder() + "/identity") << text;
  }
  [[nodiscard]] auto asked() {
    return lasting_identity(folder(), [this] { return ++drawn; });
  }

  std::filesystem::path above;
  std::uint64_t drawn = 0xffff'ffff;  // the next one is 0 in the 32 bits that are taken
};

TEST_F(StateFolder, IsMadeWithAnIdentityThatStays) {
  EXPECT_EQ(asked(), 1U) << "0 would be none";
  EXPECT_EQ(drawn, 0x1'0000'0001U);
  EXPECT_EQ(asked(), 1U);
  EXPECT_EQ(drawn, 0x1'0000'0001U) << "nothing is drawn again";
  EXPECT_FALSE(std::filesystem::exists(folder() + "/identity.new"));
}

TEST_F(StateFolder, IsReadStrictly) {
  for (const auto& [text, identity] : std::initializer_list<std::pair<const char*, std::uint32_t>>{
           {"identity 0000000a", 10}, {"# whose\n\nidentity ffffffff\n", 0xffffffff}}) {
    write(text);
    EXPECT_EQ(asked(), identity) << text;
  }
  for (const char* text :
       {"", "identity", "identity 00000000", "identity 0000000", "identity 000000001", "identity +0000001",
        "identity 0000000g", " identity 00000001", "identity 00000001\nidentity 00000001\n", "identity 00000001\r\n"}) {
    write(text);
    const auto identity = asked();
    ASSERT_FALSE(identity) << text;
    EXPECT_THAT(identity.error(), testing::AllOf(StartsWith(folder()), HasSubstr("remove it"))) << text;
  }
  for (const std::size_t size : {max_identity_file_bytes - 1, max_identity_file_bytes, max_identity_file_bytes + 1}) {
    write("identity 00000001\n#" + std::string(size - 19, 'x'));
    EXPECT_EQ(asked().has_value(), size <= max_identity_file_bytes) << size;
  }
}

TEST_F(StateFolder, ThatCannotBeMadeIsAnErrorAndNotTheEnd) {
  std::filesystem::remove_all(above);
  EXPECT_THAT(asked().error(), HasSubstr("No such file or directory"));
}

TEST(Service, GivesTheFirstFolderOfSeveral) {
  const auto folder_of = [](const char* variable) -> std::string {
    const std::array<const char*, 3> environment{"HOME=/root", variable, nullptr};
    const Layer layer = read_service(environment.data());
    return layer.values.empty() ? "" : layer.values.at("state-folder").front().text;
  };
  EXPECT_EQ(folder_of("STATE_DIRECTORY=/var/lib/geminga"), "/var/lib/geminga");
  EXPECT_EQ(folder_of("STATE_DIRECTORY=/var/lib/geminga:/var/lib/other"), "/var/lib/geminga");
  EXPECT_EQ(folder_of("STATE_DIRECTORY="), "");
  EXPECT_EQ(folder_of("STATE_DIRECTORY_OF_ANOTHER=/x"), "");
  EXPECT_EQ(folder_of("GEMINGA_STATE_FOLDER=/x"), "") << "that is the owner's word";
}

}  // namespace
}  // namespace geminga::daemon
