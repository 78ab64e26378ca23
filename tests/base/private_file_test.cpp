#include "base/private_file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace geminga::base {
namespace {

namespace fs = std::filesystem;

class PrivateFileTest : public testing::Test {
 protected:
  PrivateFileTest() {
    std::string path = fs::temp_directory_path() / "geminga-private-XXXXXX";
    EXPECT_NE(::mkdtemp(path.data()), nullptr);
    folder = path;
  }
  ~PrivateFileTest() override { fs::remove_all(folder); }

  /// A file that holds these octets, open for reading.
  int original(const std::string& octets) const {
    std::ofstream(folder / "original", std::ios::binary) << octets;
    return ::open((folder / "original").c_str(), O_RDONLY | O_CLOEXEC);
  }

  static std::string content(const PrivateFile& file) {
    struct stat status{};
    EXPECT_EQ(::fstat(file.descriptor(), &status), 0);
    std::string octets(static_cast<std::size_t>(status.st_size), '?');
    EXPECT_EQ(::pread(file.descriptor(), octets.data(), octets.size(), 0), status.st_size);
    return octets;
  }

  fs::path folder;
};

TEST_F(PrivateFileTest, HasNoNameAndNobodyElseMayOpenIt) {
  const auto file = PrivateFile::on_disk(std::vector<std::string>{folder}, 100);
  if (!file) GTEST_SKIP() << "the folder for temporary files is on no local disk";
  EXPECT_TRUE(fs::is_empty(folder));
  struct stat status{};
  ASSERT_EQ(::fstat(file->descriptor(), &status), 0);
  EXPECT_EQ(status.st_nlink, 0U);
  EXPECT_EQ(status.st_mode & 07777U, 0600U);
}

TEST_F(PrivateFileTest, LiesInTheFirstFolderOnADiskThatTakesIt) {
  const std::vector<std::string> none{"", "/no/such/folder", "/proc", "/dev/shm"};
  EXPECT_FALSE(PrivateFile::on_disk(none, 0)) << "a file in /dev/shm is memory by another name";
  std::vector<std::string> folders = none;
  folders.push_back(folder);
  EXPECT_EQ(PrivateFile::on_disk(folders, 0).has_value(), PrivateFile::on_disk({&folders.back(), 1}, 0).has_value());
  EXPECT_FALSE(PrivateFile::on_disk(folders, std::size_t{1} << 60U)) << "no disk has so much room";
}

TEST_F(PrivateFileTest, CopiesAFileUpToItsBound) {
  const std::string octets(100'000, 'o');
  for (const std::size_t most : {octets.size() - 1, octets.size(), octets.size() + 1}) {
    const int from = original(octets);
    auto file = PrivateFile::in_memory();
    ASSERT_TRUE(file);
    EXPECT_EQ(file->copy_from(from, most), std::min(most, octets.size()));
    EXPECT_EQ(content(*file), octets.substr(0, most));
    ::close(from);
  }
}

TEST_F(PrivateFileTest, CopiesWhatTheKernelCannotCopyByItself) {
  auto file = PrivateFile::in_memory();
  ASSERT_TRUE(file);
  const int from = ::open("/proc/self/cmdline", O_RDONLY | O_CLOEXEC);
  const auto count = file->copy_from(from, 4096);
  ASSERT_TRUE(count);
  EXPECT_GT(*count, 0U);
  EXPECT_EQ(content(*file).size(), *count);
  ::close(from);
}

TEST_F(PrivateFileTest, HoldsWhatTheOriginalHeldWhenItWasCopied) {
  const int from = original("before");
  auto file = PrivateFile::in_memory();
  ASSERT_TRUE(file);
  EXPECT_EQ(file->copy_from(from, 100), 6U);
  ::close(original("after it"));
  EXPECT_EQ(content(*file), "before");
  ::close(from);
}

}  // namespace
}  // namespace geminga::base
