// geminga-query doctor on real daemons: each cause that network namespaces can make gives its finding and no other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/json/object.hpp>
#include <fstream>
#include <iterator>

#include "system/folder.hpp"
#include "tools/clients/bench.hpp"
#include "tools/doctor/lab_doctor.hpp"

namespace geminga::tools {
namespace {

using system::Lab;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(DoctorCommand, SaysThatAHealthyHostIsHealthy) {
  Bench bench;
  if (!bench.lab().has_namespaces()) GTEST_SKIP() << "other daemons of this host would be found";
  const Outcome outcome = bench.query({"doctor"});
  EXPECT_EQ(outcome.out, "Healthy: nothing is wrong on this host and among 1 participant.\n");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(bench.query({"--json", "doctor"}).out, "{\"healthy\":true,\"findings\":[]}\n");
}

TEST(DoctorCommand, FindsARequestThatNobodyServesAndSaysWhatToRun) {
  Bench bench;
  if (!bench.lab().has_namespaces()) GTEST_SKIP() << "other daemons of this host would be found";
  Talk peer = bench.talk();
  peer.say("0 sys hello name=vision");
  peer.say("1 sub create mode=oto id=77");
  EXPECT_THAT(peer.lines_until_pong(), Not(IsEmpty()));
  const Outcome outcome = bench.query({"doctor"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out,
              testing::StartsWith("risk unmatched\n  what     One request is served by nobody (vision): "));
  EXPECT_THAT(outcome.out, HasSubstr("\n  command  geminga-query why "));
}

TEST(DoctorCommand, SaysThatNoDaemonRuns) {
  Bench bench;
  if (!bench.lab().has_namespaces()) GTEST_SKIP() << "other daemons of this host would be found";
  bench.stop_daemon();
  const Outcome outcome = bench.query({"--json", "doctor"});
  EXPECT_EQ(outcome.status, 1) << "that is a finding, not an error";
  EXPECT_THAT(codes_in(outcome.out), ElementsAre("daemon_away"));
}

TEST(DoctorCommand, WritesAReportWithoutKeys) {
  Bench bench;
  const system::Folder folder;
  const std::string file = folder.path("report.json");
  EXPECT_NE(bench.query({"doctor", "--report", file}).status, 2);
  std::ifstream in(file);
  const boost::json::value report = parsed({std::istreambuf_iterator<char>(in), {}});
  for (const char* part : {"findings", "status", "participants", "security", "interfaces_of_host", "unmatched"})
    EXPECT_TRUE(report.as_object().contains(part)) << part;
  EXPECT_EQ(bench.query({"doctor", "--report", "/no/such/folder/report"}).status, 2);
  EXPECT_EQ(bench.query({"--watch", "doctor"}).status, 2);
}

TEST(DoctorCommand, WritesAReportWithoutNamesAndPayloads) {
  Bench bench;
  Talk peer = bench.talk();
  peer.say("0 sys hello name=kangaroo");
  peer.say("1 pub create mode=oto id=77 port=5000 secret=pouch");
  EXPECT_THAT(peer.lines_until_pong(), Not(IsEmpty()));  // the answer to hello
  const system::Folder folder;
  const auto reported = [&](std::vector<std::string> flags) {
    const std::string file = folder.path("report.json");
    flags.insert(flags.begin(), {"doctor", "--report", file});
    EXPECT_NE(bench.query(flags).status, 2);
    std::ifstream in(file);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string with_names = reported({});
  EXPECT_THAT(with_names, AllOf(HasSubstr("robot0"), HasSubstr("kangaroo"), Not(HasSubstr("pouch"))));
  const std::string nameless = reported({"--without-names"});
  EXPECT_THAT(nameless, AllOf(Not(HasSubstr("robot0")), Not(HasSubstr("kangaroo")), HasSubstr("\"name\":\"name")));
  EXPECT_EQ(bench.query({"doctor", "--without-names"}).status, 2);
}

TEST(DoctorCommand, FindsAHostWithAnotherOntology) {
  Lab lab(2);
  if (!lab.has_namespaces()) GTEST_SKIP() << "other daemons of this host would be found";
  lab.start(0, {"--ontology", GEMINGA_SOURCE_DIR "/ontology"});
  lab.start(1);
  EXPECT_TRUE(comes_to(lab, 0, {"ontologies_differ"}));
}

TEST(DoctorCommand, FindsAnotherTeamOnTheLink) {
  Lab lab(3);
  if (!lab.has_namespaces()) GTEST_SKIP() << "other daemons of this host would be found";
  lab.start(0, {"--group", "red"});
  lab.start(1, {"--group", "red"});
  lab.start(2, {"--group", "blue"});
  EXPECT_TRUE(comes_to(lab, 0, {"other_group"}));
}

}  // namespace
}  // namespace geminga::tools
