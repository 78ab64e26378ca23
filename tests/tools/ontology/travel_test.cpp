// Ontologies that travel: what is said, what is believed of strangers, whom pieces are sent to, and how it is written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "base/numbered_folders.hpp"
#include "ontology/travel/arrival.hpp"
#include "ontology/travel/delivery.hpp"
#include "ontology/travel/digest.hpp"
#include "ontology/travel/folder.hpp"
#include "ontology/travel/parcel.hpp"
#include "ontology/travel/taking.hpp"
#include "tools/ontology/program.hpp"

namespace geminga::ontology {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Files = std::map<std::string, std::string>;

/// Octets that zlib cannot shorten much and that differ from piece to piece.
std::string noise(std::size_t octets) {
  std::string text(octets, '\0');
  std::uint32_t state = 1;
  for (char& octet : text) {
    state = state * 1664525U + 1013904223U;
    octet = static_cast<char>(state >> 24U);
  }
  return text;
}

Parcel parcel_of(const Files& files, std::uint64_t version = 1) {
  auto parcel = Parcel::pack(files, version);
  EXPECT_TRUE(parcel) << parcel.error();
  return std::move(*parcel);
}

std::string fault_of(const Files& files) {
  const auto parcel = Parcel::pack(files, 1);
  return parcel ? "" : parcel.error();
}

TEST(Digest, IsBlake2b256) {
  // RFC 7693 with an output of 32 octets: `b2sum -l 256` prints the same.
  EXPECT_EQ(blake2b("abc"), "bddd813c634239723171ef3fee98579b94964e3bb1cb3e427262c8c068d52319");
  EXPECT_TRUE(is_blake2b(blake2b("")));
  EXPECT_FALSE(is_blake2b(std::string(63, 'a')));
  EXPECT_FALSE(is_blake2b(std::string(64, 'A')));
}

TEST(NamesOfFiles, AreNoPathsHideNothingAndObeyNobody) {
  for (const char* good : {"team.ttl", "a b.owl", "größe.omn", "packed.ttl.gz", "a..ttl"})
    EXPECT_FALSE(fault_of_name(good)) << good;
  for (const char* bad : {"", ".", "..", "../a.ttl", "/etc/a.ttl", "a/b.ttl", "a\\b.ttl", ".a.ttl", ".ttl", "a.ttl\n",
                          "a\x1b[2J.ttl", "a\xff.ttl", "a\u202e.ttl", "a\u0085.ttl", "catalog-v001.sh", "a.gz", "ttl"})
    EXPECT_TRUE(fault_of_name(bad)) << bad;
  EXPECT_FALSE(fault_of_name(std::string(max_travelling_name - 4, 'a') + ".ttl"));
  EXPECT_TRUE(fault_of_name(std::string(max_travelling_name - 3, 'a') + ".ttl"));
  EXPECT_TRUE(fault_of_name(std::string_view("a\0.ttl", 6)));
}

TEST(Manifest, SaysOneThingInOneWay) {
  const Parcel parcel = parcel_of({{"a.ttl", "one"}, {"b.ttl", noise(piece_octets)}}, 7);
  const std::string text = parcel.manifest().text();
  EXPECT_EQ(Manifest::read(text), parcel.manifest());
  EXPECT_EQ(parcel.manifest().pieces.size(), 2U);
  EXPECT_EQ(parcel.manifest().octets_of(0), piece_octets);
  EXPECT_EQ(parcel.manifest().octets_of(1), 3U);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    other.replace(other.find(from), from.size(), to);
    return Manifest::read(other).has_value();
  };
  EXPECT_TRUE(changed("version 7", "version 8"));
  EXPECT_FALSE(changed("version 7", "version 07"));
  EXPECT_FALSE(changed("version 7", "version -7"));
  EXPECT_FALSE(changed("version 7", "version 9007199254740992"));
  EXPECT_TRUE(changed("version 7", "version 9007199254740991"));
  EXPECT_FALSE(changed("file 3 a.ttl", "file 3 c.ttl")) << "not in order";
  EXPECT_FALSE(changed("file 3 a.ttl", "file 3 b.ttl")) << "twice";
  EXPECT_FALSE(changed("file 3 a.ttl", "file 3 ../a.ttl"));
  EXPECT_FALSE(changed("file 3 a.ttl", "file 18446744073709551615 a.ttl"));
  EXPECT_FALSE(changed("file 3 a.ttl\n", "file 0 a.ttl\n")) << "one piece too many";
  EXPECT_FALSE(changed("piece ", "piece  "));
  EXPECT_FALSE(changed("geminga-ontology 1", "geminga-ontology 2"));
  EXPECT_FALSE(Manifest::read(text + "\n"));
  EXPECT_FALSE(Manifest::read(text.substr(0, text.size() - 1)));
  EXPECT_FALSE(Manifest::read(""));
  EXPECT_FALSE(Manifest::read(std::string(max_manifest_octets + 1, 'x')));
}

TEST(Manifest, HasSoManyFilesAndOctetsAndNoMore) {
  Files files;
  for (std::size_t number = 1000; files.size() < max_travelling_files - 1; ++number)
    files[std::to_string(number) + ".ttl"] = "";
  EXPECT_EQ(fault_of(files), "");
  files["last.ttl"] = "";
  EXPECT_EQ(fault_of(files), "");
  files["more.ttl"] = "";
  EXPECT_THAT(fault_of(files), HasSubstr("too many files"));
  EXPECT_THAT(fault_of({}), HasSubstr("no files"));
  const auto of_octets = [](std::size_t octets) {
    Manifest manifest{.version = 1, .files = {{"a.ttl", octets}}, .pieces = {}};
    manifest.pieces.assign(piece_count(octets), blake2b(""));
    return Manifest::read(manifest.text()).has_value();
  };
  EXPECT_TRUE(of_octets(max_travelling_octets - 1));
  EXPECT_TRUE(of_octets(max_travelling_octets));
  EXPECT_FALSE(of_octets(max_travelling_octets + 1));
}

TEST(ReadFiles, RefuseEqualNames) {
  const Program program;
  program.write("a.ttl", "1");
  fs::create_directory(program.folder() / "in" / "below");
  program.write("below/a.ttl", "2");
  const auto path = [&](const char* name) { return (program.folder() / "in" / name).string(); };
  const std::vector<std::string> same{path("a.ttl"), path("a.ttl")};
  EXPECT_EQ(read_files(same).value(), (Files{{"a.ttl", "1"}}));
  const std::vector<std::string> both{path("a.ttl"), path("below/a.ttl")};
  EXPECT_THAT(read_files(both).error(), HasSubstr("two files have the name a.ttl"));
  const std::vector<std::string> none{path("b.ttl")};
  EXPECT_FALSE(read_files(none));
}

TEST(Arrival, IsWholeWhenEveryPieceHasComeInWhateverOrderAndFromWhomever) {
  const Parcel parcel = parcel_of({{"a.ttl", noise(2 * piece_octets + 1)}, {"b.ttl", "the end"}});
  Arrival arrival(parcel.digest());
  EXPECT_FALSE(arrival.take(parcel.pieces()[1]).value()) << "a piece before the manifest says nothing";
  EXPECT_TRUE(arrival.take(parcel.manifest_message()).value());
  EXPECT_TRUE(arrival.take(parcel.pieces()[2]).value());
  EXPECT_FALSE(arrival.take(parcel.pieces()[2]).value());
  arrival.begin_provider();
  EXPECT_TRUE(arrival.take(parcel.pieces()[0]).value());
  EXPECT_FALSE(arrival.is_whole());
  EXPECT_TRUE(arrival.take(parcel.pieces()[1]).value());
  EXPECT_TRUE(arrival.is_whole());
  EXPECT_EQ(arrival.content(), noise(2 * piece_octets + 1) + "the end");
}

TEST(Arrival, OfEmptyFilesIsWholeWithTheManifest) {
  const Parcel parcel = parcel_of({{"a.ttl", ""}});
  Arrival arrival(parcel.digest());
  EXPECT_TRUE(arrival.take(parcel.manifest_message()).value());
  EXPECT_TRUE(arrival.is_whole());
}

TEST(Arrival, BelievesNoLiarAndKeepsWhatOthersBrought) {
  const Parcel parcel = parcel_of({{"a.ttl", noise(piece_octets + 9)}});
  const Parcel other = parcel_of({{"a.ttl", std::string(piece_octets + 9, 'x')}});
  Arrival arrival(parcel.digest());
  EXPECT_THAT(arrival.take(other.manifest_message()).error(), HasSubstr("another ontology"));
  EXPECT_TRUE(arrival.take(parcel.manifest_message()).value());
  EXPECT_TRUE(arrival.take(parcel.pieces()[0]).value());
  EXPECT_THAT(arrival.take(other.pieces()[1]).error(), HasSubstr("not the one"));
  EXPECT_THAT(arrival.take("hello").error(), HasSubstr("no part of an ontology"));
  EXPECT_FALSE(arrival.take(""));
  EXPECT_FALSE(arrival.take(piece_mark));
  std::string far = parcel.pieces()[1];
  far[5] = '\x7f';
  EXPECT_THAT(arrival.take(far).error(), HasSubstr("does not have"));
  std::string cut = parcel.pieces()[1];
  cut.pop_back();
  EXPECT_FALSE(arrival.take(cut));
  EXPECT_FALSE(arrival.take(parcel.pieces()[1] + "x")) << "octets behind the piece";
  std::string bomb =
      parcel.pieces()[1].substr(0, 8) + parcel_of({{"a.ttl", std::string(1U << 20U, '0')}}).pieces()[0].substr(8);
  EXPECT_FALSE(arrival.take(bomb)) << "more octets than the piece has";
  EXPECT_FALSE(arrival.take(std::string(max_travelling_message + 1, 'G')));
  EXPECT_EQ(arrival.arrived_pieces(), 1U);
  EXPECT_TRUE(arrival.take(parcel.pieces()[1]).value());
  EXPECT_TRUE(arrival.is_whole());
}

TEST(Arrival, GivesUpAProviderThatFloods) {
  const Parcel parcel = parcel_of({{"a.ttl", noise(piece_octets)}, {"b.ttl", "x"}});
  Arrival arrival(parcel.digest());
  ASSERT_TRUE(arrival.take(parcel.manifest_message()));
  std::size_t octets = 0;
  while (arrival.take(parcel.pieces()[0])) {
    octets += parcel.pieces()[0].size();
    ASSERT_LT(octets, 10 * (max_useless_octets + max_useless_rounds * max_manifest_octets));
  }
  EXPECT_GE(octets, max_useless_rounds * parcel.manifest().octets());
  arrival.begin_provider();
  EXPECT_TRUE(arrival.take(parcel.pieces()[0]));
}

/// The pieces that are sent until nobody lacks one; -1 is the manifest.
std::vector<int> sent(Delivery& delivery, std::size_t most = 100) {
  std::vector<int> numbers;
  while (numbers.size() < most) {
    const auto next = delivery.next();
    if (!next) break;
    numbers.push_back(next->piece ? static_cast<int>(*next->piece) : -1);
  }
  return numbers;
}

TEST(Delivery, SendsEachPieceOnceToThoseWhoCameTogether) {
  Delivery delivery(3);
  EXPECT_THAT(sent(delivery), IsEmpty());
  delivery.add(Life{1});
  delivery.add(Life{2});
  EXPECT_THAT(sent(delivery), ElementsAre(-1, 0, 1, 2));
}

TEST(Delivery, GoesOnRoundForWhoComesLater) {
  Delivery delivery(3);
  delivery.add(Life{1});
  EXPECT_THAT(sent(delivery, 2), ElementsAre(-1, 0));
  delivery.add(Life{2});
  EXPECT_THAT(sent(delivery), ElementsAre(-1, 1, 2, 0));
  delivery.add(Life{3});
  delivery.remove(Life{3});
  EXPECT_THAT(sent(delivery), ElementsAre(-1));
}

TEST(Delivery, RepeatsForWhomSomethingWasLeftOutAndNotForEver) {
  Delivery delivery(2);
  delivery.add(Life{1});
  std::size_t messages = 0;
  while (delivery.next()) {
    delivery.note_left_out();
    ASSERT_LT(++messages, 1000U);
  }
  EXPECT_EQ(messages, 3U * max_laps);
  EXPECT_TRUE(delivery.is_repeating());
  delivery.remove(Life{1});
  delivery.add(Life{2});
  EXPECT_FALSE(delivery.is_repeating()) << "somebody waits for the first round";
  EXPECT_THAT(sent(delivery), ElementsAre(-1, 0, 1));
}

class Folder : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return (program_.folder() / "in" / name).string(); }
  [[nodiscard]] std::expected<Written, std::string> write(const std::string& name) const {
    return write_folder(path(name), manifest_, content_, 1);
  }
  /// The names in the folder of the test that begin with a dot.
  [[nodiscard]] std::size_t leftovers() const {
    std::size_t found = 0;
    for (const auto& entry : fs::directory_iterator(program_.folder() / "in"))
      found += entry.path().filename().string().starts_with('.') ? 1 : 0;
    return found;
  }

  Program program_;
  std::string content_ = "onetwo";
  Manifest manifest_{.version = 1, .files = {{"a.ttl", 3}, {"b.ttl", 3}}, .pieces = {blake2b(content_)}};
};

TEST_F(Folder, IsMadeWholeAndIsTheSameTheSecondTime) {
  EXPECT_EQ(write("new"), Written::made);
  EXPECT_EQ(program_.read("new/a.ttl"), "one");
  EXPECT_EQ(program_.read("new/b.ttl"), "two");
  EXPECT_EQ(write("new"), Written::was_there);
  EXPECT_EQ(leftovers(), 0U);
}

TEST_F(Folder, IsFilledWhereItIsEmpty) {
  fs::create_directory(path("empty"));
  EXPECT_EQ(write("empty"), Written::made);
}

TEST_F(Folder, IsNotOverwrittenWhereItHoldsSomethingElse) {
  ASSERT_EQ(write("other"), Written::made);
  program_.write("other/b.ttl", "tow");
  EXPECT_THAT(write("other").error(), HasSubstr("holds something else"));
  EXPECT_EQ(program_.read("other/b.ttl"), "tow");
  program_.write("other/b.ttl", "two");
  program_.write("other/c.ttl", "");
  EXPECT_FALSE(write("other")) << "a file more";
  program_.write("file", "x");
  EXPECT_FALSE(write("file"));
  EXPECT_FALSE(write("nowhere/below"));
  fs::create_symlink(path("gone"), path("link"));
  EXPECT_FALSE(write("link"));
  EXPECT_EQ(leftovers(), 0U);
}

TEST_F(Folder, RemovesWhatAWriterLeftThatWasCutOffLongAgo) {
  for (const char* name : {".new.1.part", ".new.2.part", ".newer.1.part"}) fs::create_directory(path(name));
  fs::last_write_time(path(".new.1.part"), fs::file_time_type::clock::now() - std::chrono::hours(2));
  EXPECT_EQ(write("new"), Written::made);
  EXPECT_FALSE(fs::exists(path(".new.1.part")));
  EXPECT_TRUE(fs::exists(path(".new.2.part"))) << "its writer may be at work";
  EXPECT_TRUE(fs::exists(path(".newer.1.part"))) << "of another folder";
}

TEST(RandomTags, Differ) { EXPECT_NE(random_tag(), random_tag()); }

TEST_F(Folder, OfVersionsKeepsTheNewestOnes) {
  fs::create_directory(path("base"));
  for (const char* name : {"base/2", "base/10", "base/9", "base/007", "base/x"}) ASSERT_EQ(write(name), Written::made);
  fs::create_directory_symlink(path("base/x"), path("base/11"));
  EXPECT_THAT(base::numbered_folders(path("base")), ElementsAre(2, 9, 10));
  keep_newest_versions(path("base"), 2, 1);
  EXPECT_THAT(base::numbered_folders(path("base")), ElementsAre(9, 10));
  EXPECT_TRUE(fs::exists(path("base/x")));
}

Candidate candidate(const std::string& service, const std::string& name, char digest, std::uint64_t version) {
  const auto slash = service.find('/');
  return {service, service.substr(0, slash), name, service.substr(slash + 1, 1), std::string(64, digest), version};
}

TEST(Candidates, AreThoseWithAReadableDigest) {
  Answer answer;
  const auto add = [&](const std::string& service, const std::string& protocol, const Attributes& attributes) {
    answer.records.push_back(
        {"match", {{"service", service}, {"participant_name", "base"}, {"protocol", protocol}}, attributes});
  };
  const std::string digest(64, 'a');
  add("00000002/1/1", "tcp", {{"digest", digest}, {"version", "1"}});
  add("00000001/1/1", "tcp", {{"digest", digest}, {"version", "12"}});
  add("00000003/1/1", "tcp", {{"digest", digest}});
  add("00000004/1/1", "udp", {{"digest", digest}, {"version", "1"}});
  add("00000005/1/1", "tcp", {{"digest", "../"}, {"version", "1"}});
  add("00000006/1/1", "tcp", {{"digest", digest}, {"version", "-1"}});
  add("00000007/1/1", "tcp", {{"digest", digest}, {"version", "9007199254740992"}});
  add("8", "tcp", {{"digest", digest}, {"version", "1"}});
  add("00000009/1/1", "tcp", {});
  EXPECT_THAT(candidates_in(answer),
              ElementsAre(candidate("00000001/1/1", "base", 'a', 12), candidate("00000002/1/1", "base", 'a', 1),
                          candidate("00000003/1/1", "base", 'a', 0)));
}

TEST(Candidates, OfAWishAreOfItsParticipantItsDigestAndNewer) {
  const std::vector<Candidate> all{
      candidate("00000001/1/1", "base", 'a', 3), candidate("00000002/1/1", "other", 'a', 3),
      candidate("00000001/2/1", "base", 'b', 2), candidate("00000003/1/1", "base", 'c', 1)};
  const auto of = [&](const Wish& wish) {
    std::string services;
    for (const Candidate& one : candidates_for(wish, all)) services += one.service.substr(7, 3) + ' ';
    return services;
  };
  EXPECT_EQ(of({}), "1/1 2/1 1/2 3/1 ");
  EXPECT_EQ(of({.participant = "base"}), "1/1 1/2 3/1 ");
  EXPECT_EQ(of({.participant = "00000002"}), "2/1 ");
  EXPECT_EQ(of({.digest = "bb"}), "1/2 ");
  EXPECT_EQ(of({.least_version = 2}), "1/1 2/1 1/2 ");
  EXPECT_EQ(of({.is_newest = true}), "1/1 2/1 ");
  EXPECT_EQ(of({.least_version = 4, .is_newest = true}), "");
}

}  // namespace
}  // namespace geminga::ontology
