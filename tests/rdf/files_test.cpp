// Which files a name means, and which are never opened.
#include "rdf/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "rdf/load.hpp"
#include "rdf/scratch.hpp"

namespace geminga::rdf {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

std::vector<std::string> names(const std::expected<std::vector<std::string>, LoadError>& files) {
  std::vector<std::string> found;
  if (!files) return {"refused: " + to_string(files.error())};
  for (const std::string& file : *files) found.push_back(std::filesystem::path(file).filename().string());
  return found;
}

TEST(Files, AFolderMeansItsOntologyFilesSortedByName) {
  const Scratch scratch;
  for (const char* name : {"z.owl", "b.ttl", "a.nt", "c.rdf", "d.xml", "e.ofn", "f.fss", "notes.txt", ".#b.ttl",
                           "catalog-v001.xml", "below/e.ttl", "folder.ttl/f.ttl"})
    scratch.write(name, "");
  EXPECT_THAT(names(list_files(std::vector{scratch.path().string()}, {})),
              ElementsAre("a.nt", "b.ttl", "c.rdf", "d.xml", "e.ofn", "f.fss", "z.owl"));
}

TEST(Files, WhatIsNamedTwiceIsTakenOnce) {
  const Scratch scratch;
  const std::string a = scratch.write("a.ttl", "");
  scratch.write("b.ttl", "");
  std::filesystem::create_symlink("a.ttl", scratch.path() / "c.ttl");
  EXPECT_THAT(names(list_files(std::vector{a, scratch.path().string(), a}, {})), ElementsAre("a.ttl", "b.ttl"));
}

TEST(Files, AFolderWithoutOntologiesIsAnError) {
  const Scratch scratch;
  scratch.write("notes.txt", "");
  const auto files = list_files(std::vector{scratch.path().string()}, {});
  ASSERT_FALSE(files);
  EXPECT_THAT(files.error().text, HasSubstr("holds no ontology file"));
}

TEST(Files, ALinkThatLeavesItsFolderIsRefused) {
  const Scratch outside;
  const std::string target = outside.write("secret.ttl", "");
  const Scratch scratch;
  scratch.write("a.ttl", "");
  std::filesystem::create_symlink(target, scratch.path() / "b.ttl");
  const auto files = list_files(std::vector{scratch.path().string()}, {});
  ASSERT_FALSE(files);
  EXPECT_THAT(files.error().file, EndsWith("b.ttl"));
  EXPECT_EQ(files.error().text, "is a link that leads out of its folder: name the file itself");
}

TEST(Files, ALinkToNowhereIsAnError) {
  const Scratch scratch;
  std::filesystem::create_symlink("nowhere", scratch.path() / "a.ttl");
  EXPECT_FALSE(list_files(std::vector{scratch.path().string()}, {}));
}

TEST(Files, FifosDevicesAndSocketsAreNeverOpened) {
  const Scratch scratch;
  const std::string fifo = (scratch.path() / "fifo.ttl").string();
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  const auto read_fifo = FileBytes::read(fifo, {});  // would wait for ever for somebody who writes
  ASSERT_FALSE(read_fifo);
  EXPECT_EQ(read_fifo.error().text, "is a FIFO, not a regular file");
  EXPECT_TRUE(read_fifo.error().is_unreadable);
  EXPECT_FALSE(load(std::vector{scratch.path().string()}));

  const auto device = FileBytes::read("/dev/zero", {});
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().text, "is a device, not a regular file");
  const auto folder = FileBytes::read(scratch.path().string(), {});
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().text, "is a folder, not a regular file");
  const auto missing = FileBytes::read((scratch.path() / "missing.ttl").string(), {});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().text, "cannot be opened: No such file or directory");
}

TEST(Files, AFileThatGrowsWhileItIsReadIsRefused) {
  // A file of /proc says that it has no bytes, and then has some: like one that grew between the two questions.
  const auto bytes = FileBytes::read("/proc/self/status", {});
  ASSERT_FALSE(bytes);
  EXPECT_EQ(bytes.error().text, "became longer while it was read: try again");
}

TEST(Files, WhatMayNotBeReadIsUnreadable) {
  const Scratch scratch;
  const std::string path = scratch.write("a.ttl", "");
  ASSERT_EQ(chmod(path.c_str(), 0), 0);
  // Root may read everything, so for the length of the call it is somebody who may not.
  const bool is_root = geteuid() == 0;
  constexpr uid_t nobody = 65'534;
  if (is_root && seteuid(nobody) != 0) GTEST_SKIP() << "root of this user namespace may become nobody else";
  const auto bytes = FileBytes::read(path, {});
  if (is_root) {
    ASSERT_EQ(seteuid(0), 0);
  }
  ASSERT_FALSE(bytes);
  EXPECT_EQ(bytes.error().text, "cannot be opened: Permission denied");
  EXPECT_TRUE(bytes.error().is_unreadable);
}

TEST(Files, AFolderNamedLikeAFileIsReadAsTheFolderThatItIs) {
  const Scratch scratch;
  scratch.write("x.ttl/a.ttl", "");
  EXPECT_THAT(names(list_files(std::vector{(scratch.path() / "x.ttl").string()}, {})), ElementsAre("a.ttl"));
}

TEST(Files, ReleasedBytesAreGoneAndTheRestIsThere) {
  const Scratch scratch;
  const std::string path = scratch.write("a.ttl", std::string(1 << 18, 'x') + "end");
  auto bytes = FileBytes::read(path, {});
  ASSERT_TRUE(bytes);
  EXPECT_EQ(bytes->view().size(), (1U << 18) + 3);
  EXPECT_EQ(bytes->release(0, 1 << 17), 1U << 17);
  EXPECT_EQ(bytes->view()[0], '\0');
  EXPECT_TRUE(bytes->view().ends_with("xxxend"));
}

}  // namespace
}  // namespace geminga::rdf
