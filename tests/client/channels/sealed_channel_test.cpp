// Sealed channels between publishers and subscribers, and a subscriber among strangers and recordings.
#include <gmock/gmock.h>

#include "client/channels/channel_rig.hpp"

namespace geminga::client {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Case {
  ChannelMode mode;
  const char* protocol;
  const char* address;
};

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const auto mode : {ChannelMode::one_to_one, ChannelMode::one_to_many_pubsub, ChannelMode::one_to_many_stream}) {
    for (const char* protocol : {"udp", "tcp"}) cases.push_back({mode, protocol, "127.0.0.1"});
  }
  cases.push_back({ChannelMode::one_to_many_stream, "udp", "239.255.17.4"});
  return cases;
}

/// A publisher and a subscriber that know each other.
class Pair {
 public:
  explicit Pair(Case one, SealingMode publishers = SealingMode::encrypted,
                SealingMode subscribers = SealingMode::encrypted)
      : offer(rig_offer(one.mode, one.protocol)), wish(rig_wish(one.mode)) {
    rig.mode = subscribers;
    offer.address = one.address;
    publisher = *PublisherChannel::open(rig, 1, offer);
    subscriber = *SubscriberChannel::open(rig, 2, wish, {});
    publisher->set_keys(keys_of(publishers));
    subscriber->set_keys(publisher->life(), keys_of(subscribers));
    if (one.mode != ChannelMode::one_to_many_stream) publisher->on_event(consumer_event(wish));
    subscriber->on_event(provider_event(offer));
    rig.settle();
  }
  void send() {
    EXPECT_TRUE(publisher->send(octets_of("here")));
    rig.settle();
  }
  void set_keys(const ChannelKeys& keys) {
    publisher->set_keys(keys);
    subscriber->set_keys(publisher->life(), keys);
    rig.settle();
  }

  ChannelRig rig;
  NamedPublication offer;
  NamedSubscription wish;
  std::unique_ptr<PublisherChannel> publisher;
  std::unique_ptr<SubscriberChannel> subscriber;
};

/// Lets a multicast subscriber hear of the publisher, whose first message it cannot believe.
void begin(Pair& pair, const Case& one) {
  if (std::string(one.address) == "127.0.0.1") return;
  pair.send();
  EXPECT_THAT(received(*pair.subscriber), IsEmpty()) << "sent before the floor";
}

TEST(SealedChannel, CarriesMessagesInEachModeOverEachProtocol) {
  for (const auto& one : all_cases()) {
    for (const auto sealing : {SealingMode::mixed, SealingMode::authenticated, SealingMode::encrypted}) {
      Pair pair(one, sealing, sealing);
      begin(pair, one);
      for (int i = 0; i < 3; ++i) pair.send();
      const std::uint64_t first = pair.publisher->count().sent - 2;
      const auto expected = [first](int more) { return std::to_string(first + static_cast<unsigned>(more)) + ":0"; };
      EXPECT_THAT(received(*pair.subscriber), ElementsAre(expected(0), expected(1), expected(2)))
          << one.protocol << one.address << static_cast<int>(one.mode);
      pair.rig.pass(5s);
      pair.send();
      EXPECT_THAT(received(*pair.subscriber), ElementsAre(expected(3))) << "listeners are renewed";
      pair.publisher->finish();
      pair.rig.settle();
      EXPECT_THAT(pair.rig.changes<ProviderChange>(), ElementsAre("added", "removed withdrawn"));
      EXPECT_THAT(pair.rig.problems(), IsEmpty());
    }
  }
}

TEST(SealedChannel, OfEveryPairOfModesThatUnderstandEachOtherCarriesMessages) {
  using enum SealingMode;
  const std::vector<std::pair<SealingMode, SealingMode>> pairs{
      {plain, prepared}, {prepared, plain},  {prepared, prepared},       {prepared, mixed},
      {mixed, prepared}, {mixed, encrypted}, {encrypted, authenticated}, {authenticated, encrypted}};
  for (const auto& one : all_cases()) {
    for (const auto& [publishers, subscribers] : pairs) {
      Pair pair(one, publishers, subscribers);
      pair.send();
      pair.rig.pass(1s);
      received(*pair.subscriber);
      pair.send();
      EXPECT_EQ(received(*pair.subscriber).size(), 1U)
          << static_cast<int>(publishers) << ' ' << static_cast<int>(subscribers) << ' ' << one.protocol << ' '
          << one.address << ' ' << static_cast<int>(one.mode);
    }
  }
}

TEST(SealedChannel, LosesNothingWhenKeysAndModesChange) {
  for (const auto& one : all_cases()) {
    Pair pair(one, SealingMode::prepared, SealingMode::prepared);
    pair.send();
    const auto old = keys_of(SealingMode::mixed).ring()[0];
    const auto next = keys_of(SealingMode::mixed, 8).ring()[0];
    const bool is_group = std::string(one.address) != "127.0.0.1";
    std::vector<ChannelKeys> steps;
    for (const auto mode : {SealingMode::mixed, SealingMode::encrypted}) steps.emplace_back(mode, std::vector{old});
    for (const auto& ring : {std::vector{old, next}, std::vector{next, old}, std::vector{next}}) {
      steps.emplace_back(SealingMode::encrypted, ring);
    }
    pair.rig.pass(2s);
    std::size_t sent = 1;
    for (const auto& keys : steps) {
      // Daemons tell their programs at their own pace; a receiver has a new key first.
      pair.subscriber->set_keys(pair.publisher->life(), keys);
      pair.rig.pass(1s);
      pair.publisher->set_keys(keys);
      pair.send();
      pair.send();
      sent += 2;
    }
    EXPECT_EQ(received(*pair.subscriber).size(), is_group ? sent - 1 : sent)
        << one.protocol << ' ' << one.address << ' ' << static_cast<int>(one.mode);
    EXPECT_EQ(pair.rig.changes<ProviderChange>(), std::vector<std::string>{"added"});
  }
}

TEST(SealedChannel, LosesNothingWhoeverChangesItsModeFirst) {
  using enum SealingMode;
  for (const auto& one : all_cases()) {
    if (std::string(one.address) != "127.0.0.1") continue;  // what is sent before the floor is not delivered there
    for (const bool is_publisher_first : {false, true}) {
      Pair pair(one, prepared, prepared);
      pair.rig.pass(1s);
      pair.send();
      std::size_t sent = 1;
      for (const auto mode : {mixed, encrypted, authenticated, encrypted}) {
        for (const bool is_publishers_turn : {is_publisher_first, !is_publisher_first}) {
          if (is_publishers_turn) pair.publisher->set_keys(keys_of(mode));
          if (!is_publishers_turn) pair.subscriber->set_keys(pair.publisher->life(), keys_of(mode));
          for (int i = 0; i < 5; ++i, ++sent) {
            pair.send();
            pair.rig.pass(50ms);
          }
        }
      }
      pair.rig.pass(6s);
      pair.send();
      EXPECT_EQ(received(*pair.subscriber).size(), sent + 1)
          << one.protocol << ' ' << static_cast<int>(one.mode) << ' ' << is_publisher_first;
      EXPECT_THAT(pair.rig.changes<ProviderChange>(), ElementsAre("added"));
    }
  }
}

TEST(SealedChannel, WaitsForItsKeys) {
  for (const auto& one : all_cases()) {
    Pair pair(one);
    auto offer = rig_offer(one.mode, one.protocol);
    offer.address = one.address;
    auto publisher = *PublisherChannel::open(pair.rig, 3, offer);
    EXPECT_TRUE(publisher->send(octets_of("here")));
    EXPECT_EQ(publisher->count().sent, 0U);
    auto wish = rig_wish(one.mode);
    auto subscriber = *SubscriberChannel::open(pair.rig, 4, wish, {});
    subscriber->on_event(provider_event(offer, 5));
    pair.rig.pass(1s);
    EXPECT_EQ(publisher->count().dropped, 0U);
    publisher->set_keys(keys_of(SealingMode::encrypted));
    if (one.mode != ChannelMode::one_to_many_stream) publisher->on_event(consumer_event(wish, 6));
    subscriber->set_keys(publisher->life(), keys_of(SealingMode::encrypted));
    pair.rig.pass(1s);
    EXPECT_TRUE(publisher->send(octets_of("here")));
    pair.rig.settle();
    if (std::string(one.address) == "127.0.0.1") {
      EXPECT_EQ(received(*subscriber).size(), 1U) << one.protocol;
    }
  }
}

/// A sealed subscriber of pubsub over UDP, and its provider, which the test speaks for.
class SealedSubscriber : public testing::Test {
 protected:
  SealedSubscriber() {
    rig_.mode = SealingMode::encrypted;
    subscriber_ = *SubscriberChannel::open(rig_, 1, wish_, {});
    to_ = *peer_address("127.0.0.1", wish_.port);
    offer_.port = provider_.address().port;
    offer_.attributes[std::string(channel_attribute)] = to_string(life);
    subscriber_->set_keys(life, keys_);
  }
  void add() {
    subscriber_->on_event(provider_event(offer_));
    rig_.settle();
  }
  /// The greeting of the last hello that the provider has heard.
  Greeting hello() {
    Greeting last;
    for (const auto& octets : provider_.hear()) {
      const auto frame = read_frame(octets);
      const auto opened = frame ? open_frame(*frame, keys_, Direction::back, room_) : std::nullopt;
      if (opened && opened->kind == FrameKind::hello) last = *read_greeting(opened->payload);
    }
    return last;
  }
  void say(FrameKind kind, std::uint64_t sequence, std::span<const std::byte> payload = {}) {
    const auto octets = *sealer_.frame(keys_, kind, sequence, payload);
    provider_.send(to_, octets);
  }
  void floor(std::uint64_t sequence, std::uint64_t challenge, std::uint64_t cookie = 0) {
    say(FrameKind::floor, sequence, greeting_payload({subscriber_->life(), challenge, cookie}));
  }

  static constexpr Life life{77};
  ChannelRig rig_;
  Speaker provider_{rig_};
  NamedPublication offer_ = rig_offer(ChannelMode::one_to_many_pubsub, "udp");
  NamedSubscription wish_ = rig_wish(ChannelMode::one_to_many_pubsub);
  ChannelKeys keys_ = keys_of(SealingMode::encrypted);
  Sealer sealer_{life, Direction::forward};
  std::vector<std::byte> room_;
  std::unique_ptr<SubscriberChannel> subscriber_;
  PeerAddress to_;
};

TEST_F(SealedSubscriber, DeliversNoRecording) {
  add();
  const Greeting first = hello();
  EXPECT_EQ(first.life, life);
  EXPECT_NE(first.challenge, 0U);
  say(FrameKind::message, 5);
  floor(3, first.challenge + 1);
  EXPECT_THAT(received(*subscriber_), IsEmpty()) << "the floor of another channel";
  floor(4, first.challenge);
  EXPECT_THAT(received(*subscriber_), ElementsAre("5:0")) << "it waited for its floor";
  say(FrameKind::message, 4);
  say(FrameKind::message, 5);
  EXPECT_THAT(received(*subscriber_), IsEmpty());
  floor(9, first.challenge);
  say(FrameKind::message, 7);
  EXPECT_THAT(received(*subscriber_), ElementsAre("7:1")) << "only the first floor counts";
}

TEST_F(SealedSubscriber, KeepsAMessageForItsFloorForASecond) {
  add();
  const Greeting first = hello();
  say(FrameKind::message, 5);
  rig_.pass(1s);
  floor(4, first.challenge);
  EXPECT_THAT(received(*subscriber_), IsEmpty());
}

TEST_F(SealedSubscriber, DropsWhatAStrangerForgesFromTheAddressOfItsProvider) {
  add();
  floor(1, hello().challenge);
  say(FrameKind::message, 2);
  EXPECT_THAT(received(*subscriber_), ElementsAre("2:0"));
  const auto dropped = subscriber_->count().dropped;
  provider_.send(to_, {FrameKind::message, life, ~std::uint64_t{0}, {}});
  provider_.send(to_, {FrameKind::end, life, 2, {}});
  provider_.send(to_, {FrameKind::full, life, 2, greeting_payload({subscriber_->life(), 1, 0})});
  auto forged = *sealer_.frame(keys_, FrameKind::message, 3);
  forged.back() ^= std::byte{1};
  provider_.send(to_, forged);
  EXPECT_EQ(subscriber_->count().dropped, dropped + 4);
  say(FrameKind::message, 4);
  EXPECT_THAT(received(*subscriber_), ElementsAre("4:1"));
  EXPECT_EQ(rig_.changes<ProviderChange>(), std::vector<std::string>{"added"});
  say(FrameKind::end, 6);
  EXPECT_THAT(rig_.changes<ProviderChange>(), ElementsAre("added", "removed withdrawn")) << "an authentic end";
  EXPECT_EQ(subscriber_->count().missed, 3U);
}

TEST_F(SealedSubscriber, EndsByNoRecordedEnd) {
  add();
  hello();
  say(FrameKind::end, 6);
  EXPECT_EQ(rig_.changes<ProviderChange>(), std::vector<std::string>{"added"});
}

TEST_F(SealedSubscriber, SaysHelloAgainUntilItIsAcceptedAndGivesTheCookieBackAtOnce) {
  add();
  const Greeting first = hello();
  EXPECT_EQ(first.cookie, 0U);
  floor(1, first.challenge, 99);
  EXPECT_EQ(hello().cookie, 99U);
  floor(1, first.challenge, 99);
  EXPECT_EQ(hello(), Greeting()) << "no hello for each answer";
  rig_.pass(3s);
  EXPECT_EQ(hello().cookie, 99U);
  floor(1, first.challenge, 0);
  EXPECT_THAT(rig_.problems(), IsEmpty());
}

TEST_F(SealedSubscriber, IsNotConnectedToAServiceWithoutALifeAndSaysSo) {
  offer_.attributes.clear();
  add();
  EXPECT_THAT(rig_.problems(), ElementsAre("00000007/1/1 states no life, so its channel cannot be sealed"));
  provider_.send(to_, octets_of("here"));
  EXPECT_THAT(received(*subscriber_), IsEmpty());
  rig_.mode = SealingMode::mixed;
  subscriber_->on_mode();
  provider_.send(to_, octets_of("here"));
  EXPECT_THAT(received(*subscriber_), ElementsAre("0:0"));
}

}  // namespace
}  // namespace geminga::client
