// Metrics: what a daemon's answers become, and their two forms.
#include "web/site/metrics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tools/web/fake_asker.hpp"
#include "web/site/limits.hpp"

namespace geminga::web {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

Outcome nobody() { return failed(ClientError::Kind::unreachable, "nobody"); }

std::string text_of(const std::vector<Outcome>& outcomes, const Traffic& traffic = {}) {
  return exposition(metrics(outcomes, traffic), Form::openmetrics);
}

/// All answers, of which a test changes one.
std::vector<Outcome> usual() {
  return {answered({record("status", {{"version", "1.0.0"},
                                      {"state", "ready"},
                                      {"participant", "1a2b3c4d"},
                                      {"uptime", "12.500"},
                                      {"bytes_sent", "1234"},
                                      {"heard_fresh", "7"},
                                      {"sealing", "sealed"},
                                      {"sealing_plain", "2"},
                                      {"matched_exact", "5"},
                                      {"matched_narrower", "3"},
                                      {"memory", "1048576"},
                                      {"cage", "calls,files"}})}),
          answered({record("participants", {{"id", "1a2b3c4d"}, {"name", "us"}, {"self", "1"}}),
                    record("participants", {{"id", "00000002"},
                                            {"name", "robot \"2\"\\\n"},
                                            {"heard", "0.250"},
                                            {"loss", "0.41"},
                                            {"loss_least", "0.25"},
                                            {"self", "0"},
                                            {"hears_us", "0"}})}),
          answered({record("requests", {{"subscription", "1a2b3c4d/2/1"},
                                        {"name", "base"},
                                        {"participant_name", "us"},
                                        {"concept", "soccer:Ball"},
                                        {"representation", "soccer:Polar"},
                                        {"why", "nobody"}})}),
          answered({record("ontology",
                           {{"loaded", "1"}, {"digest", "0123456789abcdef"}, {"classes", "9"}, {"complete", "1"}})}),
          answered({record("security", {{"mode", "sealed"}, {"keys", "aa,bb"}}),
                    record("security", {{"participant", "00000002"}, {"lacks", "aa"}})})};
}

TEST(Metrics, HaveTypesUnitsHelpAndAnEnd) {
  const std::string text = text_of(usual());
  EXPECT_THAT(text,
              HasSubstr("# TYPE geminga_uptime_seconds gauge\n# UNIT geminga_uptime_seconds seconds\n# HELP "
                        "geminga_uptime_seconds Time since the daemon started.\ngeminga_uptime_seconds 12.500\n"));
  EXPECT_THAT(text, HasSubstr("# TYPE geminga_sent_bytes counter\n# UNIT geminga_sent_bytes bytes\n"));
  EXPECT_THAT(text, HasSubstr("\ngeminga_sent_bytes_total 1234\n"));
  EXPECT_THAT(text, HasSubstr("# TYPE geminga_daemon info\n"));
  EXPECT_THAT(
      text,
      HasSubstr(
          "\ngeminga_daemon_info{version=\"1.0.0\",state=\"ready\",participant=\"1a2b3c4d\",sealing=\"sealed\"} 1\n"));
  EXPECT_THAT(text, EndsWith("\n# EOF\n"));
}

TEST(Metrics, SayWhatTheIssueOfMonitoringAsksFor) {
  const std::string text = text_of(usual());
  for (const char* line :
       {"geminga_up 1", "geminga_announcements_heard_total{kind=\"fresh\"} 7",
        "geminga_datagrams_unsealed_total{reason=\"plain\"} 2", "geminga_matches_total{degree=\"exact\"} 5",
        "geminga_matches_total{degree=\"narrower\"} 3", "geminga_memory_bytes 1048576",
        "geminga_neighbour_loss_ratio{participant=\"00000002\",name=\"robot \\\"2\\\"\\\\\\n\"} 0.41",
        "geminga_neighbour_loss_least_ratio{participant=\"00000002\",name=\"robot \\\"2\\\"\\\\\\n\"} 0.25",
        "geminga_neighbour_age_seconds{participant=\"00000002\",name=\"robot \\\"2\\\"\\\\\\n\"} 0.250",
        "geminga_neighbour_hears_us{participant=\"00000002\",name=\"robot \\\"2\\\"\\\\\\n\"} 0",
        "geminga_neighbour_reachable{participant=\"00000002\",name=\"robot \\\"2\\\"\\\\\\n\"} 1",
        "geminga_requests_unmatched 1",
        "geminga_request_unmatched{subscription=\"1a2b3c4d/2/"
        "1\",consumer=\"base\",participant=\"us\",identity=\"soccer:Ball in "
        "soccer:Polar\",why=\"nobody\"} 1",
        "geminga_ontology_info{digest=\"0123456789abcdef\"} 1", "geminga_ontology_complete 1",
        "geminga_participants_lacking_key 1", "geminga_keys 2", "geminga_participants_lost_total 0",
        "geminga_participants_other_ontology 0"}) {
    EXPECT_THAT(text, HasSubstr('\n' + std::string(line) + '\n'));
  }
  EXPECT_THAT(text, Not(HasSubstr("name=\"us\"} "))) << "a host is no neighbour of its own";
}

TEST(Metrics, SayThatTheDaemonIsAway) {
  const std::string text =
      text_of({nobody(), nobody(), nobody(), nobody(), nobody()}, {.responses = {{200, 3}}, .streams = 1});
  EXPECT_THAT(text, HasSubstr("\ngeminga_up 0\n"));
  EXPECT_THAT(text, HasSubstr("\ngeminga_web_responses_total{status=\"200\"} 3\n"));
  EXPECT_THAT(text, Not(HasSubstr("geminga_uptime")));
}

TEST(Metrics, LeaveOutWhatALiarSaysInsteadOfNumbers) {
  for (const char* lie : {"", "x", "1 2", "1\n# EOF", "-1", "1e9", "0x10", "1.2.3", ".", "1.", "NaN",
                          "123456789012345678901234567890123"}) {
    auto outcomes = usual();
    outcomes[0] = answered({record("status", {{"state", "ready"}, {"uptime", lie}})});
    const std::string text = text_of(outcomes);
    EXPECT_THAT(text, Not(HasSubstr("geminga_uptime_seconds"))) << lie;
    EXPECT_THAT(text, HasSubstr("\ngeminga_up 1\n"));
  }
}

TEST(Metrics, AreBounded) {
  for (const int beyond : {-1, 0, 1}) {
    auto outcomes = usual();
    std::vector<Record> requests(max_unmatched_samples + static_cast<std::size_t>(beyond),
                                 record("requests", {{"id", "7"}}));
    std::vector<Record> neighbours(max_neighbour_samples + static_cast<std::size_t>(beyond),
                                   record("participants", {{"loss", "0"}}));
    const std::size_t count = requests.size();
    outcomes[1] = answered(std::move(neighbours));
    outcomes[2] = answered(std::move(requests));
    std::size_t told = 0;
    std::size_t lossy = 0;
    for (const Family& family : metrics(outcomes, {})) {
      if (family.name == "geminga_request_unmatched") told = family.samples.size();
      if (family.name == "geminga_neighbour_loss_ratio") lossy = family.samples.size();
      if (family.name == "geminga_requests_unmatched") {
        EXPECT_EQ(family.samples.front().value, std::to_string(count));
      }
    }
    EXPECT_EQ(told, max_unmatched_samples - (beyond < 0 ? 1 : 0)) << beyond;
    EXPECT_EQ(lossy, max_neighbour_samples - (beyond < 0 ? 1 : 0)) << beyond;
  }
}

TEST(Metrics, HaveTheOlderFormWhereItAloneIsAskedFor) {
  EXPECT_EQ(form_for(""), Form::openmetrics);
  EXPECT_EQ(form_for("*/*"), Form::openmetrics);
  EXPECT_EQ(form_for("application/openmetrics-text;version=1.0.0,text/plain;q=0.5"), Form::openmetrics);
  EXPECT_EQ(form_for("text/plain;version=0.0.4;q=0.5,*/*;q=0.1"), Form::plain);
  const std::string text = exposition(metrics(usual(), {}), Form::plain);
  EXPECT_THAT(text, HasSubstr("# TYPE geminga_sent_bytes_total counter\n# HELP geminga_sent_bytes_total "));
  EXPECT_THAT(text, HasSubstr("# TYPE geminga_daemon_info gauge\n"));
  EXPECT_THAT(text, Not(HasSubstr("# UNIT")));
  EXPECT_THAT(text, Not(HasSubstr("# EOF")));
}

}  // namespace
}  // namespace geminga::web
