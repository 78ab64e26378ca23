// Nodes on an executor: what completes, with what, and how operations end without having happened.
#include "geminga/asio.hpp"

#include <gtest/gtest.h>

#include <boost/asio/bind_cancellation_slot.hpp>
#include <boost/asio/cancellation_signal.hpp>
#include <boost/asio/io_context.hpp>
#include <memory>
#include <string>
#include <vector>

#include "client/scripted_daemon.hpp"

namespace geminga::client {
namespace {

using boost::system::error_code;
namespace asio = boost::asio;

class AsioTest : public testing::Test {
 protected:
  void open(ScriptedDaemon::Script script) {
    daemon_ = std::make_unique<ScriptedDaemon>(std::move(script));
    ClientOptions options;
    options.connect = daemon_->address();
    auto node = Node::open(options);
    ASSERT_TRUE(node);
    node_ = std::make_unique<AsioNode>(context_.get_executor(), std::move(*node));
  }
  /// Runs until the operation under test has said so.
  void run() {
    context_.restart();
    context_.run();
  }
  void TearDown() override {
    node_.reset();
    context_.restart();
    context_.run();  // what was cancelled is told, and the node ends with it
  }

  std::unique_ptr<ScriptedDaemon> daemon_;  ///< ends after the node
  asio::io_context context_;
  std::unique_ptr<AsioNode> node_;
};

void listen(Conversation& talk) {
  talk.welcome();
  talk.wait_for_end();
}

NamedPublication offer() {
  NamedPublication publication;
  publication.identity = TextIdentity{"ball"};
  publication.mode = ChannelMode::one_to_many_pubsub;
  return publication;
}

TEST_F(AsioTest, GivesEventsAsTheyCome) {
  open(listen);
  std::optional<ChannelEvent> seen;
  node_->async_event([&](error_code error, std::optional<ChannelEvent> event) {
    EXPECT_FALSE(error);
    seen = std::move(event);
    context_.stop();
  });
  EXPECT_FALSE(seen) << "nothing is called within the call that begins";
  run();
  ASSERT_TRUE(seen);
  EXPECT_TRUE(std::holds_alternative<Connected>(*seen));
}

TEST_F(AsioTest, SendsAtOnceWhereNobodyListensAndRefusesWhatIsTooLarge) {
  open(listen);
  auto publisher = node_->node().publish(offer(), Wait::for_nothing);
  ASSERT_TRUE(publisher);
  std::vector<error_code> errors;
  const std::string large(65'001, 'x');
  for (const std::string_view text : {std::string_view("hello"), std::string_view(large)}) {
    node_->async_send(*publisher, text, [&](error_code error, std::optional<bool>) {
      errors.push_back(error);
      if (errors.size() == 2) context_.stop();
    });
  }
  run();
  EXPECT_EQ(errors, (std::vector<error_code>{{}, asio::error::message_size}));
}

TEST_F(AsioTest, CancelsWhatWaits) {
  open(listen);
  NamedSubscription wish;
  wish.identity = TextIdentity{"ball"};
  auto subscriber = node_->node().subscribe(wish, {}, Wait::for_nothing);
  ASSERT_TRUE(subscriber);
  std::vector<error_code> errors;
  const auto told = [&](error_code error, const std::optional<Message>& message) {
    EXPECT_FALSE(message);
    errors.push_back(error);
  };
  asio::cancellation_signal one;
  node_->async_receive(*subscriber, asio::bind_cancellation_slot(one.slot(), told));
  node_->async_receive(*subscriber, told);
  one.emit(asio::cancellation_type::terminal);
  context_.poll();
  EXPECT_EQ(errors, std::vector<error_code>{asio::error::operation_aborted});
  node_->cancel();
  context_.poll();
  EXPECT_EQ(errors.size(), 2U);
}

TEST_F(AsioTest, EndsReceivingWithItsSubscriber) {
  open([](Conversation& talk) {
    talk.welcome();
    talk.hear();
    talk.hear();
    talk.say("1 422 ball is not known");
    talk.say("0 msg pong");
    talk.wait_for_end();
  });
  NamedSubscription wish;
  wish.identity = TextIdentity{"ball"};
  auto subscriber = node_->node().subscribe(wish, {}, Wait::for_nothing);
  ASSERT_TRUE(subscriber);
  error_code ended;
  node_->async_receive(*subscriber, [&](error_code error, const std::optional<Message>&) {
    ended = error;
    context_.stop();
  });
  run();
  EXPECT_EQ(ended, asio::error::eof);
}

TEST_F(AsioTest, ClosesCleanly) {
  open(listen);
  bool is_closed = false;
  node_->async_close([&](error_code error, std::optional<bool>) {
    is_closed = !error;
    context_.stop();
  });
  run();
  EXPECT_TRUE(is_closed);
}

}  // namespace
}  // namespace geminga::client
