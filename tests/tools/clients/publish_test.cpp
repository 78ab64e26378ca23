// geminga-publish against a real daemon.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "tools/clients/bench.hpp"

namespace geminga::tools {
namespace {

using testing::HasSubstr;

TEST(Publish, OffersUntilItIsEnded) {
  Bench bench;
  Talk consumer = bench.talk();
  consumer.say("1 sub create mode=otm/stream concept=soccer:TrackedObject");
  auto publish = bench.start("geminga-publish",
                             {"soccer:BallInfo", "--representation", "soccer:CartesianFieldFrame", "--port", "5000",
                              "--priority", "-2", "--protocol", "tcp", "--name", "eye", "rate=30", "lens=wide angle"});
  const auto added = consumer.line_with({"1 pub add"});
  ASSERT_TRUE(added) << publish->said();
  for (const char* part :
       {"name=eye", "concept=soccer:BallInfo", "representation=soccer:CartesianFieldFrame", "port=5000", "priority=-2",
        "protocol=tcp", "rate=30", "lens=\"wide angle\"", "mode=otm/stream"}) {
    EXPECT_THAT(*added, HasSubstr(part));
  }
  publish->signal(SIGTERM);
  EXPECT_EQ(publish->wait(), 0) << publish->said();
  EXPECT_TRUE(consumer.line_with({"1 pub del", "reason=withdrawn"}));
}

TEST(Publish, SaysWhatToDoWhereAConceptStandsForARepresentation) {
  Bench bench;
  const std::vector<std::tuple<std::string, std::string, std::string>> cases{
      {"soccer:BallInfo", "soccer:SharedBallInfo",
       "representation=soccer:SharedBallInfo: this is a concept: name how the information is written down, a class "
       "below "
       "geminga:Representation, or leave the representation out"},
      {"soccer:CartesianFieldFrame", "soccer:CartesianFieldFrame",
       "concept=soccer:CartesianFieldFrame: this is a representation: name what the information is about as the "
       "concept, "
       "and this one as its representation"}};
  for (const auto& [concept_name, representation, text] : cases) {
    const std::vector<std::string> identity{concept_name, "--representation", representation};
    auto words = identity;
    words.insert(words.end(), {"--port", "5000"});
    EXPECT_EQ(bench.run("geminga-publish", words).status, 2);
    EXPECT_EQ(bench.run("geminga-subscribe", identity).errors, "geminga-subscribe: " + text + '\n');
    words = identity;
    words.insert(words.begin(), "match");
    const auto asked = bench.query(words);
    EXPECT_EQ(asked.status, 2);
    EXPECT_THAT(asked.errors, HasSubstr(text));
  }
}

TEST(Publish, PrintsItsConsumers) {
  Bench bench;
  auto publish =
      bench.start("geminga-publish", {"--text", "camera", "--mode", "otm/pubsub", "--port", "5000", "--json"});
  ASSERT_TRUE(publish->wait_for("\"event\":\"offered\"")) << publish->said();
  Talk consumer = bench.talk();
  consumer.say("0 sys hello name=world");
  consumer.say("1 sub create mode=otm/pubsub text=camera port=6000");
  ASSERT_TRUE(publish->wait_for("\"event\":\"add\"")) << publish->said();
  EXPECT_THAT(publish->said(), HasSubstr("\"name\":\"world\""));
  consumer.say("1 sub remove");
  ASSERT_TRUE(publish->wait_for("\"reason\":\"withdrawn\"")) << publish->said();
  publish->signal(SIGINT);
  EXPECT_EQ(publish->wait(), 0);
}

TEST(Publish, EndsWithTwoOnANameThatTheOntologyDoesNotKnow) {
  Bench bench;
  const auto outcome = bench.run("geminga-publish", {"soccer:Bal", "--port", "5000"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("soccer:Bal"));
  EXPECT_EQ(bench.run("geminga-publish", {"--text", "x", "--port", "5000", "--address", "robot2"}).status, 2);
  EXPECT_EQ(bench.run("geminga-publish", {"--text", "x", "--port", "5000", "service=mine"}).status, 2);
}

TEST(Publish, TakesNoMistypedKeyForAnAttribute) {
  Bench bench;
  const auto outcome = bench.run("geminga-publish", {"--text", "x", "--port", "5000", "prority=5"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.errors, HasSubstr("did you mean priority?"));
  Talk consumer = bench.talk();
  consumer.say("1 sub create mode=otm/stream text=x");
  auto publish = bench.start("geminga-publish", {"--text", "x", "--port", "5000", "rate=30", "attr.where=left",
                                                 "--attribute", "prority=5", "--attribute", "attr.port=7"});
  const auto added = consumer.line_with({"1 pub add"});
  ASSERT_TRUE(added) << publish->said();
  for (const char* part : {" port=5000", " rate=30", " attr.where=left", " prority=5", " attr.port=7"}) {
    EXPECT_THAT(*added, HasSubstr(part));
  }
  EXPECT_EQ(bench.run("geminga-publish", {"--text", "x", "--port", "5000", "rate=1", "--attribute", "rate=2"}).status,
            2);
}

TEST(Publish, EndsWithThreeWhenTheDaemonGoes) {
  Bench bench;
  auto publish = bench.start("geminga-publish", {"--text", "camera", "--port", "5000"});
  ASSERT_TRUE(publish->wait_for("offering"));
  bench.stop_daemon();
  EXPECT_EQ(publish->wait(), 3);
}

TEST(Publish, OffersAgainWhenTheDaemonIsBackAndItIsKept) {
  Bench bench;
  auto publish = bench.start("geminga-publish", {"--text", "camera", "--port", "5000", "--keep"});
  ASSERT_TRUE(publish->wait_for("offering"));
  publish->forget();
  bench.stop_daemon();
  ASSERT_TRUE(publish->wait_for("trying again")) << publish->said();
  bench.start_daemon();
  ASSERT_TRUE(publish->wait_for("offering")) << publish->said();
  EXPECT_EQ(bench.query({"services", "camera"}).status, 0);
  publish->signal(SIGTERM);
  EXPECT_EQ(publish->wait(), 0);
}

}  // namespace
}  // namespace geminga::tools
