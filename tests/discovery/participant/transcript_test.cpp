// Each file in transcripts/ is one test.
#include "discovery/participant/transcript.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace geminga::participant {
namespace {

std::vector<std::string> transcript_names() {
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(GEMINGA_SOURCE_DIR "/tests/discovery/participant/transcripts")) {
    if (entry.path().extension() == ".txt") names.push_back(entry.path().stem());
  }
  std::ranges::sort(names);
  return names;
}

class TranscriptTest : public testing::TestWithParam<std::string> {};

TEST_P(TranscriptTest, IsWhatAParticipantSays) {
  Transcript(std::string(GEMINGA_SOURCE_DIR "/tests/discovery/participant/transcripts/") + GetParam() + ".txt").play();
}

INSTANTIATE_TEST_SUITE_P(Gcnp, TranscriptTest, testing::ValuesIn(transcript_names()),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace geminga::participant
