// The file that a daemon reads and writes in its state folder.
#include "daemon/state_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <expected>
#include <filesystem>
#include <fstream>
#include <functional>

#include "daemon/configuration/layer.hpp"

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
  /// The identity; what is to be said of it is kept in `remark`.
  [[nodiscard]] std::expected<std::uint32_t, std::string> asked() {
    const auto identity = lasting_identity(folder(), [this] { return ++drawn; });
    remark = identity ? identity->remark : "";
    if (!identity) return std::unexpected(identity.error());
    return identity->number;
  }

  std::filesystem::path above;
  std::string remark;
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
       {"\n", "identity", "identity 00000000", "identity 0000000", "identity 000000001", "identity +0000001",
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

TEST_F(StateFolder, WithAnEmptyFileGetsAnotherIdentityAndSaysSo) {
  for (const std::string& left : {std::string(), std::string(1, '\0'), std::string(max_identity_file_bytes, '\0')}) {
    write(left);
    const auto identity = asked();
    ASSERT_TRUE(identity) << identity.error();
    EXPECT_THAT(remark, testing::AllOf(StartsWith(folder()), HasSubstr("another identity is drawn")));
    EXPECT_EQ(asked(), identity) << "it lasts";
    EXPECT_EQ(remark, "") << "said once";
  }
  write(std::string(max_identity_file_bytes + 1, '\0'));
  EXPECT_FALSE(asked()) << "that is a file of somebody else";
}

/// The exit status of a child that does this.
int in_child(const std::function<int()>& deed) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(deed());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(StateFolder, ThatCannotBeWrittenKeepsNoDraft) {
  const auto is_refused = [this] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit nothing{0, 0};
    ::setrlimit(RLIMIT_FSIZE, &nothing);
    return asked() ? 1 : 0;
  };
  std::filesystem::create_directory(folder());
  EXPECT_EQ(in_child(is_refused), 0);
  EXPECT_TRUE(std::filesystem::is_empty(folder()));
  write("");
  EXPECT_EQ(in_child(is_refused), 0);
  EXPECT_FALSE(std::filesystem::exists(folder() + "/identity.new"));
  EXPECT_TRUE(std::filesystem::exists(folder() + "/identity")) << "what was there stays";
}

TEST_F(StateFolder, OnAFullDiskKeepsNoDraft) {
  std::filesystem::create_directory(folder());
  const int status = in_child([this] {
    const bool is_mounted = (::geteuid() == 0 ? ::unshare(CLONE_NEWNS) : ::unshare(CLONE_NEWUSER | CLONE_NEWNS)) == 0 &&
                            ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                            ::mount("none", folder().c_str(), "tmpfs", 0, "size=4096") == 0;
    if (!is_mounted) return 200;
    std::ofstream(folder() + "/filler") << std::string(4096, 'x');
    if (asked()) return 1;
    return std::filesystem::exists(folder() + "/identity.new") ? 2 : 0;
  });
  if (status == 200) GTEST_SKIP() << "no tmpfs may be mounted here; the test above limits the file instead";
  EXPECT_EQ(status, 0) << "1: it was written; 2: the draft is left";
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
