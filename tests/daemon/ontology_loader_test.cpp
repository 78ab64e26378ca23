// The loader with shell scripts as compilers: arguments, failures, leftovers.
#include "daemon/ontology/ontology_loader.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "reasoning/compiled/compile.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/owl/fingerprint.hpp"
#include "reasoning/owl/source_paths.hpp"

namespace geminga::daemon {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

using Result = std::expected<LoadedOntology, std::vector<std::string>>;

class OntologyLoaderTest : public testing::Test {
 protected:
  OntologyLoaderTest() {
    std::string path = fs::temp_directory_path() / "geminga-loader-XXXXXX";
    EXPECT_NE(::mkdtemp(path.data()), nullptr);
    folder = path;
    fs::create_directory(folder / "tmp");
    ::setenv("TMPDIR", (folder / "tmp").c_str(), 1);
  }
  ~OntologyLoaderTest() override {
    ::unsetenv("TMPDIR");
    fs::remove_all(folder);
  }

  /// Makes this shell script the compiler.
  std::string compiler(const std::string& script) {
    const fs::path path = folder / "compiler";
    std::ofstream(path) << "#!/bin/sh\n" << script << '\n';
    fs::permissions(path, fs::perms::owner_all);
    return path;
  }

  Result load(const std::string& script, const std::vector<std::string>& files, const Prefixes& prefixes = {}) {
    boost::asio::io_context context;
    OntologyLoader loader(context, compiler(script));
    std::optional<Result> result;
    loader.load(files, prefixes, [&](Result loaded) { result.emplace(std::move(loaded)); });
    context.run();
    EXPECT_TRUE(result);
    EXPECT_FALSE(loader.is_loading());
    EXPECT_TRUE(fs::is_empty(folder / "tmp")) << "nothing is left behind";
    return result ? std::move(*result) : Result(std::unexpected(std::vector<std::string>{}));
  }

  fs::path folder;
};

TEST_F(OntologyLoaderTest, GivesNoneForNoFiles) {
  const Result result = load("exit 1", {});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->ontology, nullptr);
}

TEST_F(OntologyLoaderTest, PassesFilesAndOutputAndShowsWhatTheCompilerSays) {
  const Result result = load(
      R"(echo "geminga-ontology: $1 $2 $3 $4 $5" >&2; echo "zoo.ttl:7: a second line" >&2; exit 1)", {"/a.ttl", "-b"});
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error(),
              ElementsAre("compile -o - /a.ttl " + fs::absolute("-b").string(), "zoo.ttl:7: a second line"));
}

TEST_F(OntologyLoaderTest, HandsConfiguredPrefixesOver) {
  const Result result = load(R"(echo "$2 $3" >&2; echo "$4 $5" >&2; exit 1)", {"a.ttl"},
                             {{"zoo", "http://zoo.example/#"}, {"b", "urn:b:"}});
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error(), ElementsAre("--prefix b=urn:b:", "--prefix zoo=http://zoo.example/#"));
}

TEST_F(OntologyLoaderTest, SaysHowASilentCompilerEnded) {
  EXPECT_THAT(load("exit 3", {"a.ttl"}).error(), ElementsAre(testing::EndsWith("/compiler: exit status 3")));
  EXPECT_THAT(load("echo half a word >&2; kill -11 $$", {"a.ttl"}).error(),
              ElementsAre("half a word", testing::EndsWith("/compiler: killed by signal 11")));
}

TEST_F(OntologyLoaderTest, RefusesWhatIsNoCompiledOntology) {
  const Result random = load("exec head -c 4096 /dev/urandom", {"a.ttl"});
  ASSERT_FALSE(random);
  EXPECT_THAT(random.error(), ElementsAre(testing::StartsWith("the compiled ontology: ")));
  const Result nothing = load("exit 0", {"a.ttl"});
  ASSERT_FALSE(nothing);
  EXPECT_THAT(nothing.error(), ElementsAre(testing::StartsWith("the compiled ontology: ")));
  const Result given = load("exit 0", {(folder / "none.geminga").string()});
  ASSERT_FALSE(given);
  EXPECT_THAT(given.error(), ElementsAre(HasSubstr("none.geminga: ")));
}

TEST_F(OntologyLoaderTest, BoundsTheSearchOfTheCompiler) {
  const Result result = load(R"(shift 4; echo "$*" >&2; exit 1)", {"/a.ttl"});
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error(), ElementsAre("--time-limit 30 --steps 200000000"));
}

TEST_F(OntologyLoaderTest, UsesWhatIsSettledWhereTheCompilerReachedItsLimit) {
  owl::Ontology source;
  (void)source.add_file("a.ttl");
  const std::vector<std::byte> bytes = compiled::compile(source, el::classify(source).value());
  const std::string path = folder / "settled";
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  const Result settled = load("exec perl -e '$/ = undef; open(my $file, \"<\", \"" + path +
                                  R"(") or die; print <$file>; warn "a limit\n"; exit 4')",
                              {"a.ttl"});
  ASSERT_TRUE(settled) << testing::PrintToString(settled.error());
  EXPECT_NE(settled->ontology, nullptr);
  EXPECT_THAT(settled->remarks, ElementsAre("a limit"));
  const Result nothing = load("echo a limit >&2; exit 4", {"a.ttl"});
  ASSERT_FALSE(nothing) << "the limit came before anything was written";
  EXPECT_THAT(nothing.error(), ElementsAre("a limit"));
}

TEST_F(OntologyLoaderTest, TellsLeftOutFilesFromOtherRemarks) {
  owl::Ontology source;
  (void)source.add_file("a.ttl");
  const std::vector<std::byte> bytes = compiled::compile(source, el::classify(source).value());
  const std::string path = folder / "settled";
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  const Result loaded =
      load("echo a remark >&2; echo 'geminga-ontology: left out: b.ttl: is broken' >&2; exec cat " + path, {"/folder"});
  ASSERT_TRUE(loaded) << testing::PrintToString(loaded.error());
  EXPECT_THAT(loaded->remarks, ElementsAre("a remark"));
  EXPECT_THAT(loaded->left_out, ElementsAre("left out: b.ttl: is broken"));
}

TEST_F(OntologyLoaderTest, RefusesACompiledOntologyThatIsOlderThanItsSources) {
  const std::string source_path = folder / "a.ttl";
  const std::string compiled_path = folder / "a.geminga";
  const auto say = [&](const std::string& words) { std::ofstream(source_path) << words; };
  say("# one");
  owl::Ontology source;
  source.set_content(source.add_file(source_path), owl::fingerprint_of("# one"));
  const std::vector<std::byte> bytes = compiled::compile(source, el::classify(source).value());
  std::ofstream(compiled_path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  EXPECT_TRUE(load("exit 0", {compiled_path}));
  say("# two");
  const Result outgrown = load("exit 0", {compiled_path});
  ASSERT_FALSE(outgrown);
  EXPECT_THAT(outgrown.error(),
              ElementsAre(testing::AllOf(HasSubstr("a.geminga is refused: "), HasSubstr("a.ttl has changed"),
                                         HasSubstr("compile it again"))));
  fs::remove(source_path);
  EXPECT_TRUE(load("exit 0", {compiled_path})) << "sources that stayed at home are not asked for";
}

TEST_F(OntologyLoaderTest, VerifiesAllOfACompiledOntologyOnlyWhereOneIsInForce) {
  const std::string path = folder / "a.geminga";
  owl::Ontology source;
  (void)source.add_file("a.ttl");
  std::vector<std::byte> bytes = compiled::compile(source, el::classify(source).value());
  const auto write = [&] {
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  };
  bytes.back() ^= std::byte{1};  // in the axioms
  write();
  boost::asio::io_context context;
  OntologyLoader loader(context, compiler("exit 0"));
  std::vector<Result> results;
  const auto load_once = [&] {
    context.restart();
    loader.load({path}, {}, [&](Result result) { results.push_back(std::move(result)); });
    context.run();
  };
  load_once();
  load_once();
  bytes.back() ^= std::byte{1};
  fs::remove(path);  // a mapped file is never written to
  write();
  load_once();
  ASSERT_EQ(results.size(), 3U);
  ASSERT_TRUE(results[0]) << "matching needs no axioms";
  EXPECT_FALSE(results[0]->ontology->check_axioms());
  ASSERT_FALSE(results[1]);
  EXPECT_THAT(results[1].error(), ElementsAre(testing::AllOf(HasSubstr("a.geminga: "), HasSubstr("of the axioms"))));
  EXPECT_TRUE(results[2]);
}

TEST_F(OntologyLoaderTest, VerifiesACompiledOntologyOnAThreadWhileTheEventLoopServes) {
  const std::string path = folder / "a.geminga";
  owl::Ontology source;
  (void)source.add_file("a.ttl");
  const std::vector<std::byte> bytes = compiled::compile(source, el::classify(source).value());
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  boost::asio::io_context context;
  OntologyLoader loader(context, compiler("exit 0"));
  int results = 0;
  loader.load({path}, {}, [&](const Result& result) { results += result ? 1 : 0; });
  EXPECT_TRUE(loader.is_at_work());
  loader.load({path}, {}, [&](const Result& result) { results += result ? 10 : 0; });
  EXPECT_EQ(results, 0);
  context.run();
  EXPECT_EQ(results, 10) << "the one that was given up brings nothing";
  EXPECT_FALSE(loader.is_at_work());
}

TEST_F(OntologyLoaderTest, KnowsTheSourcesOfACompiledOntologyFromItsOwnFolder) {
  const fs::path team = folder / "team";
  fs::create_directories(team);
  std::ofstream(team / "a.ttl") << "# one";
  owl::Ontology source;
  source.set_content(source.add_file((team / "a.ttl").string()), owl::fingerprint_of("# one"));
  const std::vector<std::byte> bytes = compiled::compile(source, el::classify(source).value(),
                                                         {.gaps = {}, .folder = owl::folder_of(folder / "a.geminga")});
  std::ofstream(folder / "a.geminga", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  const fs::path moved = folder / "moved";
  fs::create_directories(moved);
  fs::rename(team, moved / "team");
  fs::rename(folder / "a.geminga", moved / "a.geminga");
  EXPECT_TRUE(load("exit 0", {(moved / "a.geminga").string()}));
  std::ofstream(moved / "team" / "a.ttl") << "# two";
  const Result outgrown = load("exit 0", {(moved / "a.geminga").string()});
  ASSERT_FALSE(outgrown);
  EXPECT_THAT(outgrown.error(), ElementsAre(HasSubstr("moved/team/a.ttl has changed")));
}

TEST_F(OntologyLoaderTest, TakesWhatTheCompilerWritesWithoutAFolderForTemporaryFiles) {
  owl::Ontology source;
  (void)source.add_file("a.ttl");
  const std::vector<std::byte> bytes = compiled::compile(source, el::classify(source).value());
  const fs::path compiled = folder / "a.geminga";
  std::ofstream(compiled, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  ::setenv("TMPDIR", "/no/such/folder", 1);
  EXPECT_TRUE(load("exec cat '" + compiled.string() + "'", {"a.ttl"}));
  EXPECT_TRUE(load("exit 1", {compiled.string()}));
}

TEST_F(OntologyLoaderTest, BoundsTheLinesItShows) {
  const Result result =
      load("i=0; while [ $i -lt 1000 ]; do echo a line that is repeated >&2; i=$((i + 1)); done; exit 1", {"a.ttl"});
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error(), SizeIs(40));
}

TEST_F(OntologyLoaderTest, GivesUpALoadForALaterOne) {
  boost::asio::io_context context;
  OntologyLoader loader(context, compiler("exec sleep 1000"));
  bool was_first_called = false;
  bool was_second_called = false;
  loader.load({"a.ttl"}, {}, [&](const Result&) { was_first_called = true; });
  EXPECT_TRUE(loader.is_loading());
  loader.load({}, {}, [&](const Result&) { was_second_called = true; });
  context.run();
  EXPECT_FALSE(was_first_called);
  EXPECT_TRUE(was_second_called);
  EXPECT_TRUE(fs::is_empty(folder / "tmp"));
}

}  // namespace
}  // namespace geminga::daemon
