// Nodes against a scripted daemon: what they say to it, and what flows between two of them on this host.
#include "geminga/node.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <chrono>
#include <string>

#include "client/cpp/deadline.hpp"
#include "client/scripted_daemon.hpp"

namespace geminga::client {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::StartsWith;

/// Far longer than anything here takes.
constexpr auto patience = 30s;

Node node_at(const ScriptedDaemon& daemon) {
  auto node = Node::open({daemon.address(), "test", patience});
  if (!node) throw std::runtime_error(node.error().text);
  return std::move(*node);
}

NamedPublication offer(ChannelMode mode, const std::string& protocol) {
  NamedPublication publication;
  publication.identity = TextIdentity{"ball"};
  publication.mode = mode;
  publication.protocol = protocol;
  return publication;
}

NamedSubscription wish(ChannelMode mode) {
  NamedSubscription subscription;
  subscription.identity = TextIdentity{"ball"};
  subscription.mode = mode;
  return subscription;
}

/// Answers a node that offers (1) and asks (2) for the same service: each is told of the other.
void introduce(Conversation& talk) {
  talk.welcome();
  const std::string pub = talk.hear();
  talk.expect("0 sys ping");
  talk.say("0 msg pong");
  const std::string sub = talk.hear();
  talk.expect("0 sys ping");
  const std::string mode = field(pub, "mode");
  const std::string protocol = field(pub, "protocol").empty() ? "udp" : field(pub, "protocol");
  talk.say("2 pub add service=5e6f7a8b/2/1 provider=5e6f7a8b/2 text=ball degree=exact distance=0 mode=" + mode +
           " address=127.0.0.1 port=" + field(pub, "port") + " protocol=" + protocol +
           " priority=0 participant_name=robot2 channel=" + field(pub, "channel"));
  if (mode != "otm/stream") {
    talk.say("1 sub add subscription=5e6f7a8b/2/2 consumer=5e6f7a8b/2 text=ball degree=exact distance=0 mode=" + mode +
             " address=127.0.0.1 port=" + field(sub, "port") +
             " priority=0 participant_name=robot2 channel=" + field(sub, "channel"));
  }
  talk.say("0 msg pong");
}

/// The same, and takes a further request that nobody meets.
void introduce_and_admit_another(Conversation& talk) {
  introduce(talk);
  talk.hear();
  talk.expect("0 sys ping");
  talk.say("0 msg pong");
  talk.wait_for_end();
}

/// Drives the node until an event of this kind comes.
template <typename Kind>
std::optional<Kind> next(Node& node) {
  while (auto event = node.next_event(patience)) {
    if (auto* wanted = std::get_if<Kind>(&*event)) return std::move(*wanted);
  }
  return std::nullopt;
}

std::string text_of(const Message& message) {
  return {reinterpret_cast<const char*>(message.payload.data()), message.payload.size()};
}

/// The same, and says that the publication is withdrawn when it is.
void introduce_and_part(Conversation& talk) {
  introduce(talk);
  talk.expect("1 pub remove");
  talk.say("2 pub del service=5e6f7a8b/2/1 reason=withdrawn");
  talk.wait_for_end();
}

class NodeTest : public testing::TestWithParam<std::pair<ChannelMode, const char*>> {};

TEST_P(NodeTest, SendsToWhoAsked) {
  const auto [mode, protocol] = GetParam();
  ScriptedDaemon daemon(introduce_and_part);
  Node node = node_at(daemon);
  auto publisher = node.publish(offer(mode, protocol));
  ASSERT_TRUE(publisher) << publisher.error().text;
  auto subscriber = node.subscribe(wish(mode));
  ASSERT_TRUE(subscriber) << subscriber.error().text;
  EXPECT_EQ(next<ProviderChange>(node)->life, publisher->life());
  // A provider of a stream is not told of its listeners, so messages are sent until one is heard.
  std::optional<Message> message;
  while (!message) {
    EXPECT_TRUE(publisher->send("hello"));
    message = subscriber->receive(10ms);
  }
  EXPECT_EQ(text_of(*message), "hello");
  EXPECT_EQ(message->life, publisher->life());
  while (subscriber->receive(0ms)) continue;
  const auto last = publisher->count().sent;
  EXPECT_TRUE(publisher->send(""));
  message = subscriber->receive(patience);
  ASSERT_TRUE(message);
  EXPECT_EQ(message->sequence, last + 1);
  EXPECT_EQ(message->missed, 0U);
  // Small ones are copied on their way and large ones are not.
  for (const std::size_t size : {std::size_t{8191}, std::size_t{8192}, std::size_t{8193}, std::size_t{65'000}}) {
    std::string payload(size, 'x');
    payload.front() = 'a';
    payload.back() = 'z';
    EXPECT_TRUE(publisher->send(payload));
    message = subscriber->receive(patience);
    ASSERT_TRUE(message);
    EXPECT_TRUE(text_of(*message) == payload) << size;
  }
  publisher->withdraw();
  const auto removed = next<ProviderChange>(node);
  ASSERT_TRUE(removed);
  EXPECT_EQ(removed->what, ProviderChange::What::removed);
  EXPECT_EQ(removed->reason, "withdrawn");
  EXPECT_FALSE(publisher->send("late"));
}

INSTANTIATE_TEST_SUITE_P(AllModes, NodeTest,
                         testing::Values(std::pair{ChannelMode::one_to_one, "udp"},
                                         std::pair{ChannelMode::one_to_one, "tcp"},
                                         std::pair{ChannelMode::one_to_many_pubsub, "udp"},
                                         std::pair{ChannelMode::one_to_many_pubsub, "tcp"},
                                         std::pair{ChannelMode::one_to_many_stream, "udp"},
                                         std::pair{ChannelMode::one_to_many_stream, "tcp"}));

TEST(Node, CostsNothingWithoutAConsumer) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.welcome();
    talk.hear();
    talk.hear();
    talk.say("0 msg pong");
    talk.wait_for_end();
  });
  Node node = node_at(daemon);
  auto publisher = node.publish(offer(ChannelMode::one_to_many_pubsub, "udp"));
  ASSERT_TRUE(publisher);
  EXPECT_TRUE(publisher->send("nobody hears this"));
  EXPECT_EQ(publisher->count().sent, 0U);
}

TEST(Node, RefusesMessagesOverTheLimitOfTheirProtocol) {
  for (const auto& [protocol, limit] : {std::pair{"udp", 65'000UL}, std::pair{"tcp", 16UL * 1024 * 1024}}) {
    ScriptedDaemon daemon([](Conversation& talk) {
      introduce(talk);
      talk.wait_for_end();
    });
    Node node = node_at(daemon);
    auto publisher = node.publish(offer(ChannelMode::one_to_one, protocol));
    auto subscriber = node.subscribe(wish(ChannelMode::one_to_one));
    ASSERT_TRUE(next<ConsumerChange>(node));
    const auto sent = publisher->send(std::string(limit + 1, 'x'));
    ASSERT_FALSE(sent);
    EXPECT_EQ(sent.error().kind, SendError::Kind::too_large);
    if (limit == 65'000) {
      EXPECT_THAT(sent.error().text, HasSubstr("protocol=tcp"));
    }
    for (const std::size_t size : {limit - 1, limit}) {
      EXPECT_TRUE(publisher->send(std::string(size, 'x')));
      const auto message = subscriber->receive(patience);
      ASSERT_TRUE(message) << protocol << size;
      EXPECT_EQ(message->payload.size(), size);
      EXPECT_TRUE(publisher->wait_for_room(size, patience));
    }
  }
}

TEST(Node, StatesItsRequestsToTheNextDaemonAndGoesOnMeanwhile) {
  ScriptedDaemon daemon(std::vector<ScriptedDaemon::Script>{
      [&](Conversation& talk) {
        introduce(talk);
        talk.hear();  // nothing more, but the end of this daemon is the test's: a modify says when
      },
      [&](Conversation& talk) {
        talk.welcome();
        EXPECT_THAT(talk.hear(), StartsWith("1 pub create "));
        EXPECT_THAT(talk.hear(), StartsWith("2 sub create "));
        talk.expect("0 sys ping");
        talk.say("0 msg pong");
        talk.wait_for_end();
      }});
  Node node = node_at(daemon);
  auto publisher = node.publish(offer(ChannelMode::one_to_one, "tcp"));
  auto subscriber = node.subscribe(wish(ChannelMode::one_to_one));
  ASSERT_TRUE(next<ConsumerChange>(node));
  EXPECT_TRUE(publisher->send("before"));
  EXPECT_EQ(text_of(*subscriber->receive(patience)), "before");
  PublicationChange change;
  change.priority = 3;
  EXPECT_TRUE(publisher->modify(change, Wait::for_nothing));
  ASSERT_TRUE(next<Disconnected>(node));
  EXPECT_TRUE(publisher->send("between"));
  EXPECT_EQ(text_of(*subscriber->receive(patience)), "between");
  ASSERT_TRUE(next<Connected>(node));
  EXPECT_TRUE(publisher->send("after"));
  const auto message = subscriber->receive(patience);
  ASSERT_TRUE(message);
  EXPECT_EQ(text_of(*message), "after");
  EXPECT_EQ(message->missed, 0U);
}

TEST(Node, GivesARefusalToTheCallThatAsked) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.welcome();
    talk.hear();
    talk.hear();
    talk.say("1 422 concept=s:Bal is not known");
    talk.say("0 msg pong");
    talk.wait_for_end();
  });
  Node node = node_at(daemon);
  const auto publisher = node.publish(offer(ChannelMode::one_to_one, "udp"));
  ASSERT_FALSE(publisher);
  EXPECT_EQ(publisher.error().kind, ClientError::Kind::refused);
  EXPECT_EQ(publisher.error().code, ErrorCode::impossible);
}

TEST(Node, RefusesAPortThatIsTakenAndAnAttributeOfItsOwn) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.welcome();
    talk.wait_for_end();
  });
  Node node = node_at(daemon);
  auto taken = offer(ChannelMode::one_to_one, "tcp");
  taken.address = "127.0.0.1";
  taken.port = daemon.port();
  EXPECT_EQ(node.publish(taken).error().kind, ClientError::Kind::wrong_use);
  auto stated = offer(ChannelMode::one_to_one, "udp");
  stated.attributes["channel"] = "0123456789abcdef";
  EXPECT_EQ(node.publish(stated).error().kind, ClientError::Kind::wrong_use);
}

TEST(Node, OffersWithoutADaemon) {
  auto node = Node::open({"127.0.0.1:" + std::to_string(free_port()), "test", patience});
  ASSERT_TRUE(node);
  const auto publisher = node->publish(offer(ChannelMode::one_to_one, "udp"));
  EXPECT_TRUE(publisher) << "it is stated when there is one";
  EXPECT_FALSE(node->is_connected());
}

TEST(Deadline, MayBeForEver) {
  using Clock = std::chrono::steady_clock;
  EXPECT_EQ(deadline_after(std::chrono::milliseconds::max()), Clock::time_point::max());
  EXPECT_LT(deadline_after(1h), Clock::time_point::max());
  EXPECT_GT(deadline_after(1h), Clock::now());
}

TEST(Node, AsksForTheRoomThatItNeeds) {
  for (const std::uint32_t room : {0U, 10'000U}) {
    ScriptedDaemon daemon([room](Conversation& talk) {
      talk.expect(room == 0 ? "0 sys hello keys=yes" : "0 sys hello room=10000 keys=yes");
      talk.say("0 msg hello version=1 participant=1a2b3c4d peer=3 ontology=- participant_name=robot2");
      talk.wait_for_end();
    });
    ClientOptions options;
    options.connect = daemon.address();
    options.room = room;
    auto node = Node::open(options);
    ASSERT_TRUE(node);
    EXPECT_TRUE(next<Connected>(*node));
  }
}

TEST(Node, ReadsNoAddressThatIsNone) {
  EXPECT_EQ(Node::open({"robot2", "", patience}).error().kind, ClientError::Kind::wrong_use);
}

TEST(Node, IsReadableWhereACallHasReadWhatNobodyHasTaken) {
  ScriptedDaemon daemon(introduce_and_admit_another);
  Node node = node_at(daemon);
  const auto is_readable = [&node] {
    pollfd waiting{node.descriptor(), POLLIN, 0};
    return ::poll(&waiting, 1, 0) > 0;
  };
  auto publisher = node.publish(offer(ChannelMode::one_to_one, "udp"));
  auto subscriber = node.subscribe(wish(ChannelMode::one_to_one));
  auto other = node.subscribe(wish(ChannelMode::one_to_one));
  ASSERT_TRUE(other);
  ASSERT_TRUE(next<ConsumerChange>(node));
  while (node.next_event()) continue;
  while (is_readable()) node.process();
  EXPECT_TRUE(publisher->send("to the one"));
  EXPECT_FALSE(other->receive(0ms)) << "but it has read for the one";
  EXPECT_FALSE(other->receive(0ms));
  EXPECT_TRUE(is_readable());
  node.process();
  EXPECT_FALSE(is_readable()) << "who has been told looks";
  EXPECT_EQ(text_of(*subscriber->receive(0ms)), "to the one");
  EXPECT_FALSE(subscriber->receive(0ms));
  EXPECT_FALSE(is_readable());
}

TEST(Node, DoesNotWaitWhereACallHasReadWhatNobodyHasTaken) {
  ScriptedDaemon daemon(introduce_and_admit_another);
  Node node = node_at(daemon);
  auto publisher = node.publish(offer(ChannelMode::one_to_one, "udp"));
  auto subscriber = node.subscribe(wish(ChannelMode::one_to_one));
  auto other = node.subscribe(wish(ChannelMode::one_to_one));
  ASSERT_TRUE(next<ConsumerChange>(node));
  while (node.next_event()) continue;
  EXPECT_TRUE(publisher->send("to the one"));
  EXPECT_FALSE(other->receive(0ms));
  node.wait(std::chrono::hours(1));
  EXPECT_EQ(text_of(*subscriber->receive(0ms)), "to the one");
}

TEST(Node, HandsMessagesAndEventsToCallbacks) {
  ScriptedDaemon daemon([](Conversation& talk) {
    introduce(talk);
    talk.wait_for_end();
  });
  int providers = 0;  // as `messages`, made first: the end of a subscriber is an event, too
  std::vector<std::string> messages;
  Node node = node_at(daemon);
  auto publisher = node.publish(offer(ChannelMode::one_to_one, "udp"));
  auto subscriber = node.subscribe(wish(ChannelMode::one_to_one));
  node.on_event([&](const ChannelEvent& event) { providers += std::holds_alternative<ProviderChange>(event) ? 1 : 0; });
  subscriber->on_message([&](const Message& message) { messages.push_back(text_of(message)); });
  while (publisher->count().sent == 0) {
    node.wait(10ms);
    EXPECT_TRUE(publisher->send("hello"));
  }
  while (messages.empty()) node.wait(patience);
  EXPECT_EQ(messages.front(), "hello");
  EXPECT_EQ(providers, 1);
}

}  // namespace
}  // namespace geminga::client
