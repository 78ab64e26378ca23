#include "discovery/gcnp/event.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "discovery/gcnp/way.hpp"

namespace geminga::gcnp {
namespace {

using testing::HasSubstr;

ServiceEvent service_event() {
  ServiceEvent event;
  event.service = {ParticipantId{0x1a2b3c4d}, PeerId{2}, 42};
  event.peer_name = "vision";
  event.participant_name = "robot 2";
  event.publication = {
      ConceptNames{"s:Ball", "s:Field"},         ChannelMode::one_to_many_stream, "10.0.0.2", 5000, "udp", -3,
      {{"camera", "front left"}, {"rate", "30"}}};
  event.degree = Degree::narrower;
  event.distance = 2;
  return event;
}

Event read(const std::string& line) {
  const auto reply = read_reply(std::string_view(line).substr(0, line.size() - 2));
  EXPECT_TRUE(reply) << line;
  return reply ? std::get<Event>(*reply) : Event{};
}

TEST(ServiceEvent, IsTheSameAfterWritingAndReading) {
  ServiceEvent event = service_event();
  for (const auto change : {Change::add, Change::modify}) {
    event.change = change;
    EXPECT_EQ(read(to_line(to_statement(7, event))), (Event{7, event}));
  }
}

TEST(ServiceEvent, OfAConvertedMatchSaysByWhichChainAndCost) {
  ServiceEvent event = service_event();
  event.degree = Degree::converted;
  event.convert = "s:Robot>s:Field";
  event.cost = 12;
  event.publication.attributes["cost"] = "3 euros";
  const std::string line = to_line(to_statement(7, event));
  EXPECT_THAT(line, HasSubstr(" convert=s:Robot>s:Field cost=12 "));
  EXPECT_THAT(line, HasSubstr(" attr.cost=\"3 euros\""));
  EXPECT_EQ(read(line), (Event{7, event}));
  // Without a conversion cost is the name of an attribute like any other.
  event.degree = Degree::narrower;
  event.convert.clear();
  event.cost = 0;
  const std::string other = to_line(to_statement(7, event));
  EXPECT_THAT(other, HasSubstr(" cost=\"3 euros\""));
  EXPECT_EQ(read(other), (Event{7, event}));
}

TEST(ServiceEvent, OfAConvertedMatchSaysWhoConverts) {
  ServiceEvent event = service_event();
  event.degree = Degree::converted;
  event.convert = "s:Pixels>s:Robot>s:Field";
  event.cost = 4;
  event.publication.attributes["via"] = "tunnel";
  const std::string without = to_line(to_statement(7, event));
  EXPECT_THAT(without, HasSubstr(" attr.via=tunnel"));
  event.via = "udp://10.0.0.7:6000/0000002a/1/1,-";
  const std::string line = to_line(to_statement(7, event));
  EXPECT_THAT(line, HasSubstr(" cost=4 via=udp://10.0.0.7:6000/0000002a/1/1,- "));
  EXPECT_THAT(line, HasSubstr(" attr.via=tunnel"));
  EXPECT_EQ(read(line), (Event{7, event}));
  EXPECT_TRUE(std::get<ServiceEvent>(read(without).what).via.empty());
  // Without a conversion via is the name of an attribute like any other.
  event.convert.clear();
  EXPECT_THAT(to_line(to_statement(7, event)), HasSubstr(" via=tunnel"));
}

TEST(ServiceEvent, OfADeletionHasServiceAndReasonOnly) {
  ServiceEvent event = service_event();
  event.change = Change::del;
  event.reason = "expired";
  EXPECT_EQ(to_line(to_statement(7, event)), "7 pub del service=1a2b3c4d/2/42 reason=expired\r\n");
  ServiceEvent bare;
  bare.change = Change::del;
  bare.service = event.service;
  bare.reason = "expired";
  EXPECT_EQ(read(to_line(to_statement(7, event))), (Event{7, bare}));
  EXPECT_EQ(read("7 pub del service=1a2b3c4d/2/42 reason=expired mode=oto protocol=tcp rate=30\r\n"), (Event{7, bare}));
}

TEST(ServiceEvent, HasNoReasonBeforeItsDeletion) {
  const auto event =
      read("7 pub add service=00000001/2/3 degree=exact distance=0 mode=oto port=1 id=1 reason=left\r\n");
  EXPECT_EQ(std::get<ServiceEvent>(event.what).reason, "");
}

TEST(ConsumerEvent, IsTheSameAfterWritingAndReading) {
  ConsumerEvent event;
  event.subscription = {ParticipantId{1}, PeerId{3}, 4};
  event.peer_name = "world";
  event.subscribed.identity = TextIdentity{"ball"};
  event.subscribed.mode = ChannelMode::one_to_many_pubsub;
  event.subscribed.port = 9;
  event.subscribed.address = "::1";
  event.subscribed.attributes = {{"a", ""}};
  EXPECT_EQ(read(to_line(to_statement(7, event))), (Event{7, event}));
}

TEST(Reply, IsAnErrorWhereThreeDigitsFollowTheId) {
  EXPECT_EQ(std::get<Event>(*read_reply("7 422 say \"what\" = \x01 now")),
            (Event{7, Error{ErrorCode::impossible, "say \"what\" = ? now"}}));
  EXPECT_EQ(std::get<Event>(*read_reply("7 503")), (Event{7, Error{ErrorCode::not_ready, ""}}));
}

TEST(Reply, IsAMessageWhereItIsNoEvent) {
  const auto reply = read_reply("7 msg end count=3");
  ASSERT_TRUE(reply);
  EXPECT_EQ(std::get<Statement>(*reply), (Statement{7, "msg", "end", {{"count", "3"}}}));
}

TEST(Reply, TakesUnknownKeysOfAnEventForAttributes) {
  const auto event = read("7 pub add service=00000001/2/3 degree=exact distance=0 mode=oto port=1 id=1 novelty=5\r\n");
  EXPECT_THAT(std::get<ServiceEvent>(event.what).publication.attributes,
              testing::ElementsAre(testing::Pair("novelty", "5")));
}

TEST(Reply, SaysWhichPartOfAnEventCannotBeRead) {
  for (const auto& [line, what] :
       std::vector<std::pair<std::string, std::string>>{{"7 pub add degree=exact mode=oto", "service"},
                                                        {"7 pub add service=1 degree=exact mode=oto", "service"},
                                                        {"7 pub add service=00000001/2/3 mode=oto", "degree"},
                                                        {"7 pub add service=00000001/2/3 degree=exact mode=x", "mode"},
                                                        {"7 sub del reason=left", "subscription"},
                                                        {"hello", "octet 1"}}) {
    const auto reply = read_reply(line);
    ASSERT_FALSE(reply) << line;
    EXPECT_THAT(reply.error().text, HasSubstr(what)) << line;
  }
}

TEST(PeerWord, NamesParticipantAndPeer) { EXPECT_EQ(peer_word({ParticipantId{0xabc}, PeerId{12}, 9}), "00000abc/12"); }

TEST(Way, StandsBesideAttributesOfItsKeys) {
  Statement statement{
      .id = 1, .command = "pub", .subcommand = "add", .parameters = {{"path", "/camera"}, {"rate", "30"}}};
  append_way(statement.parameters, {});
  EXPECT_EQ(to_line(statement), "1 pub add path=/camera rate=30\r\n");
  append_way(statement.parameters, {.hops = 0, .path = "", .is_reachable = false});
  EXPECT_EQ(to_line(statement), "1 pub add path=/camera rate=30 reachable=no\r\n");
  statement.parameters.pop_back();
  append_way(statement.parameters, {.hops = 2, .path = "base/left tower", .is_reachable = false});
  EXPECT_EQ(to_line(statement), "1 pub add attr.path=/camera rate=30 hops=2 path=\"base/left tower\" reachable=no\r\n");
}

TEST(Way, IsNoAttributeOfAnEvent) {
  const auto event_of = [](std::string_view rest) {
    const auto reply =
        read_reply("1 pub add service=00000001/1/1 id=1 degree=exact mode=oto port=5 " + std::string(rest));
    return std::get<ServiceEvent>(std::get<Event>(*reply).what);
  };
  const ServiceEvent far = event_of("attr.hops=9 attr.path=/left rate=30 hops=2 path=base/tower reachable=no");
  EXPECT_EQ(far.hops, 2U);
  EXPECT_EQ(far.path, "base/tower");
  EXPECT_FALSE(far.reachable);
  EXPECT_EQ(far.publication.attributes, (Attributes{{"hops", "9"}, {"path", "/left"}, {"rate", "30"}}));
  const ServiceEvent near = event_of("path=/left attr.reachable=no");
  EXPECT_EQ(near.hops, 0U);
  EXPECT_EQ(near.path, "");
  EXPECT_TRUE(near.reachable);
  EXPECT_EQ(near.publication.attributes, (Attributes{{"path", "/left"}, {"reachable", "no"}}));
}

}  // namespace
}  // namespace geminga::gcnp
