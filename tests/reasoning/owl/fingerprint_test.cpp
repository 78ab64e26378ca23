// A compiled form knows what its files held.
#include "reasoning/owl/fingerprint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "reasoning/compiled/compile.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/owl/source_paths.hpp"
#include "support/written.hpp"

namespace geminga::owl {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Fingerprints : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("fingerprint-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + '-' +
               std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(path(name)) << text;
    return path(name);
  }
  compiled::Ontology compiled_from(const std::string& file, const std::string& text) {
    Ontology source = written("SubClassOf(A B)", file);
    source.set_content(FileId{0}, fingerprint_of(text));
    auto ontology = compiled::Ontology::from_bytes(compiled::compile(source, classified(source)));
    EXPECT_TRUE(ontology);
    return std::move(*ontology);
  }

 private:
  fs::path folder_;
};

TEST_F(Fingerprints, OfAFileAreThoseOfItsOctets) {
  const std::string large(1'000'000, 'x');
  EXPECT_FALSE(has_changed(write("large", large), fingerprint_of(large)));
  EXPECT_TRUE(has_changed(path("large"), fingerprint_of(std::string(1'000'000, 'y'))));
  EXPECT_FALSE(has_changed(write("empty", ""), fingerprint_of("")));
  EXPECT_TRUE(has_changed(path("empty"), fingerprint_of("x")));
  EXPECT_TRUE(fingerprint_of("").is_known());
  EXPECT_FALSE(Fingerprint{}.is_known());
}

TEST_F(Fingerprints, AreNotTakenOfWhatIsNoFile) {
  const Fingerprint known = fingerprint_of("something");
  EXPECT_FALSE(has_changed(path("nothing"), known));
  EXPECT_FALSE(has_changed(testing::TempDir(), known));
  ASSERT_EQ(::mkfifo(path("fifo").c_str(), 0600), 0);
  EXPECT_FALSE(has_changed(path("fifo"), known));
}

TEST_F(Fingerprints, SayThatASourceHasChanged) {
  const std::string file = write("a.owl", "one two");
  const compiled::Ontology ontology = compiled_from(file, "one two");
  EXPECT_EQ(ontology.files().front().content, fingerprint_of("one two"));
  EXPECT_EQ(ontology.stale_source(), std::nullopt);
  write("a.owl", "one too");
  ASSERT_TRUE(ontology.stale_source());
  EXPECT_THAT(*ontology.stale_source(), HasSubstr("a.owl has changed since this was compiled"));
  write("a.owl", "one two three");
  EXPECT_TRUE(ontology.stale_source());
}

TEST_F(Fingerprints, DoNotMindATouchedOrMissingSource) {
  const std::string file = write("a.owl", "one two");
  const compiled::Ontology ontology = compiled_from(file, "one two");
  fs::last_write_time(file, fs::last_write_time(file) + std::chrono::hours(1));
  EXPECT_EQ(ontology.stale_source(), std::nullopt);
  fs::remove(file);
  EXPECT_EQ(ontology.stale_source(), std::nullopt);
}

TEST_F(Fingerprints, ThatNobodyTookAreNotHeldAgainstAFile) {
  const compiled::Ontology ontology = loaded(written("SubClassOf(A B)", write("a.owl", "anything")));
  EXPECT_EQ(ontology.stale_source(), std::nullopt);
}

TEST(SourcePaths, AreRelativeToTheFolderOfTheCompiledForm) {
  EXPECT_EQ(seen_from_folder("/ws", "/ws/team/a.owl"), "team/a.owl");
  EXPECT_EQ(seen_from_folder("/ws/out", "/ws/team/a.owl"), "../team/a.owl");
  EXPECT_EQ(seen_from_folder("/ws/out", "/ws/./team/../a.owl"), "../a.owl");
  EXPECT_EQ(seen_from_here("/robot/out", "../team/a.owl"), "/robot/team/a.owl");
  EXPECT_EQ(seen_from_here("/robot", "a.owl"), "/robot/a.owl");
  EXPECT_EQ(seen_from_here("/robot", "/ws/a.owl"), "/ws/a.owl");
  EXPECT_EQ(seen_from_here("", "team/a.owl"), "team/a.owl");
}

TEST(SourcePaths, AreTheSameHoweverTheyWereNamed) {
  const fs::path here = fs::current_path();
  EXPECT_EQ(folder_of("a.geminga"), here.string());
  EXPECT_EQ(folder_of("./a.geminga"), here.string());
  EXPECT_EQ(folder_of((here / "a.geminga").string()), here.string());
  EXPECT_EQ(seen_from_folder(folder_of("a.geminga"), "team/a.owl"), "team/a.owl");
  EXPECT_EQ(seen_from_folder(folder_of("a.geminga"), (here / "team" / "a.owl").string()), "team/a.owl");
}

TEST_F(Fingerprints, OfSourcesBehindALinkAreFound) {
  // in/link -> in/far/there: in/link/../a.owl is in/far/a.owl and not in/a.owl.
  fs::create_directories(path("far/there"));
  fs::create_directory_symlink(path("far/there"), path("link"));
  write("far/a.owl", "one");
  write("a.owl", "another");
  const std::string folder = folder_of(path("out.geminga"));
  EXPECT_TRUE(
      fs::equivalent(seen_from_here(folder, seen_from_folder(folder, path("link/../a.owl"))), path("far/a.owl")));
}

}  // namespace
}  // namespace geminga::owl
