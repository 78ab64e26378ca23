// geminga-unseal opens what the team has sealed, and nothing else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "discovery/announcement/announcements.hpp"
#include "support/process.hpp"
#include "tools/wireshark/capture.hpp"

namespace geminga::tools {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Unseal : public WithKeys {
 protected:
  [[nodiscard]] system::Ran unseal(std::vector<std::string> words, const std::string& input = "/dev/null") const {
    std::string line = "exec '" + system::program("geminga-unseal") + "' \"$@\" <'" + input + '\'';
    words.insert(words.begin(), {"/bin/sh", "-c", line, "unseal"});
    return system::run({.words = std::move(words), .environment = {}, .before = {}});
  }
  [[nodiscard]] std::string with(const std::filesystem::path& file) const { return "--key-file=" + file.string(); }

  Datagram announcement_ = announcement::encode(announcement::worked_example()).front();
};

TEST_F(Unseal, OpensWhatTheTeamHasSealedInEveryWay) {
  for (const char* mode :
       {"closed", "open", "closed greeting", "open greeting", "closed small", "closed small greeting"}) {
    const auto ran = unseal({with(key_file_), hexadecimal(sealed(keys_[0], announcement_, mode, 3))});
    EXPECT_EQ(ran.status, 0) << mode;
    EXPECT_THAT(ran.said, StartsWith(std::string_view(mode).starts_with("open") ? "opened authenticated 6208 "
                                                                                : "opened encrypted 6208 "));
    EXPECT_THAT(ran.said, testing::EndsWith(' ' + hexadecimal(announcement_) + '\n')) << mode;
    EXPECT_EQ(ran.said.contains(" - "), !std::string_view(mode).contains("greeting")) << mode;
  }
}

TEST_F(Unseal, ReadsLinesAndSaysWhyOneIsNotOpened) {
  const Datagram good = sealed(keys_[0], announcement_, "closed", 3);
  Datagram changed = good;
  changed[20] ^= std::byte{1};
  Datagram newer = good;
  newer[1] = std::byte{0x21};
  const std::filesystem::path lines = folder_ / "lines";
  std::ofstream(lines) << hexadecimal(good) << "\n"
                       << hexadecimal(changed) << "\r\n"
                       << hexadecimal(sealed(keys_[1], announcement_, "closed", 4)) << '\n'
                       << hexadecimal(newer) << "\n47:11:62\n0d474d4e01\n"
                       << hexadecimal(Datagram(1300, std::byte{0x47}));
  const auto one = unseal({with(key_file_)}, lines);
  EXPECT_EQ(one.status, 1);
  EXPECT_THAT(one.said,
              testing::MatchesRegex("opened encrypted 6208 - [0-9a-f]+\nrejected forged\nrejected unknown-key\n"
                                    "rejected other-version\nrejected too-short\nplain\nrejected too-large\n"));
  const auto both = unseal({with(key_file_), with(other_file_), "--json"}, lines);
  EXPECT_THAT(both.said, HasSubstr("{\"result\":\"rejected\",\"reason\":\"forged\"}\n{\"result\":\"opened\""));
}

TEST_F(Unseal, ComplainsOfWhatIsNoDatagramAndOfFilesThatAreNoKey) {
  EXPECT_EQ(unseal({with(key_file_), "4g"}).status, 2);
  EXPECT_EQ(unseal({with(key_file_), "471"}).status, 2);
  EXPECT_EQ(unseal({with(folder_ / "nowhere"), "47"}).status, 2);
  EXPECT_EQ(unseal({with("/dev/zero"), "47"}).status, 2);
  EXPECT_EQ(unseal({"47"}).status, 2);
  const std::filesystem::path lines = folder_ / "lines";
  std::ofstream(lines) << std::string(3 * 65'535 + 1, '4') << "\n0d\n" << std::string(3 * 65'535 - 1, '0') << "\n0d\n";
  const auto ran = unseal({with(key_file_)}, lines);
  EXPECT_EQ(ran.status, 2);
  EXPECT_THAT(ran.said, HasSubstr("is no datagram"));
  EXPECT_THAT(ran.said, testing::EndsWith("plain\n")) << "what follows is read";
  std::ofstream(folder_ / "broken.key") << "key 6208 AAEC\n";
  const auto broken = unseal({with(folder_ / "broken.key"), "47"});
  EXPECT_EQ(broken.status, 2);
  EXPECT_THAT(broken.said, Not(HasSubstr("AAEC"))) << "no part of a key is shown";
}

}  // namespace
}  // namespace geminga::tools
