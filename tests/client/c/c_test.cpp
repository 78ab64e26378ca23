// The C interface against a scripted daemon: requests in words, messages, events, errors, callbacks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/scripted_daemon.hpp"
#include "geminga/geminga.h"

namespace geminga::client {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr int patience_ms = 30'000;

void introduce_with_conversion(Conversation& talk) {
  talk.welcome();
  const std::string pub = talk.hear();
  EXPECT_THAT(pub, StartsWith("1 pub create mode=oto concept=s:Ball port="));
  talk.hear();
  talk.say("0 msg pong");
  const std::string sub = talk.hear();
  talk.hear();
  talk.say(
      "2 pub add service=5e6f7a8b/2/1 provider=5e6f7a8b/2 name=eye concept=s:Ball degree=converted distance=0 mode=oto "
      "address=127.0.0.1 port=" +
      field(pub, "port") +
      " protocol=tcp priority=0 participant_name=robot2 convert=A>B "
      "cost=1 channel=" +
      field(pub, "channel"));
  talk.say(
      "1 sub add subscription=5e6f7a8b/2/2 consumer=5e6f7a8b/2 concept=s:Ball degree=exact distance=0 mode=oto "
      "address=127.0.0.1 port=" +
      field(sub, "port") + " priority=0 participant_name=robot2 channel=" + field(sub, "channel"));
  talk.say("0 msg pong");
  talk.wait_for_end();
}

int mark(void* context, const void* payload, size_t size, geminga_writer* to) {
  if (size == 0) return 1;
  geminga_write(to, context, 1);
  geminga_write(to, payload, size);
  return 0;
}

struct Seen {
  std::vector<int> kinds;
  std::vector<std::string> names;
  std::vector<std::string> messages;
};

void see_event(void* context, const geminga_event* event) {
  static_cast<Seen*>(context)->kinds.push_back(event->kind);
  static_cast<Seen*>(context)->names.emplace_back(event->name);
}

void see_message(void* context, geminga_subscriber*, const geminga_message* message) {
  static_cast<Seen*>(context)->messages.emplace_back(static_cast<const char*>(message->payload), message->size);
}

class CTest : public testing::Test {
 protected:
  void open(ScriptedDaemon::Script script) {
    daemon_.emplace(std::move(script));
    node_ = geminga_open(daemon_->address().c_str(), "test", &error_);
    ASSERT_NE(node_, nullptr) << error_.text;
  }
  void TearDown() override { geminga_close(node_); }

  std::optional<ScriptedDaemon> daemon_;  ///< ends after the node
  geminga_node* node_ = nullptr;
  geminga_error error_{};
};

TEST_F(CTest, SendsConvertsAndReceives) {
  open(introduce_with_conversion);
  Seen seen;
  geminga_on_event(node_, see_event, &seen);
  auto* publisher = geminga_publish(node_, "mode=oto concept=s:Ball protocol=tcp rate=30", &error_);
  ASSERT_NE(publisher, nullptr) << error_.text;
  char prefix = '!';
  const geminga_conversion conversion{"A>B", mark, &prefix};
  auto* subscriber =
      geminga_subscribe_converting(node_, "mode=oto concept=s:Ball convert=yes", &conversion, 1, &error_);
  ASSERT_NE(subscriber, nullptr) << error_.text;
  while (geminga_sent(publisher) == 0) {
    geminga_wait(node_, 10);
    EXPECT_EQ(geminga_send(publisher, "hello", 5, &error_), 0);
  }
  const geminga_message* message = geminga_receive(subscriber, patience_ms);
  ASSERT_NE(message, nullptr);
  EXPECT_EQ(std::string(static_cast<const char*>(message->payload), message->size), "!hello");
  EXPECT_EQ(message->life, geminga_publisher_life(publisher));
  EXPECT_EQ(message->sequence, 1U);
  EXPECT_THAT(seen.kinds, testing::IsSupersetOf(
                              {GEMINGA_CONNECTED, GEMINGA_ACCEPTED, GEMINGA_PROVIDER_ADDED, GEMINGA_CONSUMER_ADDED}));
  EXPECT_THAT(seen.names, testing::Contains("eye"));
  geminga_on_message(subscriber, see_message, &seen);
  EXPECT_EQ(geminga_send(publisher, "", 0, &error_), 0) << "the conversion does not take it";
  EXPECT_EQ(geminga_send(publisher, "x", 1, &error_), 0);
  while (seen.messages.empty()) geminga_wait(node_, patience_ms);
  EXPECT_EQ(seen.messages.front(), "!x");
  EXPECT_EQ(geminga_received(subscriber), 2U);
  EXPECT_EQ(geminga_dropped(subscriber), 1U);
  EXPECT_EQ(geminga_wait_for_room(publisher, 100, 0), 1);
  geminga_withdraw_publisher(publisher);
  geminga_withdraw_subscriber(subscriber);
}

TEST_F(CTest, SaysWhatIsWrong) {
  open([](Conversation& talk) {
    talk.welcome();
    talk.hear();
    talk.hear();
    talk.say("2 422 concept=s:Bal is not known");
    talk.say("0 msg pong");
    talk.wait_for_end();
  });
  EXPECT_EQ(geminga_publish(node_, "mode=oto wehre=x text=a", &error_), nullptr);
  EXPECT_EQ(error_.status, GEMINGA_WRONG_USE);
  EXPECT_THAT(error_.text, HasSubstr("did you mean where"));
  EXPECT_EQ(geminga_publish(node_, "mode=oto text=a protocol=quic", &error_), nullptr);
  EXPECT_EQ(error_.status, GEMINGA_WRONG_USE);
  EXPECT_EQ(geminga_subscribe(node_, "mode=oto concept=s:Bal", &error_), nullptr);
  EXPECT_EQ(error_.status, GEMINGA_REFUSED);
  EXPECT_EQ(error_.code, 422);
  EXPECT_EQ(geminga_subscribe(node_, nullptr, nullptr), nullptr) << "an error that nobody wants is left out";
  EXPECT_EQ(geminga_open("robot2", nullptr, &error_), nullptr);
  EXPECT_EQ(error_.status, GEMINGA_WRONG_USE);
}

TEST_F(CTest, NamesTheParameterThatCannotBe) {
  open([](Conversation& talk) {
    talk.welcome();
    talk.wait_for_end();
  });
  for (const auto& [parameters, named] :
       {std::pair{"mode=oto text=a port=99999", "port"}, std::pair{"mode=oto text=a port=x", "port"},
        std::pair{"mode=both text=a", "mode"}, std::pair{"mode=oto text=\"\"", "text"},
        std::pair{"mode=oto concept=\"\"", "concept"}, std::pair{"mode=oto", "text"}}) {
    EXPECT_EQ(geminga_publish(node_, parameters, &error_), nullptr) << parameters;
    EXPECT_EQ(error_.status, GEMINGA_WRONG_USE) << parameters;
    EXPECT_THAT(error_.text, HasSubstr(named)) << parameters;
  }
}

TEST_F(CTest, SaysOnItsLogWhatIsRefused) {
  open([](Conversation& talk) {
    talk.welcome();
    talk.hear();
    talk.hear();
    talk.say("1 422 concept=s:Bal is not known");
    talk.say("0 msg pong");
    talk.wait_for_end();
  });
  std::vector<std::string> lines;
  geminga_on_log(
      node_,
      [](void* context, const char* line) { static_cast<std::vector<std::string>*>(context)->emplace_back(line); },
      &lines);
  EXPECT_EQ(geminga_publish(node_, "mode=otm/stream concept=s:Bal rate=30 port=40001", &error_), nullptr);
  EXPECT_THAT(lines, testing::ElementsAre("the request mode=otm/stream concept=s:Bal port=40001 rate=30 is refused: "
                                          "concept=s:Bal is not known"));
  geminga_on_log(node_, nullptr, nullptr);
}

TEST_F(CTest, CutsALongText) {
  const std::string address(1000, 'x');
  EXPECT_EQ(geminga_open(address.c_str(), nullptr, &error_), nullptr);
  EXPECT_LT(std::string(error_.text).size(), sizeof error_.text);
}

TEST(C, ComputesIdentities) {
  EXPECT_EQ(geminga_text_identity("vision"), 807676232U);
  EXPECT_EQ(geminga_concept_identity("http://example.org/a", nullptr), 2331597606U);
  EXPECT_EQ(geminga_concept_identity("http://example.org/a", "http://example.org/b"), 926581932U);
}

}  // namespace
}  // namespace geminga::client
