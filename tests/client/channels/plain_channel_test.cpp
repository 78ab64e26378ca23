// Channels without a key: what strangers can do to them, and no more (src/client/CHANNELS.md, What is believed).
#include <gmock/gmock.h>

#include "client/channels/channel_rig.hpp"

namespace geminga::client {
namespace {

using testing::ElementsAre;

/// A subscriber over UDP, and its provider, which the test speaks for.
class PlainSubscriber : public testing::Test {
 protected:
  PlainSubscriber() {
    subscriber_ = *SubscriberChannel::open(rig_, 1, wish_, {});
    subscriber_->on_daemon_keys(false);
    to_ = *peer_address("127.0.0.1", wish_.port);
    offer_.port = provider_.address().port;
    offer_.attributes[std::string(channel_attribute)] = to_string(life);
    subscriber_->on_event(provider_event(offer_));
  }
  void say(std::uint64_t sequence) { provider_.send(to_, {FrameKind::message, life, sequence, {}}); }
  void del(const char* reason) {
    ServiceEvent gone = provider_event(offer_);
    gone.change = Change::del;
    gone.reason = reason;
    subscriber_->on_event(gone);
  }

  static constexpr Life life{77};
  ChannelRig rig_;
  Speaker provider_{rig_};
  NamedPublication offer_ = rig_offer(ChannelMode::one_to_many_pubsub, "udp");
  NamedSubscription wish_ = rig_wish(ChannelMode::one_to_many_pubsub);
  std::unique_ptr<SubscriberChannel> subscriber_;
  PeerAddress to_;
};

TEST_F(PlainSubscriber, GoesOnAfterAForgedSequence) {
  say(10);
  say(~std::uint64_t{0});
  say(11);
  EXPECT_THAT(received(*subscriber_), ElementsAre("10:0", "11:0"));
  // One within the step mutes, until 2 s and one message have passed.
  say(11 + max_sequence_step);
  say(12);
  EXPECT_THAT(received(*subscriber_), ElementsAre("65547:65535"));
  rig_.pass(2s);
  say(13);
  say(14);
  say(15);
  EXPECT_THAT(received(*subscriber_), ElementsAre("13:0", "14:0", "15:0")) << "12 was the one before";
}

TEST_F(PlainSubscriber, TakesAnEndForAHint) {
  say(10);
  provider_.send(to_, {FrameKind::end, life, 12, {}});
  say(11);
  EXPECT_THAT(received(*subscriber_), ElementsAre("10:0", "11:0"));
  EXPECT_THAT(rig_.changes<ProviderChange>(), ElementsAre("added"));
  rig_.pass(end_patience - 1ms);
  del("expired");
  EXPECT_THAT(rig_.changes<ProviderChange>(), ElementsAre("added", "removed withdrawn"));
  EXPECT_EQ(subscriber_->count().missed, 1U);
}

TEST_F(PlainSubscriber, ForgetsAnEndThatTheDaemonDoesNotConfirmInTime) {
  say(10);
  provider_.send(to_, {FrameKind::end, life, 12, {}});
  rig_.pass(end_patience);
  del("expired");
  EXPECT_THAT(rig_.changes<ProviderChange>(), ElementsAre("added")) << "it goes on for a while";
  EXPECT_EQ(subscriber_->count().missed, 0U);
  provider_.send(to_, {FrameKind::end, life, ~std::uint64_t{0}, {}});
  EXPECT_THAT(rig_.changes<ProviderChange>(), ElementsAre("added", "removed withdrawn")) << "the daemon has said it";
  EXPECT_EQ(subscriber_->count().missed, 0U) << "so many are not counted";
}

TEST_F(PlainSubscriber, OutlivesTheDeathOfBothDaemons) {
  say(10);
  del("expired");
  rig_.pass(8s);
  subscriber_->on_daemon_gone();
  rig_.pass(60s);
  say(11);
  EXPECT_THAT(received(*subscriber_), ElementsAre("10:0", "11:0")) << "nobody could confirm it";
  subscriber_->on_settled();
  rig_.pass(orphan_patience);
  EXPECT_THAT(rig_.changes<ProviderChange>(), ElementsAre("added", "removed disconnected"));
}

TEST_F(PlainSubscriber, KeepsAChannelWhoseServiceHasGotAnotherLife) {
  say(10);
  auto other = offer_;
  other.port = 1;
  other.attributes[std::string(channel_attribute)] = to_string(Life{78});
  subscriber_->on_event(provider_event(other));
  say(11);
  subscriber_->on_event(provider_event(offer_, 9));
  say(12);
  EXPECT_THAT(received(*subscriber_), ElementsAre("10:0", "11:0", "12:0"));
  EXPECT_THAT(rig_.changes<ProviderChange>(), ElementsAre("added", "added"));
}

TEST(PlainPublisher, GoesOnWhereADaemonThatIsJustBackSaysThatItIsOutranked) {
  for (const bool settles : {false, true}) {
    ChannelRig rig;
    rig.settles = settles;
    Speaker consumer(rig);
    auto offer = rig_offer(ChannelMode::one_to_many_pubsub, "udp");
    auto publisher = *PublisherChannel::open(rig, 1, offer);
    publisher->set_keys(ChannelKeys());
    auto wish = rig_wish(ChannelMode::one_to_many_pubsub);
    wish.port = consumer.address().port;
    wish.attributes[std::string(channel_attribute)] = to_string(Life{8});
    publisher->on_event(consumer_event(wish));
    ConsumerEvent gone = consumer_event(wish);
    gone.change = Change::del;
    gone.reason = "outranked";
    publisher->on_event(gone);
    EXPECT_TRUE(publisher->send({}));
    EXPECT_EQ(consumer.hear().size(), settles ? 1U : 0U);
    publisher->on_event(consumer_event(wish, 3));
    rig.pass(orphan_patience);
    EXPECT_TRUE(publisher->send({}));
    EXPECT_EQ(consumer.hear().size(), 1U);
    EXPECT_EQ(rig.changes<ConsumerChange>().size(), settles ? 1U : 3U);
  }
}

}  // namespace
}  // namespace geminga::client
