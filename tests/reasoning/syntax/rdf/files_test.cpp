// Which files a name means, and which are never opened.
#include "reasoning/syntax/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "reasoning/syntax/folders.hpp"
#include "reasoning/syntax/rdf/load.hpp"
#include "reasoning/syntax/rdf/scratch.hpp"

namespace geminga::rdf {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

/// As seen from a folder.
std::vector<std::string> from(const std::filesystem::path& folder, const std::vector<std::string>& paths) {
  std::vector<std::string> found;
  for (const std::string& path : paths)
    found.push_back(std::filesystem::path(path).lexically_relative(folder).string());
  return found;
}

std::vector<std::string> names(const std::expected<syntax::Listing, syntax::LoadError>& listing) {
  if (!listing) return {"refused: " + to_string(listing.error())};
  std::vector<std::string> found;
  for (const std::string& file : listing->files) found.push_back(std::filesystem::path(file).filename().string());
  return found;
}

TEST(Files, OfAFolderThatAreRefusedAreLeftOutWhereThatIsWanted) {
  const Scratch scratch;
  scratch.write("a.ttl", "<http://e/A> <http://e/p> <http://e/B> .\n");
  scratch.write("b.ttl", "this is broken");
  scratch.write("c.ttl.gz", "\x1f\x8b\x08");
  scratch.write("below/d.nt", "<http://e/C> <http://e/p> <http://e/D> .\n");
  scratch.write("catalog-v001.xml", "<broken");
  std::filesystem::create_symlink("/dev/null", scratch.path() / "e.ttl");
  const std::vector<std::string> folder{scratch.path().string()};
  EXPECT_FALSE(load(folder));
  std::vector<syntax::LoadError> left_out;
  const auto loaded = load(folder, {}, nullptr, 1, &left_out);
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_EQ(loaded->triples, 2U);
  EXPECT_THAT(from(scratch.path(), loaded->listing.files), ElementsAre("a.ttl", "below/d.nt"));
  std::vector<std::string> named;
  for (const syntax::LoadError& error : left_out)
    named.push_back(std::filesystem::path(error.file).filename().string());
  EXPECT_THAT(named, testing::UnorderedElementsAre("b.ttl", "c.ttl.gz", "e.ttl", "catalog-v001.xml"));

  left_out.clear();
  const std::vector<std::string> named_itself{scratch.path().string(), (scratch.path() / "b.ttl").string()};
  EXPECT_FALSE(load(named_itself, {}, nullptr, 1, &left_out)) << "a file that is named itself is wanted";
}

TEST(Files, OfAFolderAreLeftOutUpToALimit) {
  for (const std::size_t bad : {syntax::max_left_out - 1, syntax::max_left_out, syntax::max_left_out + 1}) {
    const Scratch scratch;
    scratch.write("z.ttl", "");
    for (std::size_t number = 0; number < bad; ++number) scratch.write("b" + std::to_string(number) + ".ttl", "broken");
    std::vector<syntax::LoadError> left_out;
    const auto loaded = load(std::vector{scratch.path().string()}, {}, nullptr, 1, &left_out);
    EXPECT_EQ(loaded.has_value(), bad <= syntax::max_left_out) << bad;
    EXPECT_EQ(left_out.size(), std::min(bad, syntax::max_left_out)) << bad;
  }
  const Scratch scratch;
  scratch.write("b.ttl", "broken");
  std::vector<syntax::LoadError> left_out;
  EXPECT_FALSE(load(std::vector{scratch.path().string()}, {}, nullptr, 1, &left_out)) << "nothing would be left";
}

TEST(Files, AFolderMeansItsOntologyFilesAndThoseBelowSortedByPath) {
  const Scratch scratch;
  for (const char* name :
       {"z.owl", "b.ttl", "a.nt", "c.rdf", "d.xml", "e.ofn", "f.fss", "g.omn", "h.owx", "i.owl.gz", "notes.txt",
        ".#b.ttl", ".git/x.ttl", "catalog-v001.xml", "below/deep/e.ttl", "folder.ttl/f.ttl", "table.csv.gz"})
    scratch.write(name, "");
  const auto listing = syntax::list_files(std::vector{scratch.path().string()}, {});
  ASSERT_TRUE(listing);
  EXPECT_THAT(from(scratch.path(), listing->files),
              ElementsAre("a.nt", "b.ttl", "below/deep/e.ttl", "c.rdf", "d.xml", "e.ofn", "f.fss", "folder.ttl/f.ttl",
                          "g.omn", "h.owx", "i.owl.gz", "z.owl"));
  EXPECT_THAT(from(scratch.path(), listing->folders), ElementsAre(".", "below", "below/deep", "folder.ttl"));
  EXPECT_THAT(from(scratch.path(), listing->skipped), ElementsAre("notes.txt", "table.csv.gz"));
}

TEST(Files, XmlOfOtherProgramsInAFolderIsSkippedAndWhatIsNamedIsNot) {
  const Scratch scratch;
  const std::string package = scratch.write("package.xml", "<?xml version=\"1.0\"?>\n<package format=\"3\"/>");
  scratch.write("a.xml", "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\"/>");
  scratch.write("b.xml", "<Ontology xmlns=\"http://www.w3.org/2002/07/owl#\"/>");
  const auto listing = syntax::list_files(std::vector{scratch.path().string()}, {});
  ASSERT_TRUE(listing);
  EXPECT_THAT(from(scratch.path(), listing->files), ElementsAre("a.xml", "b.xml"));
  EXPECT_THAT(from(scratch.path(), listing->skipped), ElementsAre("package.xml"));
  EXPECT_THAT(names(syntax::list_files(std::vector{package}, {})), ElementsAre("package.xml"));
}

TEST(Files, LinksToFoldersAreNotFollowedSoThatNoneLeadsRound) {
  const Scratch scratch;
  scratch.write("below/a.ttl", "");
  std::filesystem::create_directory_symlink("..", scratch.path() / "below" / "up");
  const auto listing = syntax::list_files(std::vector{scratch.path().string()}, {});
  ASSERT_TRUE(listing);
  EXPECT_THAT(from(scratch.path(), listing->files), ElementsAre("below/a.ttl"));
  EXPECT_THAT(from(scratch.path(), listing->skipped), ElementsAre("below/up"));
}

TEST(Files, FoldersHaveAMostOfLevelsAndOfEntries) {
  const Scratch scratch;
  scratch.write("1/2/3/a.ttl", "");
  scratch.write("1/2/b.txt", "");
  const std::vector arguments{scratch.path().string()};
  for (const std::size_t levels : {3U, 4U}) {
    syntax::FileLimits limits;
    limits.folder_levels = levels;
    EXPECT_THAT(names(list_files(arguments, limits)), ElementsAre("a.ttl")) << levels;
  }
  syntax::FileLimits limits;
  limits.folder_levels = 2;
  EXPECT_THAT(names(list_files(arguments, limits)),
              ElementsAre(EndsWith("1/2/3: is more than 2 folders deep: name the folders of the ontologies")));
  limits = {};
  limits.folder_entries = 5;
  EXPECT_THAT(names(list_files(arguments, limits)), ElementsAre("a.ttl"));
  limits.folder_entries = 4;
  EXPECT_THAT(names(list_files(arguments, limits)),
              ElementsAre(HasSubstr("holds more than 4 files: name the folders of the ontologies")));
}

TEST(Files, WhatIsNamedTwiceIsTakenOnce) {
  const Scratch scratch;
  const std::string a = scratch.write("a.ttl", "");
  scratch.write("b.ttl", "");
  std::filesystem::create_symlink("a.ttl", scratch.path() / "c.ttl");
  EXPECT_THAT(names(syntax::list_files(std::vector{a, scratch.path().string(), a}, {})), ElementsAre("a.ttl", "b.ttl"));
}

TEST(Files, AFolderWithoutOntologiesIsAnError) {
  const Scratch scratch;
  scratch.write("notes.txt", "");
  const auto files = syntax::list_files(std::vector{scratch.path().string()}, {});
  ASSERT_FALSE(files);
  EXPECT_THAT(files.error().text, HasSubstr("holds no ontology file"));
}

TEST(Files, ALinkThatLeavesItsFolderIsRefused) {
  const Scratch outside;
  const std::string target = outside.write("secret.ttl", "");
  const Scratch scratch;
  scratch.write("a.ttl", "");
  std::filesystem::create_symlink(target, scratch.path() / "b.ttl");
  const auto files = syntax::list_files(std::vector{scratch.path().string()}, {});
  ASSERT_FALSE(files);
  EXPECT_THAT(files.error().file, EndsWith("b.ttl"));
  EXPECT_EQ(files.error().text, "is a link that leads out of its folder: name the file itself");
}

TEST(Files, ALinkToNowhereIsAnError) {
  const Scratch scratch;
  std::filesystem::create_symlink("nowhere", scratch.path() / "a.ttl");
  EXPECT_FALSE(syntax::list_files(std::vector{scratch.path().string()}, {}));
}

TEST(Files, FifosDevicesAndSocketsAreNeverOpened) {
  const Scratch scratch;
  const std::string fifo = (scratch.path() / "fifo.ttl").string();
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  const auto read_fifo = syntax::FileBytes::read(fifo, {});  // a blocking open would wait for a writer for ever
  ASSERT_FALSE(read_fifo);
  EXPECT_EQ(read_fifo.error().text, "is a FIFO, not a regular file");
  EXPECT_TRUE(read_fifo.error().is_unreadable);
  EXPECT_FALSE(load(std::vector{scratch.path().string()}));

  const auto device = syntax::FileBytes::read("/dev/zero", {});
  ASSERT_FALSE(device);
  EXPECT_EQ(device.error().text, "is a device, not a regular file");
  const auto folder = syntax::FileBytes::read(scratch.path().string(), {});
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().text, "is a folder, not a regular file");
  const auto missing = syntax::FileBytes::read((scratch.path() / "missing.ttl").string(), {});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().text, "cannot be opened: No such file or directory");
}

TEST(Files, AFileThatGrowsWhileItIsReadIsRefused) {
  // A file of /proc says that it has no bytes, and then has some: like one that grew between the two questions.
  const auto bytes = syntax::FileBytes::read("/proc/self/status", {});
  ASSERT_FALSE(bytes);
  EXPECT_EQ(bytes.error().text, "became longer while it was read: try again");
}

TEST(Files, WhatMayNotBeReadIsUnreadable) {
  const Scratch scratch;
  const std::string path = scratch.write("a.ttl", "");
  ASSERT_EQ(chmod(path.c_str(), 0), 0);
  // Root may read every file, so that the test drops that right for the call.
  const bool is_root = geteuid() == 0;
  constexpr uid_t nobody = 65'534;
  if (is_root && seteuid(nobody) != 0) GTEST_SKIP() << "root of this user namespace may become nobody else";
  const auto bytes = syntax::FileBytes::read(path, {});
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
  EXPECT_THAT(names(syntax::list_files(std::vector{(scratch.path() / "x.ttl").string()}, {})), ElementsAre("a.ttl"));
}

TEST(Files, ReleasedBytesAreGoneAndTheRestIsThere) {
  const Scratch scratch;
  const std::string path = scratch.write("a.ttl", std::string(1 << 18, 'x') + "end");
  auto bytes = syntax::FileBytes::read(path, {});
  ASSERT_TRUE(bytes);
  EXPECT_EQ(bytes->view().size(), (1U << 18) + 3);
  EXPECT_EQ(bytes->release(0, 1 << 17), 1U << 17);
  EXPECT_EQ(bytes->view()[0], '\0');
  EXPECT_TRUE(bytes->view().ends_with("xxxend"));
}

}  // namespace
}  // namespace geminga::rdf
