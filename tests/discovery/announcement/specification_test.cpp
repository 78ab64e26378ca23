// The worked example of ANNOUNCEMENT.md against the codec.
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "discovery/announcement/announcements.hpp"

namespace geminga::announcement {
namespace {

/// The octets in the first column of the table under this title.
std::vector<std::byte> octets_in_specification(std::string_view title = "## Worked example") {
  std::ifstream file(GEMINGA_SOURCE_DIR "/src/discovery/announcement/ANNOUNCEMENT.md");
  std::string hex;
  bool is_example = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("## ")) is_example = line == title;
    if (!is_example || !line.starts_with("| `")) continue;
    hex += line.substr(3, line.find('`', 3) - 3);
  }
  return octets_of(hex);
}

TEST(AnnouncementSpecification, ItsWorkedExampleIsWhatEncodeWrites) {
  const auto datagrams = encode(worked_example());
  ASSERT_EQ(datagrams.size(), 1U);
  EXPECT_EQ(to_hex_text(datagrams.front()), to_hex_text(octets_in_specification()));
}

TEST(AnnouncementSpecification, ItsWorkedExampleIsWhatDecodeReads) {
  const auto decoded = decode(octets_in_specification());
  ASSERT_TRUE(decoded) << to_string(decoded.error());
  EXPECT_EQ(*decoded, worked_example());
}

TEST(AnnouncementSpecification, ItsWorkedDiagnosisIsWhatTheCodecWritesAndReads) {
  const auto octets = octets_in_specification("## Worked example of a diagnosis");
  EXPECT_EQ(to_hex_text(encode(worked_diagnosis()).front()), to_hex_text(octets));
  const auto decoded = decode(octets);
  ASSERT_TRUE(decoded) << to_string(decoded.error());
  EXPECT_EQ(*decoded, worked_diagnosis());
}

TEST(AnnouncementSpecification, ItsRelayedWordIsWhatTheCodecWritesAndReads) {
  const auto octets = octets_in_specification("## Worked example of a relayed word");
  const auto decoded = decode(octets);
  ASSERT_TRUE(decoded) << to_string(decoded.error());
  EXPECT_EQ(decoded->kind, Kind::relayed);
  EXPECT_EQ(decoded->relayed.word.size(), 36U);
  EXPECT_EQ(decoded->relayed.age, std::chrono::milliseconds(3));
  EXPECT_EQ(decoded->relayed.through, (std::vector{ParticipantId{0x5e6f7a8b}, ParticipantId{0x1a2b3c4d}}));
  EXPECT_EQ(decoded->relayed.source, "192.168.1.2");
  EXPECT_EQ(to_hex_text(encode(*decoded).front()), to_hex_text(octets));
}

TEST(AnnouncementSpecification, NamesEveryReasonForRefusal) {
  std::ifstream file(GEMINGA_SOURCE_DIR "/src/discovery/announcement/ANNOUNCEMENT.md");
  std::stringstream text;
  text << file.rdbuf();
  for (std::size_t i = 0; i < decode_error_count; ++i) {
    const auto word = to_string(static_cast<DecodeError>(i));
    EXPECT_THAT(text.str(), ::testing::HasSubstr("`" + std::string(word) + "`"));
  }
}

}  // namespace
}  // namespace geminga::announcement
