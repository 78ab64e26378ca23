// geminga-query why, requests --unmatched and services --unused against a real daemon.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/clients/query.hpp"

namespace geminga::tools {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

TEST_F(Query, SaysWhyAPairMatchesOrNot) {
  const std::string ball = word({"services", "mode=otm/stream"}, "service");
  const std::string lonely = word({"services", "lonely"}, "service");
  const std::string request = word({"requests", "mode=otm/stream"}, "subscription");
  const auto yes = bench_.query({"why", request, ball});
  EXPECT_EQ(yes.status, 0) << yes.errors;
  EXPECT_THAT(yes.out, StartsWith("yes: "));
  const auto no = bench_.query({"why", request, lonely});
  EXPECT_EQ(no.status, 1);
  EXPECT_THAT(no.out, StartsWith("no: "));
  EXPECT_EQ(bench_.query({"why", request, "00000001/1/1"}).status, 1);
  EXPECT_EQ(bench_.query({"why", request, "nonsense"}).status, 2);
  const auto document = bench_.json({"why", request, ball});
  EXPECT_EQ(document.at("matches"), true);
  EXPECT_EQ(document.at("degree"), "narrower");
  EXPECT_TRUE(document.at("checks").at(0).at("ok").is_bool());
}

TEST_F(Query, SaysOfAnOutrankedPairThatItDoesNotMatch) {
  peer_.say("71 pub create mode=oto text=pick port=6001 priority=5");
  peer_.say("72 pub create mode=oto text=pick port=6002");
  peer_.say("73 sub create mode=oto text=pick");
  ASSERT_TRUE(peer_.line_with({"73 pub add", "port=6001"}));
  const std::string request = word({"requests", "text=pick"}, "subscription");
  const std::string worse = request.substr(0, request.rfind('/')) + "/72";
  const auto why = bench_.query({"why", request, worse});
  EXPECT_EQ(why.status, 1);
  EXPECT_THAT(why.out, StartsWith("no: they would match, and others are better"));
  const auto document = bench_.json({"why", request, worse});
  EXPECT_EQ(document.at("matches"), false);
  EXPECT_EQ(document.at("outranked"), true);
}

TEST_F(Query, SaysWhyNobodyAnswers) {
  peer_.say("5 sub create mode=otm/stream concept=soccer:SharedBallInfo where=\"rate > 60\"");
  EXPECT_THAT(peer_.lines_until_pong(), IsEmpty());
  const std::string request = word({"requests", "rate > 60"}, "subscription");
  const auto shown = bench_.query({"why", request});
  EXPECT_EQ(shown.status, 1) << shown.errors;
  EXPECT_THAT(shown.out, StartsWith("no: "));
  EXPECT_THAT(shown.out, HasSubstr("rate > 60 does not hold: rate is 30 (2 services are known)\nwhere: ask for less"));
  EXPECT_THAT(shown.out, HasSubstr("PROVIDER"));
  const auto document = bench_.json({"why", request});
  EXPECT_EQ(document.at("subscription").as_string(), request);
  EXPECT_EQ(document.at("served"), false);
  EXPECT_EQ(document.at("offers").as_int64(), 2);
  EXPECT_EQ(document.at("matching").as_int64(), 0);
  EXPECT_EQ(document.at("code"), "where");
  EXPECT_EQ(document.at("services").at(0).at("code"), "where");
  EXPECT_EQ(document.at("services").at(0).at("ok"), false);
  EXPECT_EQ(document.at("services").at(0).as_object().contains("attributes"), false);
  const auto served = bench_.query({"why", word({"requests", "rate > 10"}, "subscription")});
  EXPECT_EQ(served.status, 0);
  EXPECT_THAT(served.out, StartsWith("yes: 1 of the 2 services that are known meets it\n"));
}

TEST_F(Query, SaysWhyNobodyTakesAService) {
  const std::string ball = word({"services", "mode=otm/stream"}, "service");
  const std::string lonely = word({"services", "lonely"}, "service");
  const auto taken = bench_.query({"why", ball});
  EXPECT_EQ(taken.status, 0) << taken.errors;
  EXPECT_THAT(taken.out, StartsWith("yes: 1 of the 2 requests that are known takes it\n"));
  EXPECT_THAT(taken.out, HasSubstr("ASKS FOR"));
  EXPECT_EQ(bench_.query({"why", "--service", ball}).out, taken.out);
  const auto shown = bench_.query({"why", lonely});
  EXPECT_EQ(shown.status, 1) << shown.errors;
  EXPECT_THAT(shown.out,
              StartsWith("no: nobody asks for text=lonely (2 requests are known)\nnobody: start the module"));
  const auto document = bench_.json({"why", "--service", lonely});
  EXPECT_EQ(document.at("service").as_string(), lonely);
  EXPECT_EQ(document.at("used"), false);
  EXPECT_EQ(document.at("requests").as_int64(), 2);
  EXPECT_EQ(document.at("taken").as_int64(), 0);
  EXPECT_EQ(document.at("code"), "nobody");
  const auto imagined = bench_.json({"why", "--offer-concept", "soccer:BallInfo", "--offer-attribute", "rate=3"});
  EXPECT_EQ(imagined.at("code"), "where");
  EXPECT_EQ(imagined.at("offer").at("attr.rate"), "3");
  EXPECT_EQ(imagined.at("subscriptions").at(0).at("code"), "where");
  EXPECT_THAT(std::string(imagined.at("mend").as_string()), StartsWith("offer what its where asks for"));
  EXPECT_FALSE(imagined.as_object().contains("matches"));
  const auto neither = bench_.query({"why", "00000001/1/1"});
  EXPECT_EQ(neither.status, 1);
  EXPECT_THAT(neither.errors, HasSubstr("there is no subscription 00000001/1/1"));
}

TEST_F(Query, SaysInWordsWhyEachServiceIsUnused) {
  EXPECT_THAT(bench_.query({"services", "--unused"}).out, HasSubstr("nobody asks for text=lonely"));
  EXPECT_THAT(bench_.query({"services"}).out, Not(HasSubstr("WHY")));
  EXPECT_EQ(bench_.json({"services", "--unused"}).at(0).at("why"), "nobody");
  EXPECT_FALSE(bench_.json({"services", "lonely"}).at(0).as_object().contains("because"));
}

TEST_F(Query, SaysInWordsWhyEachRequestIsUnmatched) {
  peer_.say("5 sub create mode=otm/stream concept=soccer:SharedBallInfo match=exact protocol=tcp why=attribute");
  EXPECT_THAT(peer_.lines_until_pong(), IsEmpty());
  EXPECT_THAT(bench_.query({"requests", "--unmatched"}).out, HasSubstr("udp is none of tcp"));
  const auto unmatched = bench_.json({"requests", "--unmatched", "protocol=tcp"}).at(0).as_object();
  EXPECT_EQ(unmatched.at("why"), "protocol");
  EXPECT_THAT(std::string(unmatched.at("because").as_string()), HasSubstr("ask with protocol=udp too"));
  EXPECT_EQ(unmatched.at("attributes").at("why"), "attribute");
  EXPECT_THAT(bench_.query({"requests"}).out, Not(HasSubstr("WHY")));
  EXPECT_FALSE(bench_.json({"requests", "protocol=tcp"}).at(0).as_object().contains("because"));
}

TEST_F(Query, SaysWhatWouldBeIfSomebodyAskedOrOffered) {
  const std::string ball = word({"services", "mode=otm/stream"}, "service");
  const std::string request = word({"requests", "mode=otm/stream"}, "subscription");
  const auto yes = bench_.query({"why", "--concept", "soccer:TrackedObject", "--service", ball});
  EXPECT_EQ(yes.status, 0) << yes.errors;
  EXPECT_THAT(yes.out, StartsWith("yes: they match, degree narrower"));
  EXPECT_THAT(yes.out, HasSubstr("because\n  soccer:SharedBallInfo SubClassOf soccer:BallInfo\n"));
  const auto pair = bench_.json({"why", "--concept", "soccer:BallInfo", "--match", "exact", "--service", ball});
  EXPECT_EQ(pair.at("matches"), false);
  EXPECT_EQ(pair.at("code"), "degree");
  EXPECT_EQ(pair.at("service").as_string(), ball);
  EXPECT_EQ(pair.at("request").at("concept"), "soccer:BallInfo");
  EXPECT_TRUE(pair.at("checks").at(1).at("proof").is_array());
  const auto offered =
      bench_.query({"why", request, "--offer-concept", "soccer:BallInfo", "--offer-attribute", "rate=5"});
  EXPECT_EQ(offered.status, 1);
  EXPECT_THAT(offered.out, HasSubstr("\nwhere: ask for less in where"));
  const auto both = bench_.json({"why", "--text", "camera", "--offer-text", "camrea", "--offer-mode", "oto"});
  EXPECT_EQ(both.at("code"), "similar_text");
  EXPECT_EQ(both.at("offer").at("text"), "camrea");
  EXPECT_EQ(bench_.query({"why", "--id", "77"}).status, 1);
  EXPECT_EQ(bench_.json({"why", "--id", "77"}).at("code"), "nobody");
  EXPECT_EQ(bench_.query({"why", "--text", "lonely"}).status, 0);
  const auto mistyped = bench_.query({"why", "--concept", "soccer:BalInfo"});
  EXPECT_EQ(mistyped.status, 2);
  EXPECT_THAT(mistyped.errors, HasSubstr("did you mean soccer:BallInfo"));
  EXPECT_EQ(bench_.query({"why", "--concept", "soccer:BallInfo", "--mode", "otm"}).status, 2);
}

}  // namespace
}  // namespace geminga::tools
