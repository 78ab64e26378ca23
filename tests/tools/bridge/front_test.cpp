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
  EXPECT_THAT(unknown.said,
              HasSubstr("geminga-bridge: 'dns' is no kind of bridge: the kinds are dns-sd, dds, mqtt, nats"));
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

TEST(Bridge, RefusesWhatIsNoDomainOfDds) {
  if (!std::filesystem::exists(program("geminga-bridge-dds"))) GTEST_SKIP() << "the kind is not built";
  for (const char* domain : {"233", "-1", "seven", ""}) {
    EXPECT_EQ(bridge({"dds", "--domain", domain}).status, 2) << domain;
  }
  EXPECT_THAT(bridge({"dds", "--domain", "233"}).said, HasSubstr("--domain: 233 is no domain"));
  const Ran ran =
      run({.words = {program("geminga-bridge-dds")}, .environment = {{"ROS_DOMAIN_ID", "x"}}, .before = {}});
  EXPECT_THAT(ran.said, HasSubstr("ROS_DOMAIN_ID: x is no domain"));
  const Ran broken = run({.words = {program("geminga-bridge-dds")},
                          .environment = {{"CYCLONEDDS_URI", "<CycloneDDS><Nonsense/></CycloneDDS>"}},
                          .before = {}});
  EXPECT_EQ(broken.status, 2) << broken.said;
  EXPECT_THAT(broken.said, HasSubstr("domain 0 cannot be joined"));
}

TEST(Bridge, RefusesWhatIsNoCredentialOfItsServer) {
  const auto refuses = [](const std::string& kind, const std::vector<std::string>& flags) {
    if (!std::filesystem::exists(program("geminga-bridge-" + kind))) return true;
    std::vector<std::string> line{kind, kind + "://127.0.0.1"};
    line.insert(line.end(), flags.begin(), flags.end());
    return bridge(line).status == 2;
  };
  EXPECT_TRUE(refuses("nats", {"--nkey", "UABC"}));
  EXPECT_TRUE(refuses("nats", {"--jetstream-domain", "a.b"}));
  EXPECT_TRUE(refuses("nats", {"--nkey", "UABC", "--nkey-seed", "/nowhere"}));
  EXPECT_TRUE(refuses("nats", {"--nkey", "UABC", "--nkey-seed", "/dev/null", "--credentials", "/dev/null"}));
  EXPECT_TRUE(refuses("mqtt", {"--mqtt", "4"}));
}

TEST(Bridge, RefusesWhatIsNoServer) {
  for (const char* kind : {"mqtt", "nats"}) {
    if (!std::filesystem::exists(program(std::string("geminga-bridge-") + kind))) continue;
    const std::string good = std::string(kind) + "://127.0.0.1";
    for (const std::vector<std::string>& words :
         std::vector<std::vector<std::string>>{{},
                                               {"127.0.0.1"},
                                               {"http://127.0.0.1"},
                                               {std::string(kind) + "://"},
                                               {good + ":0"},
                                               {good, "--team", "a/b"},
                                               {good, "--site", "a.b"},
                                               {good, "--listen", "10.0.0.1:4720"},
                                               {good, "--daemon", "nowhere"},
                                               {good, "--ca", "x.pem"},
                                               {good, "--certificate", "x.pem"},
                                               {good, "--certificate", "x.pem", "--certificate-key", "x.key"},
                                               {good, "--password-file", "/dev/null"},
                                               {good, "--user", "me", "--password-file", "/etc/passwd"}}) {
      std::vector<std::string> line{kind};
      line.insert(line.end(), words.begin(), words.end());
      EXPECT_EQ(bridge(line).status, 2) << testing::PrintToString(line);
    }
  }
}

}  // namespace
}  // namespace geminga::system
