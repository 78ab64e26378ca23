// The dissector in a real tshark shows what our own decoder reads, and refuses what that cannot read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "discovery/announcement/announcements.hpp"
#include "discovery/announcement/codec.hpp"
#include "support/process.hpp"
#include "support/rounds.hpp"
#include "tools/wireshark/capture.hpp"

namespace geminga::tools {
namespace {

namespace fs = std::filesystem;
using announcement::Announcement;
using testing::HasSubstr;
using testing::Not;

/// A row of tshark: the values of each field, several with commas.
using Row = std::map<std::string, std::string>;

const std::vector<std::string> shown_fields{"participant",
                                            "boot",
                                            "link",
                                            "sequence",
                                            "interval_ms",
                                            "revision",
                                            "part",
                                            "ontology_digest",
                                            "publication.number",
                                            "publication.port",
                                            "publication.priority",
                                            "subscription.number",
                                            "subscription.limit",
                                            "peer.id",
                                            "attribute.key",
                                            "malformed",
                                            "sealed.state",
                                            "closed"};

std::string in_hexadecimal(std::uint64_t number, int digits) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "0x%0*" PRIx64, digits, number);
  return text.data();
}

/// The row that tshark must show of a decoded announcement: fields whose value is the default are not on the air.
Row row_of(const Announcement& read) {
  Row row;
  const auto add = [&](const std::string& key, const std::string& value) {
    std::string& values = row[key];
    values += (values.empty() ? "" : ",") + value;
  };
  for (const auto& peer : read.peers) {
    add("peer.id", std::to_string(std::to_underlying(peer.id)));
    for (const auto& one : peer.publications) {
      add("publication.number", std::to_string(one.number));
      add("publication.port", std::to_string(one.publication.port));
      if (one.publication.priority != 0) add("publication.priority", std::to_string(one.publication.priority));
    }
    for (const auto& one : peer.subscriptions) {
      add("subscription.number", std::to_string(one.number));
      if (one.subscription.limit != 0) add("subscription.limit", std::to_string(one.subscription.limit));
    }
  }
  row["participant"] = in_hexadecimal(std::to_underlying(read.participant), 8);
  row["boot"] = in_hexadecimal(std::to_underlying(read.boot), 16);
  row["sequence"] = std::to_string(read.sequence);
  row["revision"] = std::to_string(read.revision);
  row["link"] = std::to_string(read.link);
  for (const char* key : {"sequence", "revision", "link"}) {
    if (row[key] == "0") row.erase(key);
  }
  return row;
}

std::vector<std::string> parts(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) all.push_back(part);
  return all;
}

/// Whether what stands between the commas of `some` stands between those of `all` in this order, beside others.
bool stand_in_order(const std::string& some, const std::string& all) {
  const std::vector<std::string> wanted = parts(some);
  auto next = wanted.begin();
  for (const std::string& part : parts(all)) {
    if (next != wanted.end() && part == *next) ++next;
  }
  return next == wanted.end();
}

class Dissector : public WithKeys {
 protected:
  void SetUp() override {
    if (!fs::exists("/usr/bin/tshark")) GTEST_SKIP() << "tshark is not installed";
    if (!fs::exists(lua_)) GTEST_SKIP() << "the dissector was not built for this machine";
  }

  /// The output of tshark for the datagrams, with these flags.
  std::string tshark(const std::vector<Datagram>& datagrams, std::vector<std::string> flags) {
    write_capture(folder_ / "capture.pcap", datagrams);
    std::vector<std::string> words{"/usr/bin/tshark",
                                   "-n",
                                   "-r",
                                   folder_ / "capture.pcap",
                                   "-X",
                                   "lua_script:" + lua_.string(),
                                   "-o",
                                   "geminga.unseal:" + system::program("geminga-unseal")};
    words.insert(words.end(), flags.begin(), flags.end());
    const auto ran = system::run(
        {.words = std::move(words), .environment = {{"HOME", folder_}, {"LC_ALL", "C.UTF-8"}}, .before = {}});
    EXPECT_EQ(ran.status, 0) << ran.said;
    EXPECT_THAT(ran.said, Not(HasSubstr("Lua Error"))) << "of the dissector itself";
    EXPECT_THAT(ran.said, Not(HasSubstr("Lua:")));
    return ran.said;
  }

  std::vector<Row> rows(const std::vector<Datagram>& datagrams, const std::string& key_files = {}) {
    std::vector<std::string> flags{"-o", "geminga.key_file:" + key_files,
                                   "-T", "fields",
                                   "-E", "separator=/t",
                                   "-E", "occurrence=a",
                                   "-E", "aggregator=,",
                                   "-e", "frame.number"};
    for (const std::string& field : shown_fields) flags.insert(flags.end(), {"-e", "geminga." + field});
    std::istringstream lines(tshark(datagrams, std::move(flags)));
    std::vector<Row> read;
    for (std::string line; std::getline(lines, line);) {
      if (line.empty() || line.front() < '0' || line.front() > '9') continue;  // of tshark itself, e.g. to root
      std::istringstream cells(line);
      std::string cell;
      std::getline(cells, cell, '\t');
      Row row;
      for (const std::string& field : shown_fields) {
        if (!std::getline(cells, cell, '\t')) cell.clear();
        if (!cell.empty()) row[field] = cell;
      }
      read.push_back(std::move(row));
    }
    EXPECT_EQ(read.size(), datagrams.size());
    read.resize(datagrams.size());
    return read;
  }

  /// Expects that the row says what our decoder reads of the announcement; nothing of the header but the participant
  /// where it is a presence or change, which leave out what the state says. A field that a hostile sender states twice,
  /// of which the decoder takes the last, is shown twice.
  static void expect_as_decoded(const Row& row, const Datagram& announcement, bool is_hostile = false) {
    const auto read = announcement::decode(announcement);
    if (!read) {
      using announcement::DecodeError;
      const bool is_unreadable = read.error() == DecodeError::not_protobuf ||
                                 read.error() == DecodeError::not_geminga || read.error() == DecodeError::other_version;
      EXPECT_EQ(row.contains("malformed"), is_unreadable)
          << to_string(read.error()) << ' ' << hexadecimal(announcement);
      return;
    }
    EXPECT_FALSE(row.contains("malformed")) << hexadecimal(announcement);
    for (const auto& [key, value] : row_of(*read)) {
      const auto found = row.find(key);
      const std::string shown = found == row.end() ? "" : found->second;
      if (is_hostile) {
        EXPECT_TRUE(stand_in_order(value, shown))
            << key << ": " << value << " in " << shown << ' ' << hexadecimal(announcement);
      } else {
        EXPECT_EQ(shown, value) << key << ' ' << hexadecimal(announcement);
      }
    }
  }

  fs::path lua_ = GEMINGA_BINARY_DIR "/wireshark/geminga.lua";
};

std::vector<Datagram> random_datagrams(base::Random& random, std::size_t count) {
  std::vector<Datagram> datagrams;
  while (datagrams.size() < count) {
    const auto kind = random.below(3);
    const Announcement one = kind == 0   ? announcement::random_presence(random)
                             : kind == 1 ? announcement::random_change(random)
                                         : announcement::random_announcement(random);
    for (Datagram& datagram : announcement::encode(one)) datagrams.push_back(std::move(datagram));
  }
  return datagrams;
}

TEST_F(Dissector, ShowsWhatOurDecoderReads) {
  base::Random random(11);
  const auto datagrams = random_datagrams(random, 200);
  const auto read = rows(datagrams);
  for (std::size_t i = 0; i < datagrams.size(); ++i) expect_as_decoded(read[i], datagrams[i]);
}

TEST_F(Dissector, RefusesWhatOurDecoderCannotReadAndNothingElse) {
  const std::uint64_t seed = 23;
  base::Random random(seed);
  std::vector<Datagram> hostile;
  for (Datagram& datagram : random_datagrams(random, 40)) {
    for (int copy = 0; copy < 20; ++copy) {
      Datagram changed = datagram;
      if (random.below(3) == 0) changed.resize(1 + random.below(static_cast<std::uint32_t>(changed.size())));
      for (auto count = random.below(4); count > 0; --count) {
        changed[random.below(static_cast<std::uint32_t>(changed.size()))] = static_cast<std::byte>(random.below(256));
      }
      if (changed.front() != std::byte{0x47}) hostile.push_back(std::move(changed));
    }
  }
  const auto read = rows(hostile);
  for (std::size_t i = 0; i < hostile.size(); ++i) expect_as_decoded(read[i], hostile[i], true);
  if (HasFailure()) ADD_FAILURE() << "seed " << seed;
}

TEST_F(Dissector, OpensWhatIsSealedWithTheKeyFilesOfItsPreference) {
  base::Random random(31);
  const auto plain = random_datagrams(random, 12);
  std::vector<Datagram> datagrams;
  const std::vector<std::string> modes{"closed",        "open",         "closed greeting",
                                       "open greeting", "closed small", "closed small greeting"};
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const std::string& mode = modes[i % modes.size()];
    const auto room = mode.contains("greeting") ? 1100U : 1200U;
    if (plain[i].size() > room) continue;
    datagrams.push_back(sealed(keys_[i % 2], plain[i], mode, static_cast<std::uint32_t>(i)));
  }
  const auto closed = rows(datagrams);
  const auto one = rows(datagrams, key_file_);
  const auto both = rows(datagrams, key_file_.string() + ':' + other_file_.string());
  std::size_t at = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const std::string& mode = modes[i % modes.size()];
    if (plain[i].size() > (mode.contains("greeting") ? 1100U : 1200U)) continue;
    EXPECT_EQ(closed[at].at("sealed.state"), "closed");
    EXPECT_EQ(closed[at].contains("closed"), !mode.starts_with("open")) << "what is only authenticated needs no key";
    EXPECT_EQ(one[at].at("sealed.state"), i % 2 == 0 ? "opened" : "unknown-key");
    EXPECT_EQ(both[at].at("sealed.state"), "opened");
    expect_as_decoded(both[at], plain[i]);
    if (mode.starts_with("open")) expect_as_decoded(closed[at], plain[i]);
    ++at;
  }
}

TEST_F(Dissector, SaysWhatIsForgedOrCutOrNoEnvelopeAtAll) {
  const Datagram announcement = announcement::encode(announcement::worked_example()).front();
  const Datagram good = sealed(keys_[0], announcement, "open", 1);
  Datagram changed = good;
  changed[20] ^= std::byte{1};
  std::vector<Datagram> datagrams{good,
                                  changed,
                                  Datagram(1, std::byte{0x47}),
                                  Datagram(31, std::byte{0x47}),
                                  Datagram(good.begin(), good.begin() + 40),
                                  Datagram(1300, std::byte{0x47})};
  Datagram greeting(64, std::byte{0xff});
  greeting[0] = std::byte{0x47};
  greeting[1] = std::byte{0x12};
  datagrams.push_back(greeting);
  const auto read = rows(datagrams, key_file_);
  EXPECT_EQ(read[0].at("sealed.state"), "opened");
  EXPECT_EQ(read[1].at("sealed.state"), "forged");
  EXPECT_FALSE(read[1].contains("participant")) << "nothing that is forged is shown";
  EXPECT_TRUE(read[2].contains("malformed"));
  EXPECT_TRUE(read[3].contains("malformed"));
  EXPECT_EQ(read[4].at("sealed.state"), "forged");
  EXPECT_TRUE(read[6].contains("closed"));
}

TEST_F(Dissector, SummarisesAnAnnouncementAndNamesItsConcepts) {
  const auto shown = tshark(announcement::encode(announcement::worked_example()), {"-V"});
  EXPECT_THAT(shown, HasSubstr("Geminga announcement"));
  EXPECT_THAT(shown, HasSubstr("kind: KIND_STATE (1)"));
  EXPECT_THAT(shown, HasSubstr("[IRI: http"));
  EXPECT_THAT(tshark(announcement::encode(announcement::worked_example()), {}), HasSubstr("Geminga"));
}

TEST_F(Dissector, RunsNothingThatStandsInItsPreferences) {
  const fs::path trap = folder_ / "trap";
  const auto datagram = sealed(keys_[0], announcement::encode(announcement::worked_example()).front(), "closed", 1);
  for (const std::string& file :
       {"$(touch " + trap.string() + ")", "'; touch " + trap.string() + "; '", std::string("`touch trap`")}) {
    auto read = rows({datagram}, file);
    EXPECT_NE(read[0]["sealed.state"], "opened");
  }
  EXPECT_FALSE(fs::exists(trap));
}

}  // namespace
}  // namespace geminga::tools
