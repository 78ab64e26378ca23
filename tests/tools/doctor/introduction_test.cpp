// Hosts that multicast does not reach: introduced to each other, tried alone within bounds, and named by the doctor.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <cstdlib>

#include "system/folder.hpp"
#include "tools/clients/bench.hpp"
#include "tools/doctor/lab_doctor.hpp"

namespace geminga::tools {
namespace {

using system::Folder;
using system::Lab;

std::string team_key(const Folder& folder) {
  EXPECT_EQ(system::refused({"--generate-key", folder.path("team.key")}).status, 0);
  return folder.path("team.key");
}

std::size_t number_in(const std::string& line, const std::string& key) {
  const auto word = system::field(line, key);
  return word.empty() ? 0 : static_cast<std::size_t>(std::strtoull(word.c_str(), nullptr, 10));
}

TEST(Introduction, LetsTwoHostsOfASealedTeamMeetWhomMulticastsKeepApart) {
  if (!Lab::can_lose()) GTEST_SKIP() << "there is no nftables, or there are no network namespaces";
  const Folder folder;
  const std::string key = team_key(folder);
  for (const double loss : {0.0, 0.3}) {
    Lab lab(3);
    if (loss > 0) lab.lose(loss);
    lab.keep_multicasts_between(0, 1);
    lab.start_all({"--interval", "0.2", "--key-file", key});
    for (const std::size_t host : {2U, 0U, 1U})
      EXPECT_TRUE(lab.wait_for_participants(host, 3)) << host << " at " << loss;
    EXPECT_TRUE(lab.talk(0).wait_until("status", [](const auto& lines) {
      return lines.size() == 1 && number_in(lines[0], "peers_unnamed") == 1 && number_in(lines[0], "tried_alone") <= 1;
    })) << loss;
    EXPECT_TRUE(comes_to(lab, 0, {})) << loss;
  }
}

TEST(DeafHosts, AreTriedEightAtATimeAndWithinTheirOctets) {
  if (!Lab::can_lose()) GTEST_SKIP() << "there is no nftables, or there are no network namespaces";
  constexpr std::size_t hosts = 10;
  constexpr std::size_t most_tried = 8;
  constexpr std::size_t octets_of_a_try = 16384;
  constexpr double interval = 0.2;
  const Folder folder;
  Lab lab(hosts);
  for (std::size_t host = 0; host < hosts; ++host)
    lab.begin(host, {"--interval", "0.2", "--key-file", host == 0 ? team_key(folder) : folder.path("team.key")});
  for (std::size_t host = 0; host < hosts; ++host) lab.wait_until_ready(host);
  ASSERT_TRUE(lab.wait_for_participants(0, hosts));
  lab.mute(0);
  std::string status;
  EXPECT_TRUE(lab.talk(0).wait_until("status", [&](const auto& lines) {
    if (lines.size() != 1) return false;
    status = lines[0];
    EXPECT_LE(number_in(status, "tried_alone"), most_tried);
    return number_in(status, "unheard_by") == hosts - 1 && number_in(status, "bytes_alone") > 0;
  })) << status;
  EXPECT_EQ(number_in(status, "tried_alone"), most_tried) << status;
  // A try takes eight intervals, and the pause behind it eight at least.
  const double tries = 1 + std::strtod(system::field(status, "uptime").c_str(), nullptr) / (16 * interval);
  EXPECT_LE(static_cast<double>(number_in(status, "bytes_alone")), tries * most_tried * octets_of_a_try) << status;
  EXPECT_TRUE(comes_to(lab, 0, Codes(hosts - 1, "deaf_to_us")));
}

TEST(DeafHost, WithoutAKeyIsNamedByTheLineThatTheDoctorGives) {
  Lab lab(2);
  if (!lab.has_namespaces()) GTEST_SKIP() << "a bridge that keeps multicasts needs network namespaces";
  lab.start_all({"--interval", "0.2"});
  ASSERT_TRUE(lab.wait_for_participants(0, 2));
  ASSERT_TRUE(lab.wait_for_participants(1, 2));
  EXPECT_THAT(codes_in(examined(lab, 0)), testing::IsEmpty());
  lab.keep_multicasts_from(1);
  EXPECT_TRUE(comes_to(lab, 0, {"deaf_to_us"}));
  const auto document = parsed(examined(lab, 0));
  ASSERT_EQ(document.at("findings").as_array().size(), 1U);
  const std::string line(document.at("findings").at(0).at("command").as_string());
  EXPECT_EQ(line, "gemingad --peer " + lab.address_of(1));
  for (const std::size_t host : {0U, 1U}) {
    lab.daemon(host).signal(SIGTERM);
    EXPECT_EQ(lab.daemon(host).wait(), 0);
    lab.begin(host, {"--interval", "0.2", "--peer", lab.address_of(1 - host)});
  }
  for (const std::size_t host : {0U, 1U}) lab.wait_until_ready(host);
  EXPECT_TRUE(lab.wait_for_participants(1, 2)) << "both sides name each other, as the finding says";
  EXPECT_TRUE(comes_to(lab, 0, {}));
}

}  // namespace
}  // namespace geminga::tools
