// A sealed publisher over UDP, which strangers and recordings ask in vain.
#include <gmock/gmock.h>

#include "client/channels/channel_rig.hpp"

namespace geminga::client {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A sealed publisher over UDP, and a consumer, which the test speaks for.
class SealedPublisher : public testing::Test {
 protected:
  void open(ChannelMode mode) {
    auto offer = rig_offer(mode, "udp");
    publisher_ = *PublisherChannel::open(rig_, 1, offer);
    publisher_->set_keys(keys_);
    to_ = *peer_address("127.0.0.1", offer.port);
  }
  std::vector<std::byte> hello_octets(std::uint64_t cookie) {
    return *sealer_.frame(keys_, FrameKind::hello, 0, greeting_payload({publisher_->life(), 5, cookie}));
  }
  /// The frames that the consumer has heard, opened.
  std::vector<Frame> heard(std::vector<Greeting>* greetings = nullptr) {
    std::vector<Frame> all;
    for (const auto& octets : consumer_.hear()) {
      const auto frame = read_frame(octets);
      const auto opened = frame ? open_frame(*frame, keys_, Direction::forward, room_) : std::nullopt;
      if (!opened) continue;
      if (greetings != nullptr && opened->payload.size() == greeting_bytes) {
        greetings->push_back(*read_greeting(opened->payload));
      }
      all.push_back(*opened);
    }
    return all;
  }
  std::uint64_t cookie() {
    std::vector<Greeting> greetings;
    heard(&greetings);
    return greetings.empty() ? 0 : greetings.back().cookie;
  }
  /// How many messages arrive of one that is sent.
  std::size_t sent_one() {
    EXPECT_TRUE(publisher_->send(octets_of("here")));
    return heard().size();
  }

  static constexpr Life life{78};
  ChannelRig rig_;
  Speaker consumer_{rig_};
  ChannelKeys keys_ = keys_of(SealingMode::encrypted);
  Sealer sealer_{life, Direction::back};
  std::vector<std::byte> room_;
  std::unique_ptr<PublisherChannel> publisher_;
  PeerAddress to_;
};

TEST_F(SealedPublisher, AcceptsNoRecordedHelloOnceItsCookieIsOld) {
  open(ChannelMode::one_to_many_stream);
  consumer_.send(to_, hello_octets(0));
  const auto recorded = hello_octets(cookie());
  EXPECT_EQ(sent_one(), 0U);
  rig_.pass(16s);
  consumer_.send(to_, recorded);
  EXPECT_NE(cookie(), 0U) << "it is asked again";
  EXPECT_EQ(sent_one(), 0U);
}

TEST_F(SealedPublisher, TakesNoHelloAndNoEndTwice) {
  open(ChannelMode::one_to_many_stream);
  consumer_.send(to_, hello_octets(0));
  const auto given = cookie();
  const auto end = *sealer_.frame(keys_, FrameKind::end, 0, greeting_payload({publisher_->life(), 5, given}));
  const auto hello = hello_octets(given);
  consumer_.send(to_, hello);
  EXPECT_EQ(cookie(), 0U);
  EXPECT_EQ(sent_one(), 1U);
  const auto dropped = publisher_->count().dropped;
  consumer_.send(to_, end);
  consumer_.send(to_, hello);
  EXPECT_EQ(publisher_->count().dropped, dropped + 2) << "both were said before";
  EXPECT_EQ(sent_one(), 1U);
  rig_.pass(2s);
  consumer_.send(to_, hello);
  rig_.pass(1s);
  EXPECT_EQ(sent_one(), 0U) << "a recording renews nothing";
}

TEST_F(SealedPublisher, AnswersNobodyWithoutTheKey) {
  open(ChannelMode::one_to_many_stream);
  const auto greeting = greeting_payload({publisher_->life(), 5, 0});
  consumer_.send(to_, {FrameKind::hello, life, 0, greeting});
  const auto other = keys_of(SealingMode::encrypted, 9);
  consumer_.send(to_, *sealer_.frame(other, FrameKind::hello, 0, greeting));
  EXPECT_THAT(consumer_.hear(), IsEmpty());
  EXPECT_EQ(publisher_->count().dropped, 2U);
}

TEST_F(SealedPublisher, OfPubsubSendsWhenTheHelloOfItsConsumerIsAccepted) {
  open(ChannelMode::one_to_many_pubsub);
  auto wish = rig_wish(ChannelMode::one_to_many_pubsub);
  wish.port = consumer_.address().port;
  wish.attributes[std::string(channel_attribute)] = to_string(life);
  publisher_->on_event(consumer_event(wish));
  EXPECT_THAT(rig_.changes<ConsumerChange>(), IsEmpty());
  EXPECT_EQ(sent_one(), 0U);
  consumer_.send(to_, hello_octets(0));
  consumer_.send(to_, hello_octets(cookie()));
  EXPECT_THAT(rig_.changes<ConsumerChange>(), ElementsAre("added"));
  EXPECT_EQ(heard().size(), 1U) << "the floor";
  EXPECT_EQ(sent_one(), 1U);
}

TEST_F(SealedPublisher, OfPubsubDoesNotAnswerAGoodCookieBeforeItKnowsTheConsumer) {
  open(ChannelMode::one_to_one);
  consumer_.send(to_, hello_octets(0));
  const auto given = cookie();
  EXPECT_NE(given, 0U);
  consumer_.send(to_, hello_octets(given));
  EXPECT_THAT(consumer_.hear(), IsEmpty());
  auto wish = rig_wish(ChannelMode::one_to_one);
  wish.port = consumer_.address().port;
  wish.attributes[std::string(channel_attribute)] = to_string(life);
  publisher_->on_event(consumer_event(wish));
  consumer_.send(to_, hello_octets(given));
  EXPECT_EQ(heard().size(), 1U);
  EXPECT_EQ(sent_one(), 1U);
}

TEST_F(SealedPublisher, SendsNothingToAConsumerWithoutALifeAndSaysSo) {
  open(ChannelMode::one_to_many_pubsub);
  auto wish = rig_wish(ChannelMode::one_to_many_pubsub);
  wish.port = consumer_.address().port;
  publisher_->on_event(consumer_event(wish));
  publisher_->on_event(consumer_event(wish));
  EXPECT_THAT(rig_.problems(), ElementsAre("00000007/1/2 states no life, so its channel cannot be sealed"));
  EXPECT_TRUE(publisher_->send(octets_of("here")));
  EXPECT_THAT(consumer_.hear(), IsEmpty());
}

}  // namespace
}  // namespace geminga::client
