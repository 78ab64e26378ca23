// The site without sockets: paths, documents, health, and events.
#include "web/site/site.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tools/web/fake_asker.hpp"
#include "web/site/event_stream.hpp"
#include "web/site/health.hpp"

namespace geminga::web {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

struct SiteTest : testing::Test {
  Response get(const std::string& target, const std::string& accept = "") {
    std::vector<Response> responses;
    site.answer({.method = "GET", .target = target, .hosts = {"localhost"}, .authorizations = {}, .accept = accept},
                [&](Response response) { responses.push_back(std::move(response)); });
    EXPECT_THAT(responses, SizeIs(1)) << target;
    return responses.empty() ? Response{} : responses.front();
  }

  FakeAsker asker;
  History history{asker, std::chrono::seconds(0)};
  Site site{asker, history, {}};
};

TEST_F(SiteTest, LivesWithoutADaemon) {
  EXPECT_EQ(get("/livez").status, 200U);
  EXPECT_EQ(get("/readyz").status, 503U);
  EXPECT_EQ(get("/readyz").body, "nobody is there\n");
  const Response metrics = get("/metrics");
  EXPECT_EQ(metrics.status, 200U);
  EXPECT_EQ(metrics.type, "application/openmetrics-text; version=1.0.0; charset=utf-8");
  EXPECT_THAT(metrics.body, HasSubstr("\ngeminga_up 0\n"));
  EXPECT_EQ(get("/metrics", "text/plain").type, "text/plain; version=0.0.4; charset=utf-8");
  EXPECT_EQ(get("/api/status").status, 503U);
}

TEST_F(SiteTest, KnowsNoOtherPaths) {
  for (const char* target : {"/page.html", "/index.html", "/../etc/passwd", "/livez/", "/Metrics", "/api", "/api/",
                             "/api/doctor", "/api/status/", "/api/..", "/%2e%2e/etc/passwd"}) {
    EXPECT_EQ(get(target).status, 404U) << target;
  }
  EXPECT_THAT(asker.asked, IsEmpty());
}

TEST_F(SiteTest, ServesThePageWithAPolicyOfHashes) {
  const Response response = get("/");
  EXPECT_EQ(response.status, 200U);
  EXPECT_EQ(response.type, "text/html; charset=utf-8");
  EXPECT_THAT(response.body, StartsWith("<!doctype html>"));
  EXPECT_THAT(response.body, HasSubstr("</html>"));
  ASSERT_THAT(response.fields, SizeIs(1));
  EXPECT_EQ(response.fields[0].first, "Content-Security-Policy");
  EXPECT_THAT(response.fields[0].second, StartsWith("default-src 'none'; script-src 'sha256-"));
  EXPECT_THAT(response.fields[0].second, HasSubstr("frame-ancestors 'none'"));
  EXPECT_THAT(response.fields[0].second, Not(HasSubstr("unsafe")));
  EXPECT_EQ(get("/?a=1").status, 400U);
  EXPECT_THAT(asker.asked, IsEmpty());
}

TEST_F(SiteTest, TakesTheKeysOfAQuestionAndNoOthers) {
  for (const char* target :
       {"/api/status?x=1", "/api/services?unmatched=1", "/api/requests?unused=1", "/api/match?concept=",
        "/api/match?limt=3", "/api/why?attr.=1", "/api/why?attr.a%20b=1", "/livez?a", "/metrics?a=1",
        "/api/events?of=status", "/api/events", "/api/events?of=services&x=1", "/api/events?of=services,services",
        "/api/events?of=services,", "/api/events?of=services,requests&text=x", "/api/match?%0a=1"}) {
    EXPECT_EQ(get(target).status, 400U) << target;
  }
  EXPECT_THAT(asker.asked, IsEmpty());
  asker.outcomes["why"] = answered({});
  EXPECT_EQ(get("/api/why?concept=a:B&offer.attr.rate=30").status, 200U);
  EXPECT_THAT(asker.asked, ElementsAre(Query{"why", {{"concept", "a:B"}, {"offer.attr.rate", "30"}}}));
}

TEST_F(SiteTest, GivesTheDoctorsDocumentLaterOrWhyThereIsNone) {
  EXPECT_EQ(get("/api/doctor").status, 404U) << "there is none";
  std::vector<std::function<void(const Result<boost::json::value, ClientError>&)>> waiting;
  Site examined(asker, history, {}, [&](auto then) { waiting.push_back(std::move(then)); });
  std::vector<Response> responses;
  const auto ask = [&](const char* target) {
    examined.answer({.method = "GET", .target = target, .hosts = {"localhost"}, .authorizations = {}, .accept = ""},
                    [&](const Response& response) { responses.push_back(response); });
  };
  ask("/api/doctor");
  ask("/api/doctor");
  ask("/api/doctor?with=robot2");
  ASSERT_THAT(waiting, SizeIs(2));
  waiting[0](boost::json::value{{"findings", boost::json::array()}});
  waiting[1](std::unexpected(ClientError{ClientError::Kind::closed, "the daemon is gone"}));
  ASSERT_THAT(responses, SizeIs(3));
  EXPECT_EQ(responses[0].status, 400U);
  EXPECT_EQ(responses[1].body, "{\"findings\":[]}\n");
  EXPECT_EQ(responses[2].status, 503U);
}

TEST_F(SiteTest, AnswersWithTheDaemonsCode) {
  const std::vector<std::pair<ErrorCode, unsigned>> codes{
      {ErrorCode::malformed, 400}, {ErrorCode::unknown_request, 404},
      {ErrorCode::too_large, 413}, {ErrorCode::impossible, 422},
      {ErrorCode::too_many, 429},  {ErrorCode::not_ready, 503},
      {ErrorCode{200}, 502},       {ErrorCode{999}, 502}};
  for (const auto& [code, status] : codes) {
    asker.outcomes["match"] = failed(ClientError::Kind::refused, "no", code);
    EXPECT_EQ(get("/api/match?text=a").status, status);
  }
  asker.outcomes["match"] = failed(ClientError::Kind::timed_out, "late");
  EXPECT_EQ(get("/api/match?text=a").status, 504U);
  EXPECT_EQ(get("/api/match?text=a").body, "{\"error\":\"late\"}\n");
}

TEST_F(SiteTest, WaitsForTheDaemonWithoutHoldingOthersUp) {
  asker.is_held = true;
  std::vector<std::string> bodies;
  const auto ask = [&](const char* target) {
    site.answer({.method = "GET", .target = target, .hosts = {"localhost"}, .authorizations = {}, .accept = ""},
                [&](const Response& response) { bodies.push_back(response.body); });
  };
  ask("/metrics");
  ask("/readyz");
  EXPECT_THAT(bodies, IsEmpty());
  ask("/livez");
  EXPECT_THAT(bodies, ElementsAre("ok\n"));
  asker.outcomes["status"] = answered({record("status", {{"state", "ready"}})});
  asker.release();
  EXPECT_THAT(bodies, ElementsAre("ok\n", HasSubstr("\ngeminga_up 1\n"), "ok\n"));
}

TEST(Readiness, IsThatOfADaemonThatIsUpToDate) {
  const auto reason = [](std::vector<std::pair<std::string, std::string>> fields) {
    return unreadiness(*answered({record("status", std::move(fields))}));
  };
  EXPECT_EQ(reason({{"state", "ready"}}), "");
  EXPECT_EQ(reason({{"state", "ready"}, {"ontology_loading", "0"}}), "");
  EXPECT_THAT(reason({{"state", "claiming"}}), HasSubstr("claiming"));
  EXPECT_THAT(reason({}), HasSubstr("silent"));
  EXPECT_THAT(reason({{"state", "ready"}, {"ontology_loading", "1"}}), HasSubstr("being read"));
  EXPECT_THAT(reason({{"state", "ready"}, {"ontology_failed", "a.ttl:3: no"}}), HasSubstr("a.ttl:3: no"));
  EXPECT_THAT(reason({{"state", "ready"}, {"configuration_failed", "line 2"}}), HasSubstr("line 2"));
  EXPECT_THAT(reason({{"state", "ready"}, {"ontology_contradiction", "1"}}), HasSubstr("contradicts"));
  EXPECT_THAT(unreadiness(*answered({})), Not(IsEmpty())) << "an answer without a line is none";
}

struct Events : SiteTest {
  Record service(const char* key, const char* port) {
    return record("services", {{"service", key}, {"port", port}, {"age", "1.000"}});
  }
  std::string next(EventStream& stream) {
    std::string events;
    stream.next([&](std::string text) { events = std::move(text); });
    return events;
  }
};

TEST_F(Events, AreAllThatIsThereAndThenTheDifferences) {
  asker.outcomes["services"] = answered({service("a/1/1", "5000")});
  const Response response = get("/api/events?of=services");
  ASSERT_TRUE(response.stream);
  EXPECT_EQ(response.type, "text/event-stream");
  const std::string first = next(*response.stream);
  EXPECT_THAT(first, StartsWith("data: {\"event\":\"add\",\"time\":\""));
  EXPECT_THAT(first, HasSubstr("\"service\":\"a/1/1\",\"port\":5000"));
  EXPECT_THAT(first, testing::EndsWith("}\n\n"));
  EXPECT_EQ(next(*response.stream), "");
  asker.outcomes["services"] = answered({service("a/1/1", "5001"), service("b/1/1", "7")});
  const std::string changed = next(*response.stream);
  EXPECT_THAT(changed, HasSubstr("\"event\":\"modify\""));
  EXPECT_THAT(changed, HasSubstr("\"former\":{\"port\":5000}"));
  EXPECT_THAT(changed, HasSubstr("\"event\":\"add\""));
  asker.outcomes["participants"] = answered({record("participants", {{"id", "a"}})});
  asker.outcomes["services"] = answered({});
  const std::string gone = next(*response.stream);
  EXPECT_THAT(gone, HasSubstr("\"reason\":\"withdrawn\",\"service\":\"a/1/1\""));
  EXPECT_THAT(gone, HasSubstr("\"reason\":\"gone\",\"service\":\"b/1/1\""));
}

TEST_F(Events, SayThatTheDaemonIsAwayAndBringTheReaderUpToDate) {
  asker.outcomes["services"] = answered({service("a/1/1", "5000")});
  const Response response = get("/api/events?of=services");
  EXPECT_THAT(next(*response.stream), HasSubstr("add"));
  asker.outcomes["services"] = failed(ClientError::Kind::closed, "the daemon is gone");
  EXPECT_EQ(next(*response.stream), "event: daemon\ndata: {\"up\":false,\"reason\":\"the daemon is gone\"}\n\n");
  EXPECT_EQ(next(*response.stream), "");
  asker.outcomes["services"] = answered({service("b/1/1", "5000")});
  const std::string events = next(*response.stream);
  EXPECT_THAT(events, StartsWith("event: daemon\ndata: {\"up\":true}\n\ndata: {\"event\":\"del\""));
  EXPECT_THAT(events, HasSubstr("\"event\":\"add\""));
}

TEST_F(Events, OfSeveralListingsHaveTheirNamesAndSayWhenAllWasTold) {
  asker.outcomes["participants"] = failed(ClientError::Kind::closed, "the daemon is gone");
  asker.outcomes["services"] = answered({service("a/1/1", "5000")});
  const Response response = get("/api/events?of=participants,services");
  ASSERT_TRUE(response.stream);
  EXPECT_EQ(next(*response.stream), "event: daemon\ndata: {\"up\":false,\"reason\":\"the daemon is gone\"}\n\n");
  asker.outcomes["participants"] = answered({record("participants", {{"id", "a"}})});
  const std::string first = next(*response.stream);
  EXPECT_THAT(first, StartsWith("event: daemon\ndata: {\"up\":true}\n\nevent: participants\ndata: {\"event\":\"add\""));
  EXPECT_THAT(first, HasSubstr("event: services\ndata: {\"event\":\"add\""));
  EXPECT_THAT(first, testing::EndsWith("event: whole\ndata: {}\n\n"));
  EXPECT_EQ(next(*response.stream), "");
  asker.outcomes["services"] = answered({});
  EXPECT_THAT(next(*response.stream), StartsWith("event: services\ndata: {\"event\":\"del\""));
}

TEST_F(Events, AreRefusedWhereTheQuestionIs) {
  asker.outcomes["services"] = failed(ClientError::Kind::refused, "unknown concept", ErrorCode::impossible);
  const Response response = get("/api/events?of=services&concept=x:Y");
  EXPECT_EQ(response.status, 422U);
  EXPECT_FALSE(response.stream);
}

}  // namespace
}  // namespace geminga::web
