// Sealed channels between publishers and subscribers, and what strangers and recordings cannot do to them.
#include <gmock/gmock.h>

#include "client/channels/channel_rig.hpp"

namespace geminga::client {
namespace {

using testing::Contains;
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
      // Over TCP those that did not say a sealed hello are closed by a publisher that becomes strict, and come again.
      if (std::string(one.protocol) == "tcp" && !keys.takes_plain()) pair.rig.pass(1s);
      pair.send();
      pair.send();
      sent += 2;
    }
    EXPECT_EQ(received(*pair.subscriber).size(), is_group ? sent - 1 : sent)
        << one.protocol << ' ' << one.address << ' ' << static_cast<int>(one.mode);
    EXPECT_EQ(pair.rig.changes<ProviderChange>(), std::vector<std::string>{"added"});
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
