// The C++ client against a scripted daemon: what it sends, what it makes of answers, and every way in which it can
// fail.
#include "geminga/client.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <chrono>
#include <cstdlib>

#include "client/scripted_daemon.hpp"

namespace geminga::client {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

constexpr std::string_view added =
    "1 pub add service=5e6f7a8b/2/9 provider=5e6f7a8b/2 name=vision id=7 degree=exact distance=0 mode=otm/stream "
    "address=10.0.0.2 port=5000 protocol=udp priority=0 participant_name=robot5 rate=30";

Client connected(const ScriptedDaemon& daemon) {
  auto client = Client::connect({daemon.address(), "test", 10s});
  if (!client) throw std::runtime_error(client.error().text);
  return std::move(*client);
}

NamedSubscription some_subscription() {
  NamedSubscription subscription;
  subscription.mode = ChannelMode::one_to_many_stream;
  subscription.identity = NumericIdentity{7};
  return subscription;
}

TEST(Client, SaysHelloAndLearnsWhoIsThere) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.expect("0 sys hello name=\"left eye\"");
    talk.say("0 msg hello version=1 participant=1a2b3c4d peer=3 name=\"left eye\" ontology=- participant_name=robot2");
    talk.expect("");
  });
  const auto client = Client::connect({daemon.address(), "left eye", 10s});
  ASSERT_TRUE(client) << client.error().text;
  EXPECT_EQ(client->welcome().participant, ParticipantId{0x1a2b3c4d});
  EXPECT_EQ(client->welcome().peer, PeerId{3});
  EXPECT_EQ(client->welcome().participant_name, "robot2");
  EXPECT_EQ(client->welcome().ontology, "-");
}

TEST(Client, PublishesModifiesAndWithdraws) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.welcome();
    for (const char* line : {"1 pub create mode=oto concept=s:Ball representation=s:Field port=5000 rate=30",
                             "1 pub modify port=5001 rate=15", "1 pub remove"}) {
      talk.expect(line);
      talk.expect("0 sys ping");
      talk.say("0 msg pong");
    }
  });
  Client client = connected(daemon);
  NamedPublication publication;
  publication.identity = ConceptNames{"s:Ball", "s:Field"};
  publication.port = 5000;
  publication.attributes = {{"rate", "30"}};
  const auto request = client.publish(publication);
  ASSERT_TRUE(request) << request.error().text;
  EXPECT_EQ(*request, 1U);
  PublicationChange change;
  change.port = 5001;
  change.attributes = {{"rate", "15"}};
  EXPECT_TRUE(client.modify(*request, change));
  EXPECT_TRUE(client.withdraw(*request));
}

TEST(Client, WithdrawsASubscriptionAsOne) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.welcome();
    for (const char* line : {"1 sub create mode=otm/stream id=7", "1 sub modify match=broader", "1 sub remove"}) {
      talk.expect(line);
      talk.expect("0 sys ping");
      talk.say("0 msg pong");
    }
  });
  Client client = connected(daemon);
  const auto request = client.subscribe(some_subscription());
  ASSERT_TRUE(request);
  SubscriptionChange change;
  change.weakest = Degree::broader;
  EXPECT_TRUE(client.modify(*request, change));
  EXPECT_TRUE(client.withdraw(*request));
}

TEST(Client, RefusesToWithdrawWhatIsNotThereWithoutAsking) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.welcome();
    talk.expect("");
  });
  Client client = connected(daemon);
  const auto withdrawn = client.withdraw(17);
  ASSERT_FALSE(withdrawn);
  EXPECT_EQ(withdrawn.error().kind, ClientError::Kind::wrong_use);
}

TEST(Client, GivesARefusalToTheCallThatCausedItAndGoesOn) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.welcome();
    talk.hear();
    talk.hear();
    talk.say("1 422 s:Bal is not known: did you mean \"s:Ball\"?");
    talk.say("0 msg pong");
    talk.expect("2 sub create mode=otm/stream id=7");
    talk.hear();
    talk.say("0 msg pong");
  });
  Client client = connected(daemon);
  const auto refused = client.subscribe(some_subscription());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ClientError::Kind::refused);
  EXPECT_EQ(refused.error().code, ErrorCode::impossible);
  EXPECT_EQ(refused.error().text, "s:Bal is not known: did you mean \"s:Ball\"?");
  EXPECT_TRUE(client.subscribe(some_subscription()));
}

TEST(Client, KeepsEventsThatComeWhileItWaitsInTheirOrder) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.welcome();
    talk.hear();
    talk.hear();
    talk.say(added);
    talk.say("0 msg pong");
    talk.say("1 pub del service=5e6f7a8b/2/9 reason=left");
    talk.say("1 422 soccer:Ball is not known any more");
    talk.wait_for_end();
  });
  Client client = connected(daemon);
  ASSERT_TRUE(client.subscribe(some_subscription()));
  const auto first = client.next_event(10s);
  ASSERT_TRUE(first && *first);
  EXPECT_EQ((*first)->request, 1U);
  const auto& event = std::get<ServiceEvent>((*first)->what);
  EXPECT_EQ(event.change, Change::add);
  EXPECT_EQ(event.peer_name, "vision");
  EXPECT_EQ(event.publication.address, "10.0.0.2");
  EXPECT_THAT(event.publication.attributes, ElementsAre(Pair("rate", "30")));
  const auto second = client.next_event(10s);
  ASSERT_TRUE(second && *second);
  EXPECT_EQ(std::get<ServiceEvent>((*second)->what).reason, "left");
  const auto third = client.next_event(10s);
  ASSERT_TRUE(third && *third);
  EXPECT_EQ(std::get<Error>((*third)->what).code, ErrorCode::impossible);
  EXPECT_EQ(client.poll().value(), std::nullopt);
  EXPECT_EQ(client.next_event(1ms).value(), std::nullopt);
}

TEST(Client, HasADescriptorThatIsReadableWhenSomethingCame) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.welcome();
    talk.say(added);
    talk.wait_for_end();
  });
  Client client = connected(daemon);
  std::optional<Event> event = client.poll().value();
  while (!event) {
    pollfd watched{client.file_descriptor(), POLLIN, 0};
    ASSERT_EQ(::poll(&watched, 1, 10'000), 1);
    event = client.poll().value();
  }
  EXPECT_EQ(event->request, 1U);
}

TEST(Client, ReadsAnAnswerOfManyLinesWhateverItSays) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.welcome();
    talk.expect("1 query services filter=\"a b\"");
    talk.say("1 msg services service=5e6f7a8b/2/9 name=vision text=x mode=oto port=5 used=1 rate=30");
    talk.say(added);
    talk.say("2 msg services service=of-another-query");
    talk.say("1 msg services service=5e6f7a8b/2/10 text=y");
    talk.say("1 msg end count=2 note=done");
    talk.wait_for_end();
  });
  Client client = connected(daemon);
  const auto answer = client.query("services", {{"filter", "a b"}});
  ASSERT_TRUE(answer) << answer.error().text;
  ASSERT_EQ(answer->records.size(), 2U);
  EXPECT_EQ(answer->records[0]["service"], "5e6f7a8b/2/9");
  EXPECT_EQ(answer->records[0]["nothing"], "");
  EXPECT_THAT(answer->records[0].attributes, ElementsAre(Pair("rate", "30")));
  EXPECT_EQ(answer->end["note"], "done");
  EXPECT_TRUE(client.poll().value()) << "the event between the lines is kept";
}

TEST(Client, GivesTheErrorOfAQuery) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.welcome();
    talk.hear();
    talk.say("1 422 no ontology is loaded: start gemingad with --ontology");
    talk.hear();
    talk.say("2 msg end count=0");
  });
  Client client = connected(daemon);
  const auto refused = client.query("explain", {{"sub", "a"}, {"super", "b"}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::impossible);
  EXPECT_TRUE(client.query("status")) << "everything else goes on";
}

TEST(Client, DoesNotSendWhatGcnpCannotCarry) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.welcome();
    talk.expect("");
  });
  Client client = connected(daemon);
  NamedPublication publication;
  publication.port = 1;
  for (const auto& attributes :
       {Attributes{{"a b", "c"}}, Attributes{{"a", std::string("\0", 1)}}, Attributes{{"a", "\xff"}},
        Attributes{{"", "c"}}, Attributes{{"a", std::string(70'000, 'x')}}, Attributes{{"a\r\n9 sub", "c"}}}) {
    publication.attributes = attributes;
    const auto published = client.publish(publication);
    ASSERT_FALSE(published);
    EXPECT_EQ(published.error().kind, ClientError::Kind::wrong_use);
  }
  EXPECT_EQ(client.query("two words").error().kind, ClientError::Kind::wrong_use);
}

TEST(Client, SaysThatNobodyListens) {
  const std::string nowhere = "127.0.0.1:" + std::to_string(free_port());
  const auto client = Client::connect({nowhere, "", 10s});
  ASSERT_FALSE(client);
  EXPECT_EQ(client.error().kind, ClientError::Kind::unreachable);
  EXPECT_THAT(client.error().text, HasSubstr(nowhere));
}

TEST(Client, SaysThatAnAddressIsNone) {
  for (const char* text : {"robot2", "robot2:4717", "127.0.0.1:99999", "[::1"}) {
    const auto client = Client::connect({text, "", 10s});
    ASSERT_FALSE(client) << text;
    EXPECT_EQ(client.error().kind, ClientError::Kind::wrong_use) << text;
  }
}

TEST(Client, TakesTheAddressOfTheEnvironmentWhereNoneIsGiven) {
  ScriptedDaemon daemon([](Conversation& talk) { talk.welcome(); });
  ::setenv("GEMINGA_CONNECT", daemon.address().c_str(), 1);
  const auto client = Client::connect();
  ::unsetenv("GEMINGA_CONNECT");
  EXPECT_TRUE(client);
}

TEST(Client, SaysThatSomethingElseListens) {
  for (const char* words : {"HTTP/1.1 400 Bad Request\r\n", "", "\x80\r\n"}) {
    ScriptedDaemon daemon([words](Conversation& talk) {
      talk.hear();
      talk.send(words);
    });
    const auto client = Client::connect({daemon.address(), "", 10s});
    ASSERT_FALSE(client) << words;
    EXPECT_EQ(client.error().kind, ClientError::Kind::unreachable) << words;
  }
}

TEST(Client, SaysThatTheDaemonDoesNotAnswer) {
  ScriptedDaemon daemon([](Conversation& talk) { talk.wait_for_end(); });
  const auto client = Client::connect({daemon.address(), "", 20ms});
  ASSERT_FALSE(client);
  EXPECT_EQ(client.error().kind, ClientError::Kind::timed_out);
}

TEST(Client, SaysThatTheDaemonRefusesTheHello) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.hear();
    talk.say("0 503 the daemon is stopping");
  });
  const auto client = Client::connect({daemon.address(), "", 10s});
  ASSERT_FALSE(client);
  EXPECT_EQ(client.error().kind, ClientError::Kind::refused);
  EXPECT_EQ(client.error().code, ErrorCode::not_ready);
}

TEST(Client, SaysFromThenOnThatTheDaemonIsGone) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.welcome();
    talk.say(added);
  });
  Client client = connected(daemon);
  ASSERT_TRUE(client.next_event(10s).value()) << "what came before the end is given";
  for (int i = 0; i < 2; ++i) {
    const auto event = client.next_event(10s);
    ASSERT_FALSE(event);
    EXPECT_EQ(event.error().kind, ClientError::Kind::closed);
  }
  EXPECT_EQ(client.subscribe(some_subscription()).error().kind, ClientError::Kind::closed);
  EXPECT_EQ(client.query("status").error().kind, ClientError::Kind::closed);
}

TEST(Client, SaysFromThenOnThatAnAnswerDidNotCome) {
  const ScriptedDaemon::Script silent = [](Conversation& talk) {
    if (talk.hear().empty()) return;
    talk.say("0 msg hello version=1 participant=1a2b3c4d peer=3");
    talk.wait_for_end();
  };
  ScriptedDaemon daemon(std::vector<ScriptedDaemon::Script>(20, silent));
  // A busy machine needs longer until the hello is answered.
  auto client = Client::connect({daemon.address(), "", 50ms});
  for (auto patience = 100ms; !client && patience < 60s; patience *= 2) {
    client = Client::connect({daemon.address(), "", patience});
  }
  ASSERT_TRUE(client);
  EXPECT_EQ(client->query("status").error().kind, ClientError::Kind::timed_out);
  EXPECT_EQ(client->query("status").error().kind, ClientError::Kind::timed_out);
}

TEST(Client, EndsAConversationWithALineThatIsNoGcnp) {
  for (const auto& line : {std::string("nonsense"), "7 msg x=" + std::string(70'000, 'x'), std::string("1 pub add")}) {
    ScriptedDaemon daemon([&line](Conversation& talk) {
      talk.welcome();
      talk.hear();
      talk.say("1 msg end count=0");
      talk.say(line);
      talk.wait_for_end();
    });
    Client client = connected(daemon);
    (void)client.query("status");
    const auto event = client.next_event(10s);
    ASSERT_FALSE(event) << line.substr(0, 40);
    EXPECT_EQ(event.error().kind, ClientError::Kind::closed);
  }
}

TEST(Client, KeepsAsManyEventsAsItsLimit) {
  for (const std::size_t more : {std::size_t{0}, std::size_t{1}}) {
    ScriptedDaemon daemon([more](Conversation& talk) {
      talk.welcome();
      talk.hear();
      std::string events;
      for (std::size_t i = 0; i < Client::max_waiting_events + more; ++i) events += "9 422 gone\r\n";
      talk.send(events);
      talk.say("1 msg end count=0");
      talk.wait_for_end();
    });
    Client client = connected(daemon);
    const auto answer = client.query("status");
    EXPECT_EQ(answer.has_value(), more == 0);
    std::size_t kept = 0;
    while (true) {
      const auto event = client.poll();
      if (!event || !*event) break;
      ++kept;
    }
    EXPECT_EQ(kept, Client::max_waiting_events);
  }
}

TEST(Client, MovesWithItsConversation) {
  ScriptedDaemon daemon([](Conversation& talk) {
    talk.welcome();
    talk.hear();
    talk.say("1 msg end count=0");
    talk.wait_for_end();
  });
  Client first = connected(daemon);
  Client second = std::move(first);
  EXPECT_TRUE(second.query("status"));
}

}  // namespace
}  // namespace geminga::client
