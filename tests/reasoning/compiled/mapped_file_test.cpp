// A reader of a mapped file is not affected by changes of the file.
#include "reasoning/compiled/mapped_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "support/written.hpp"

namespace geminga::compiled {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class MappedFileTest : public testing::Test {
 protected:
  MappedFileTest() {
    std::string path = fs::temp_directory_path() / "geminga-mapped-XXXXXX";
    EXPECT_NE(::mkdtemp(path.data()), nullptr);
    folder = path;
  }
  ~MappedFileTest() override { fs::remove_all(folder); }

  std::string write(const std::string& name, std::string_view octets) const {
    std::ofstream(folder / name, std::ios::binary) << octets;
    return folder / name;
  }
  /// Into the same inode, as `cp new old` does.
  void overwrite(const std::string& name, std::string_view octets) const {
    std::fstream(folder / name, std::ios::binary | std::ios::in | std::ios::out) << octets;
  }

  fs::path folder;
};

std::expected<void, std::string> anything(std::span<const std::byte>, std::uint64_t) { return {}; }

std::string text_of(const MappedFile& file) {
  return {reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size()};
}

std::string compiled(const std::string& name) {
  owl::Ontology source = owl::written("SubClassOf(" + name + " Thing_of_the_game)");
  const std::vector<std::byte> bytes = compile(source, owl::classified(source));
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST_F(MappedFileTest, StaysWhatItWasWhenTheFileIsCutShortOrOverwritten) {
  const std::string octets(1'000'000, 'a');
  const std::string path = write("file", octets);
  const auto file = MappedFile::copy_of(path, anything);
  ASSERT_TRUE(file) << file.error();
  overwrite("file", std::string(octets.size(), 'b'));
  EXPECT_EQ(text_of(*file), octets) << "the same size, other octets";
  fs::resize_file(path, 0);
  EXPECT_EQ(text_of(*file), octets) << "SIGBUS ends who reads a mapping of the file itself";
}

TEST_F(MappedFileTest, LeavesNothingBesideTheFile) {
  const std::string path = write("file", "octets");
  const auto file = MappedFile::copy_of(path, anything);
  ASSERT_TRUE(file);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST_F(MappedFileTest, IsLookedAtBeforeItIsCopied) {
  const std::string path = write("file", std::string(MappedFile::beginning_bytes + 1, 'x'));
  const auto refused = MappedFile::copy_of(path, [](std::span<const std::byte> beginning, auto size) {
    EXPECT_EQ(beginning.size(), MappedFile::beginning_bytes);
    EXPECT_EQ(size, MappedFile::beginning_bytes + 1);
    return std::expected<void, std::string>(std::unexpected("not this one"));
  });
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error(), path + ": not this one");
}

TEST_F(MappedFileTest, RefusesWhatIsNoFileWithoutWaiting) {
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  for (const std::string& path : {(folder / "fifo").string(), folder.string(), std::string("/dev/zero")}) {
    const auto refused = MappedFile::copy_of(path, anything);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error(), path + ": is not a regular file");
  }
  EXPECT_THAT(MappedFile::copy_of(folder / "none", anything).error(), HasSubstr("cannot be opened"));
}

TEST_F(MappedFileTest, OfAnOntologyInUseOutlivesWhateverIsWrittenIntoTheFile) {
  const std::string path = write("in-use.geminga", compiled("Ball"));
  const auto ontology = Ontology::map(path);
  ASSERT_TRUE(ontology) << ontology.error().text;
  overwrite("in-use.geminga", compiled("Goal"));
  EXPECT_TRUE(ontology->find("t:Ball"));
  EXPECT_TRUE(ontology->check_whole()) << "labels and axioms are read long after the file was mapped";
  overwrite("in-use.geminga", std::string(fs::file_size(path), '\xff'));
  EXPECT_TRUE(ontology->check_whole());
  fs::resize_file(path, 0);
  EXPECT_TRUE(ontology->find("t:Ball"));
  EXPECT_FALSE(Ontology::map(path));
}

}  // namespace
}  // namespace geminga::compiled
