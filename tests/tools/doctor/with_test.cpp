// The doctor on two hosts at once, and hosts that a bridge keeps multicasts from: real daemons in network namespaces.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <csignal>

#include "system/folder.hpp"
#include "tools/clients/bench.hpp"
#include "tools/doctor/lab_doctor.hpp"

namespace geminga::tools {
namespace {

using system::Folder;
using system::Lab;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

system::Ran doctor_with(const Lab& lab, const std::string& who, bool is_json = true) {
  const std::string address = "127.0.0.1:" + std::to_string(lab.gcnp_port(0));
  std::vector<std::string> words{system::program("geminga-query"), "--connect", address, "doctor", "--with", who};
  if (is_json) words.insert(words.begin() + 1, "--json");
  return system::run(lab.on(0, words));
}

std::string key_in(const Folder& folder) {
  EXPECT_EQ(system::refused({"--generate-key", folder.path("team.key")}).status, 0);
  return folder.path("team.key");
}

/// Two hosts that know each other.
void meet(Lab& lab, std::vector<std::string> flags) {
  flags.insert(flags.end(), {"--interval", "0.2"});
  lab.start_all(flags);
  ASSERT_TRUE(lab.wait_for_participants(0, 2));
  ASSERT_TRUE(lab.wait_for_participants(1, 2));
}

TEST(DoctorWith, ShowsBothViewsOfASealedTeamWhereTheOwnerAllowsIt) {
  Lab lab(2);
  if (!lab.has_namespaces()) GTEST_SKIP() << "other daemons of this host would be found";
  const Folder folder;
  meet(lab, {"--key-file", key_in(folder), "--diagnose"});
  const system::Ran ran = doctor_with(lab, "robot1");
  EXPECT_THAT(codes_in(ran.said), IsEmpty());
  const auto with = parsed(ran.said).at("with");
  EXPECT_TRUE(with.at("answered").as_bool());
  EXPECT_EQ(with.at("status").at("sealing").as_string(), "encrypted");
  EXPECT_EQ(with.at("participants").as_array().size(), 2U);
  EXPECT_THAT(doctor_with(lab, "10.47.17.2", false).said, testing::AllOf(HasSubstr("HERE"), HasSubstr("each other")));
  EXPECT_THAT(codes_in(doctor_with(lab, "robot9").said), ElementsAre("other_unknown"));
}

TEST(DoctorWith, SaysThatTheOtherDoesNotTellItsView) {
  Lab lab(2);
  if (!lab.has_namespaces()) GTEST_SKIP() << "other daemons of this host would be found";
  const Folder folder;
  meet(lab, {"--key-file", key_in(folder)});
  EXPECT_THAT(codes_in(doctor_with(lab, "robot1").said), ElementsAre("other_silent"));
}

TEST(DoctorWith, IsAnsweredWithoutAKeyOnlyByAHostThatNamesThisOne) {
  Lab lab(2);
  if (!lab.has_namespaces()) GTEST_SKIP() << "other daemons of this host would be found";
  meet(lab, {"--diagnose"});
  EXPECT_THAT(codes_in(doctor_with(lab, "robot1").said), ElementsAre("other_silent"));
  for (const std::size_t host : {0U, 1U}) {
    lab.daemon(host).signal(SIGTERM);
    EXPECT_EQ(lab.daemon(host).wait(), 0);
    lab.begin(host, {"--diagnose", "--interval", "0.2", "--peer", lab.address_of(1 - host)});
  }
  for (const std::size_t host : {0U, 1U}) {
    lab.wait_until_ready(host);
    ASSERT_TRUE(lab.wait_for_participants(host, 2));
  }
  EXPECT_THAT(codes_in(doctor_with(lab, "robot1").said), IsEmpty());
}

TEST(DeafHost, IsReachedAloneByASealedTeam) {
  Lab lab(2);
  if (!lab.has_namespaces()) GTEST_SKIP() << "a bridge that keeps multicasts needs network namespaces";
  const Folder folder;
  meet(lab, {"--key-file", key_in(folder)});
  lab.keep_multicasts_from(1);
  EXPECT_TRUE(lab.talk(0).wait_until(
      "status", [](const auto& lines) { return lines.size() == 1 && lines[0].contains(" tried_alone=1 "); }));
  EXPECT_TRUE(lab.talk(1).wait_until("status", [](const auto& lines) {
    return lines.size() == 1 && lines[0].contains(" peers_unnamed=1") && lines[0].contains(" participants=2 ");
  }));
  EXPECT_TRUE(comes_to(lab, 0, {}));
}

TEST(DoctorBehindARelay, FindsNothingAndSaysWhatARelayDoesNotCarry) {
  Lab lab(3);
  if (!lab.has_namespaces()) GTEST_SKIP() << "two links need network namespaces";
  lab.add_link(1, {2});
  const Folder folder;
  const std::vector<std::string> flags{"--interval", "0.2", "--diagnose", "--key-file", key_in(folder)};
  for (const std::size_t host : {0U, 1U, 2U}) {
    auto all = flags;
    if (host == 1) all.emplace_back("--relay");
    lab.begin(host, all);
  }
  for (const std::size_t host : {0U, 1U, 2U}) lab.wait_until_ready(host);
  for (const std::size_t host : {0U, 1U, 2U}) {
    ASSERT_TRUE(lab.wait_for_participants(host, 3)) << host;
    EXPECT_TRUE(comes_to(lab, host, {})) << host;
  }
  EXPECT_THAT(codes_in(doctor_with(lab, "robot2").said), ElementsAre("other_behind_relay"));
  EXPECT_THAT(codes_in(doctor_with(lab, "robot1").said), IsEmpty()) << "the relay itself answers";
  system::Talk provider = lab.talk(2);
  provider.say("1 pub create mode=oto id=77 port=5000");
  EXPECT_THAT(provider.lines_until_pong(), IsEmpty());
  EXPECT_TRUE(comes_to(lab, 0, {"address_unreachable"})) << "there is no route to the other link";
  must_run(lab, 0, {"/bin/ip", "route", "add", "10.47.18.0/24", "via", lab.address_of(1)});
  EXPECT_TRUE(comes_to(lab, 0, {}));
}

TEST(AnnouncedAddress, StandsForTheInterfacesOwn) {
  Lab lab(2);
  if (!lab.has_namespaces()) GTEST_SKIP() << "the loopback announces nothing else";
  lab.start(0, {"--interval", "0.2"});
  lab.start(1, {"--interval", "0.2", "--announce-address", "wlan0=192.0.2.9"});
  system::Talk provider = lab.talk(1);
  provider.say("1 pub create mode=oto id=77 port=5000");
  EXPECT_THAT(provider.lines_until_pong(), IsEmpty());
  system::Talk consumer = lab.talk(0);
  consumer.say("1 sub create mode=oto id=77");
  const auto told = consumer.line_with({"1 pub add", "port=5000"});
  ASSERT_TRUE(told);
  EXPECT_EQ(system::field(*told, "address"), "192.0.2.9");
  EXPECT_TRUE(comes_to(lab, 0, {"address_unreachable"}));
}

}  // namespace
}  // namespace geminga::tools
