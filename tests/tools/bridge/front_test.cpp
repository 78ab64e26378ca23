// geminga-bridge as a user starts it, without a daemon.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/process.hpp"

namespace geminga::system {
namespace {

using testing::HasSubstr;

Ran bridge(std::vector<std::string> words) {
  words.insert(words.begin(), program("geminga-bridge"));
  return run({.words = words, .environment = {}, .before = {}});
}

TEST(Bridge, SaysWhichKindsThereAre) {
  const Ran unknown = bridge({"dns"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.said, HasSubstr("geminga-bridge: no kind is 'dns': there are dns-sd"));
  EXPECT_EQ(bridge({}).status, 2);
  EXPECT_EQ(bridge({"--help"}).status, 0);
  EXPECT_EQ(bridge({"../gemingad"}).status, 2) << "nothing else is started";
}

TEST(Bridge, RefusesWhatIsNoTypeOfDnsSd) {
  if (!std::filesystem::exists(program("geminga-bridge-dns-sd"))) GTEST_SKIP() << "the kind is not built";
  EXPECT_THAT(bridge({"dns-sd", "--type", "ipp"}).said, HasSubstr("is no type: write _NAME._tcp or _NAME._udp"));
  EXPECT_THAT(bridge({"dns-sd", "--type", "_geminga._udp"}).said, HasSubstr("is Geminga's own"));
  EXPECT_EQ(bridge({"dns-sd", "--connect", "nowhere"}).status, 2);
  EXPECT_EQ(bridge({"dns-sd", "--only", "both"}).status, 2);
}

}  // namespace
}  // namespace geminga::system
