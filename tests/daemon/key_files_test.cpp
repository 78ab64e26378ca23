#include "daemon/configuration/key_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "discovery/sealing/limits.hpp"

namespace geminga::daemon {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

struct KeyFiles : testing::Test {
  KeyFiles() {
    std::string path = std::filesystem::temp_directory_path() / "geminga-keys-XXXXXX";
    if (::mkdtemp(path.data()) != nullptr) folder = path;
  }
  ~KeyFiles() override { std::filesystem::remove_all(folder); }

  [[nodiscard]] std::string path(const std::string& name) const { return folder / name; }
  /// Makes a key file.
  [[nodiscard]] std::string made(const std::string& name) const {
    EXPECT_TRUE(generate_key(path(name)));
    return path(name);
  }
  [[nodiscard]] static std::string text_of(const std::string& file) {
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  std::filesystem::path folder;
};

TEST_F(KeyFiles, AreReadInTheirOrder) {
  const auto keys = read_keys({made("a"), made("b")});
  ASSERT_TRUE(keys) << keys.error().front();
  ASSERT_THAT(keys->keys(), SizeIs(2));
  EXPECT_EQ(read_keys({path("b")})->first().id(), keys->keys()[1].id());
  EXPECT_TRUE(read_keys({})->is_empty());
}

TEST_F(KeyFiles, AreMadeForTheirOwnerAloneWhateverTheMask) {
  const auto before = ::umask(0);
  const auto id = generate_key(path("key"));
  ::umask(before);
  ASSERT_TRUE(id) << id.error();
  struct stat status{};
  ASSERT_EQ(::stat(path("key").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 0600U);
  EXPECT_EQ(to_string(read_keys({path("key")})->first().id()), *id);
  EXPECT_THAT(text_of(path("key")), HasSubstr("key " + *id + ' '));
}

TEST_F(KeyFiles, DifferFromEachOther) { EXPECT_NE(text_of(made("a")), text_of(made("b"))); }

TEST_F(KeyFiles, AreNeverOverwritten) {
  const std::string file = made("key");
  const std::string text = text_of(file);
  std::filesystem::create_symlink(path("nowhere"), path("link"));
  for (const char* name : {"key", "link", "."}) {
    const auto again = generate_key(path(name));
    ASSERT_FALSE(again) << name;
    EXPECT_THAT(again.error(), StartsWith(path(name) + ": "));
  }
  EXPECT_THAT(generate_key(file).error(), HasSubstr("is there already, and a key is never overwritten"));
  EXPECT_EQ(text_of(file), text);
  EXPECT_FALSE(std::filesystem::exists(path("nowhere")));
  EXPECT_FALSE(generate_key(path("no/such/folder")));
}

TEST_F(KeyFiles, ThatGroupOrOthersMayReadOrChangeAreRefused) {
  const std::string file = made("key");
  for (const ::mode_t mode : {0640U, 0620U, 0610U, 0604U, 0602U, 0601U, 0644U, 0666U}) {
    ASSERT_EQ(::chmod(file.c_str(), mode), 0);
    const auto keys = read_keys({file});
    ASSERT_FALSE(keys) << mode;
    EXPECT_THAT(keys.error(), ElementsAre(AllOf(StartsWith(file + ": "), HasSubstr("group or others"),
                                                HasSubstr("chmod 600 " + file))));
  }
  for (const ::mode_t mode : {0600U, 0400U, 0700U}) {
    ASSERT_EQ(::chmod(file.c_str(), mode), 0);
    EXPECT_TRUE(read_keys({file})) << mode;
  }
}

TEST_F(KeyFiles, InAFolderWhereOthersMayReplaceThemAreRefused) {
  const std::string file = made("key");
  for (const ::mode_t mode : {0777U, 0770U, 0720U, 0702U}) {
    ASSERT_EQ(::chmod(folder.c_str(), mode), 0);
    const auto keys = read_keys({file});
    ASSERT_FALSE(keys) << mode;
    EXPECT_THAT(keys.error(), ElementsAre(AllOf(StartsWith(file + ": "), HasSubstr("chmod go-w " + folder.string()))));
  }
  for (const ::mode_t mode : {0700U, 0755U, 0750U, 01777U}) {
    ASSERT_EQ(::chmod(folder.c_str(), mode), 0);
    EXPECT_TRUE(read_keys({file})) << mode;
  }
}

TEST_F(KeyFiles, AreLookedForWhereTheirLinksLieAndWhereTheyPoint) {
  for (const char* name : {"links", "keys"}) std::filesystem::create_directory(folder / name);
  ASSERT_TRUE(read_keys({made("keys/key")}));
  const std::string link = path("links/key");
  std::filesystem::create_symlink("../keys/key", link);
  EXPECT_TRUE(read_keys({link}));
  for (const char* name : {"links", "keys"}) {
    ASSERT_EQ(::chmod((folder / name).c_str(), 0777), 0);
    EXPECT_THAT(read_keys({link}).error(), ElementsAre(HasSubstr("chmod go-w " + path("")))) << name;
    ASSERT_EQ(::chmod((folder / name).c_str(), 0755), 0);
  }
}

TEST_F(KeyFiles, OfAnotherUserAreRefusedUnlessThatIsRoot) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give files away";
  constexpr ::uid_t another = 12345;
  const std::string file = made("key");
  ASSERT_EQ(::chown(file.c_str(), another, 0), 0);
  EXPECT_THAT(read_keys({file}).error(),
              ElementsAre(AllOf(StartsWith(file + ": belongs to another user"), HasSubstr("chown 0 " + file))));
  ASSERT_EQ(::chown(file.c_str(), 0, 0), 0);
  ASSERT_EQ(::chown(folder.c_str(), another, 0), 0);
  EXPECT_THAT(read_keys({file}).error(), ElementsAre(HasSubstr("chown 0 " + folder.string())));
  // Another user reads keys of root and of its own.
  ASSERT_EQ(::chown(folder.c_str(), 0, 0), 0);
  ASSERT_EQ(::chmod(folder.c_str(), 0755), 0);
  ASSERT_EQ(::chown(file.c_str(), another, 0), 0);
  const pid_t child = ::fork();
  if (child == 0) ::_exit(::setuid(another) == 0 && read_keys({file}) ? 0 : 1);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST_F(KeyFiles, OfTheServiceManagerAreTakenAsItGivesThem) {
  const std::string file = made("key");
  ASSERT_EQ(::chmod(file.c_str(), 0440), 0);
  ASSERT_EQ(::chmod(folder.c_str(), 0770), 0);
  EXPECT_FALSE(read_keys({file}));
  ASSERT_EQ(::setenv("CREDENTIALS_DIRECTORY", folder.c_str(), 1), 0);
  EXPECT_TRUE(read_keys({file})) << "an access list looks like a right of the group";
  for (const ::mode_t mode : {0444U, 0460U, 0442U}) {
    ASSERT_EQ(::chmod(file.c_str(), mode), 0);
    EXPECT_FALSE(read_keys({file})) << mode;
  }
  ASSERT_EQ(::chmod(file.c_str(), 0440), 0);
  ASSERT_EQ(::setenv("CREDENTIALS_DIRECTORY", path("other").c_str(), 1), 0);
  EXPECT_FALSE(read_keys({file})) << "another folder";
  ::unsetenv("CREDENTIALS_DIRECTORY");
}

TEST_F(KeyFiles, ThatAreWrongAreAllToldOfWithTheirLines) {
  std::ofstream(path("bad")) << "# a key\nkey of mine\n";
  ASSERT_EQ(::chmod(path("bad").c_str(), 0600), 0);
  ASSERT_EQ(::mkfifo(path("fifo").c_str(), 0600), 0);
  const auto keys = read_keys({path("bad"), path("missing"), path("fifo"), folder.string(), made("good")});
  ASSERT_FALSE(keys);
  EXPECT_THAT(keys.error(),
              ElementsAre(StartsWith(path("bad") + ":2: "), StartsWith(path("missing") + ": No such file or directory"),
                          HasSubstr("is not a regular file"), HasSubstr("is not a regular file")));
}

TEST_F(KeyFiles, AreEightAtMostAndEachIsNamedOnce) {
  std::vector<std::string> files;
  for (std::size_t i = 0; i < sealing::max_keys; ++i) files.push_back(made(std::to_string(i)));
  EXPECT_TRUE(read_keys(files));
  files.push_back(made("more"));
  EXPECT_THAT(read_keys(files).error(), ElementsAre(HasSubstr("one key more than the 8")));
  EXPECT_THAT(read_keys({files[0], files[0]}).error(), ElementsAre(HasSubstr("a second key")));
}

}  // namespace
}  // namespace geminga::daemon
