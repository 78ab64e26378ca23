// Streams and connections without a key, in floods (src/client/CHANNELS.md, Places).
#include <gmock/gmock.h>

#include <array>

#include "client/channels/channel_rig.hpp"
#include "client/channels/tcp_outlet.hpp"

namespace geminga::client {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A publisher of a stream, and listeners, which the test speaks for.
class PlainStream : public testing::Test {
 protected:
  explicit PlainStream(const char* protocol = "udp") {
    auto offer = rig_offer(ChannelMode::one_to_many_stream, protocol);
    offer.address.clear();
    publisher_ = *PublisherChannel::open(rig_, 1, offer);
    publisher_->set_keys(ChannelKeys());
    to_ = *peer_address("127.0.0.1", offer.port);
  }
  std::vector<std::byte> hello(Life life, std::uint64_t cookie) {
    return frame_bytes({FrameKind::hello, life, 0, greeting_payload({publisher_->life(), 5, cookie})});
  }
  /// The cookie that the listener was answered; nothing if it was not answered.
  static std::optional<std::uint64_t> cookie(Speaker& listener) {
    std::optional<std::uint64_t> last;
    for (const auto& octets : listener.hear()) {
      const auto frame = read_frame(octets);
      if (frame && frame->kind == FrameKind::floor) last = read_greeting(frame->payload)->cookie;
    }
    return last;
  }
  void listen(Speaker& listener, Life life) {
    listener.send(to_, hello(life, 0));
    listener.send(to_, hello(life, cookie(listener).value_or(0)));
  }
  void send(std::size_t size = 4) { EXPECT_TRUE(publisher_->send(std::vector<std::byte>(size))); }

  ChannelRig rig_;
  std::unique_ptr<PublisherChannel> publisher_;
  PeerAddress to_;
};

TEST_F(PlainStream, SendsNothingToAnAddressThatHasNotShownToReceive) {
  Speaker listener(rig_);
  const auto first = hello(Life{8}, 0);
  listener.send(to_, first);
  send();
  const auto heard = listener.hear();
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard[0].size(), first.size()) << "nothing is amplified";
  EXPECT_EQ(read_frame(heard[0])->kind, FrameKind::floor);
  listener.send(to_, hello(Life{8}, 99));
  send();
  EXPECT_EQ(listener.hear().size(), 1U) << "another cookie is no cookie";
  EXPECT_EQ(publisher_->count().sent, 0U);
  listen(listener, Life{8});
  EXPECT_EQ(cookie(listener), 0U);
  send();
  EXPECT_EQ(listener.hear().size(), 1U);
}

TEST_F(PlainStream, LimitsItsAnswers) {
  Speaker listener(rig_);
  for (std::size_t i = 0; i < max_answers + 10; ++i) listener.send(to_, hello(Life{8}, 0));
  EXPECT_EQ(listener.hear().size(), max_answers);
  rig_.pass(1s);
  listener.send(to_, hello(Life{8}, 0));
  EXPECT_EQ(listener.hear().size(), 1U);
}

TEST_F(PlainStream, DropsAHelloOfAnotherSizeOrForAnotherLife) {
  Speaker listener(rig_);
  const auto wrong = greeting_payload({Life{1}, 5, 0});
  const auto right = greeting_payload({publisher_->life(), 5, 0});
  listener.send(to_, {FrameKind::hello, Life{8}, 0, wrong});
  listener.send(to_, {FrameKind::hello, Life{8}, 0, std::span(right).first(8)});
  listener.send(to_, {FrameKind::hello, Life{8}, 0, greeting_payload({publisher_->life(), 0, 0})});
  EXPECT_THAT(listener.hear(), IsEmpty());
  EXPECT_EQ(publisher_->count().dropped, 3U);
}

TEST_F(PlainStream, Has1024PlacesWhichAddressesShare) {
  std::vector<std::unique_ptr<Speaker>> all;
  const auto listen_more = [&](const char* address, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      all.push_back(std::make_unique<Speaker>(rig_, address));
      listen(*all.back(), Life{100 + all.size()});
      if (i % 200 != 199) continue;
      for (auto& one : all) one->send(to_, hello(Life{8}, 0));
      rig_.now += 1s;  // for the budget of answers
    }
  };
  // A hundred honest ones of one host, and 1000 of an attacker's.
  listen_more("127.0.0.1", 100);
  EXPECT_THAT(rig_.problems(), IsEmpty());
  listen_more("127.0.0.2", 1000);
  EXPECT_THAT(rig_.problems(), ElementsAre("all 1024 places for listeners are taken"));
  EXPECT_THAT(rig_.stated, ElementsAre("channel.full=1024"));
  rig_.now += 1s;
  listen_more("127.0.0.3", 50);
  for (auto& one : all) one->hear();
  send();
  std::size_t honest = 0;
  std::size_t others = 0;
  for (std::size_t i = 0; i < 100; ++i) honest += all[i]->hear().size();
  for (std::size_t i = 1100; i < 1150; ++i) others += all[i]->hear().size();
  EXPECT_EQ(honest, 100U);
  EXPECT_EQ(others, 50U);
  rig_.pass(listener_patience);
  EXPECT_THAT(rig_.stated, ElementsAre("channel.full=1024", "channel.full=0"));
}

TEST(PlainListener, IsToldThatThereIsNoPlaceAndGoesOnAsking) {
  ChannelRig rig;
  Speaker provider(rig);
  auto offer = rig_offer(ChannelMode::one_to_many_stream, "udp");
  offer.port = provider.address().port;
  offer.attributes[std::string(channel_attribute)] = to_string(Life{77});
  auto wish = rig_wish(ChannelMode::one_to_many_stream);
  auto subscriber = *SubscriberChannel::open(rig, 1, wish, {});
  subscriber->on_daemon_keys(false);
  subscriber->on_event(provider_event(offer));
  const auto hellos = provider.hear();
  ASSERT_EQ(hellos.size(), 1U);
  const Greeting greeting = *read_greeting(read_frame(hellos[0])->payload);
  const auto to = *peer_address("127.0.0.1", wish.port);
  for (const std::uint64_t challenge : {greeting.challenge + 1, greeting.challenge, greeting.challenge}) {
    provider.send(to, {FrameKind::full, Life{77}, 3, greeting_payload({subscriber->life(), challenge, 0})});
  }
  EXPECT_THAT(rig.problems(),
              ElementsAre("the provider " + to_string(provider.address()) + " has no place for another consumer"));
  rig.pass(2s);
  EXPECT_GE(provider.hear().size(), 6U);
}

/// The same over TCP.
class PlainTcpStream : public PlainStream {
 protected:
  PlainTcpStream() : PlainStream("tcp") {}

  Socket connect(Life life, Life publisher) {
    auto socket = *open_connection(to_);
    rig_.settle();
    const auto octets = frame_bytes({FrameKind::hello, life, 0, greeting_payload({publisher, 5, 0})});
    EXPECT_EQ(::send(socket.get(), octets.data(), octets.size(), MSG_NOSIGNAL), static_cast<ssize_t>(octets.size()));
    rig_.settle();
    return socket;
  }
  static bool has_octets(const Socket& socket) {
    std::byte octet{};
    return ::recv(socket.get(), &octet, 1, MSG_PEEK) == 1;
  }
};

TEST_F(PlainTcpStream, WritesNothingToAFloodWithoutItsLife) {
  std::vector<Socket> flood;
  for (std::uint64_t i = 1; i <= 256; ++i) flood.push_back(connect(Life{i}, Life{i}));
  send(100'000);
  for (const Socket& one : flood) EXPECT_FALSE(has_octets(one));
  EXPECT_EQ(publisher_->count().sent, 0U);
  EXPECT_EQ(publisher_->count().dropped, 256U);
}

TEST_F(PlainTcpStream, KeepsAtMost64MebibytesForAFloodThatReadsNothing) {
  std::vector<Socket> flood;
  for (std::uint64_t i = 1; i <= 256; ++i) flood.push_back(connect(Life{i}, publisher_->life()));
  auto& outlet = dynamic_cast<TcpOutlet&>(*publisher_);
  // Each of these consumers waits with the last frame of another size, so that frames are hardly shared.
  for (int i = 0; i < 200; ++i) {
    send(1024 * 1024);
    ASSERT_LE(outlet.waiting_octets(), max_waiting_for_consumers);
  }
  EXPECT_GT(publisher_->count().left_out, 0U);
  EXPECT_THAT(rig_.problems().front(),
              testing::HasSubstr("is slow: messages to it are left out until it has taken some"));
  EXPECT_EQ(rig_.problems().size(), 256U) << "once for each";
}

TEST(PlainTcp, ClosesTheConsumerThatTookNothingForTheLongestTimeWhereTooMuchWaits) {
  ChannelRig rig;
  auto offer = rig_offer(ChannelMode::one_to_many_pubsub, "tcp");
  auto publisher = *PublisherChannel::open(rig, 1, offer);
  publisher->set_keys(ChannelKeys());
  const auto to = *peer_address("127.0.0.1", offer.port);
  auto& outlet = dynamic_cast<TcpOutlet&>(*publisher);
  const std::vector<std::byte> large(max_stream_payload);
  std::vector<Socket> consumers;
  for (std::uint64_t i = 1; i <= 6; ++i) {
    auto wish = rig_wish(ChannelMode::one_to_many_pubsub);
    wish.attributes[std::string(channel_attribute)] = to_string(Life{i});
    publisher->on_event(consumer_event(wish, static_cast<std::uint32_t>(i)));
    consumers.push_back(*open_connection(to));
    rig.settle();
    const auto octets = frame_bytes({FrameKind::hello, Life{i}, 0, greeting_payload({publisher->life(), 5, 0})});
    EXPECT_GT(::send(consumers.back().get(), octets.data(), octets.size(), MSG_NOSIGNAL), 0);
    rig.settle();
    // One message of the largest size waits for this consumer alone: the others have one already.
    EXPECT_TRUE(publisher->send(large));
    rig.now += 1s;
    EXPECT_LE(outlet.waiting_octets(), max_waiting_for_consumers);
  }
  const auto changes = rig.changes<ConsumerChange>();
  EXPECT_EQ(std::ranges::count(changes, "added"), 6);
  EXPECT_GE(std::ranges::count(changes, "removed slow"), 2);
  for (const auto& event : rig.told) {
    const auto* change = std::get_if<ConsumerChange>(&event);
    if (change == nullptr || change->reason != "slow") continue;
    EXPECT_EQ(change->life, Life{1}) << "the first one has waited for the longest time";
    break;
  }
}

TEST(PlainTcp, SharesThePlacesOfProvidersByAddress) {
  ChannelRig rig;
  auto wish = rig_wish(ChannelMode::one_to_many_stream);
  wish.protocols = {"tcp"};
  auto subscriber = *SubscriberChannel::open(rig, 1, wish, {});
  subscriber->on_daemon_keys(false);
  // Listeners that accept and say nothing.
  Socket forger = *open_listener({"127.0.0.2", 0});
  Socket honest = *open_listener({"127.0.0.3", 0});
  const auto add = [&](const Socket& at, const char* address, std::uint64_t life) {
    auto offer = rig_offer(ChannelMode::one_to_many_stream, "tcp");
    offer.address = address;
    offer.port = port_of(at);
    offer.attributes[std::string(channel_attribute)] = to_string(Life{life});
    subscriber->on_event(provider_event(offer, static_cast<std::uint32_t>(life)));
    rig.settle();
  };
  std::vector<Socket> accepted;
  for (std::uint64_t i = 1; i <= max_tcp_providers + 10; ++i) {
    add(forger, "127.0.0.2", i);
    while (auto socket = accept(forger)) accepted.push_back(std::move(*socket));
  }
  EXPECT_EQ(accepted.size(), max_tcp_providers);
  EXPECT_THAT(rig.problems(), ElementsAre("all 256 places for providers over TCP are taken"));
  add(honest, "127.0.0.3", 10'000);
  EXPECT_TRUE(accept(honest)) << "an honest provider of another address is connected to";
  EXPECT_EQ(rig.problems().size(), 1U) << "told once";
}

TEST(PlainTcp, GivesThePlaceOfAProviderThatDoesNotConnectToOneThatWaits) {
  ChannelRig rig;
  auto wish = rig_wish(ChannelMode::one_to_many_stream);
  wish.protocols = {"tcp"};
  auto subscriber = *SubscriberChannel::open(rig, 1, wish, {});
  subscriber->on_daemon_keys(false);
  Socket honest = *open_listener({"127.0.0.1", 0});
  Socket closed = *open_listener({"127.0.0.1", 0});
  const std::uint16_t closed_port = port_of(closed);
  closed.close();
  for (std::uint64_t i = 1; i <= max_tcp_providers + 1; ++i) {
    auto offer = rig_offer(ChannelMode::one_to_many_stream, "tcp");
    offer.port = i > max_tcp_providers ? port_of(honest) : closed_port;
    offer.attributes[std::string(channel_attribute)] = to_string(Life{i});
    subscriber->on_event(provider_event(offer, static_cast<std::uint32_t>(i)));
  }
  rig.settle();
  EXPECT_FALSE(accept(honest));
  rig.now += stranger_patience;
  rig.settle();
  EXPECT_TRUE(accept(honest));
}

TEST(PlainTcp, SparesAProviderThatDeliversInItsSecondPlace) {
  ChannelRig rig;
  auto wish = rig_wish(ChannelMode::one_to_many_stream);
  wish.protocols = {"tcp"};
  auto subscriber = *SubscriberChannel::open(rig, 1, wish, {});
  subscriber->on_daemon_keys(false);
  Socket others = *open_listener({"127.0.0.2", 0});
  Socket provider = *open_listener({"127.0.0.2", 0});
  const std::uint16_t port = port_of(provider);
  const auto event = [&](std::uint64_t life, const char* address, std::uint16_t at) {
    auto offer = rig_offer(ChannelMode::one_to_many_stream, "tcp");
    offer.address = address;
    offer.port = at;
    offer.attributes[std::string(channel_attribute)] = to_string(Life{life});
    return provider_event(offer, static_cast<std::uint32_t>(life));
  };
  const auto deliver = [&](std::uint64_t sequence) {
    rig.settle();
    auto connection = accept(provider);
    EXPECT_TRUE(connection) << sequence;
    const auto octets = frame_bytes({FrameKind::message, Life{1}, sequence, {}});
    EXPECT_GT(::send(connection->get(), octets.data(), octets.size(), MSG_NOSIGNAL), 0);
    rig.settle();
    return std::move(*connection);
  };
  subscriber->on_event(event(1, "127.0.0.2", port));
  {
    const Socket first = deliver(1);
    std::vector<Socket> accepted;
    for (std::uint64_t i = 2; i <= max_tcp_providers + 1; ++i) {
      subscriber->on_event(event(i, "127.0.0.2", port_of(others)));
      rig.settle();
      while (auto socket = accept(others)) accepted.push_back(std::move(*socket));
    }
    EXPECT_EQ(accepted.size(), max_tcp_providers - 1);
    provider.close();
  }
  rig.settle();
  rig.pass(stranger_patience * 2);  // its place goes to the one that waits
  provider = *open_listener({"127.0.0.2", port});
  auto gone = event(2, "127.0.0.2", port_of(others));
  gone.change = Change::del;
  gone.reason = "outranked";
  subscriber->on_event(gone);
  const Socket second = deliver(2);
  subscriber->on_event(event(10'000, "127.0.0.3", port_of(others)));
  rig.settle();
  EXPECT_THAT(received(*subscriber), ElementsAre("1:0", "2:0"));
  std::array<std::byte, 256> said{};  // a hello
  while (::recv(second.get(), said.data(), said.size(), MSG_DONTWAIT) > 0) continue;
  EXPECT_EQ(::recv(second.get(), said.data(), said.size(), MSG_DONTWAIT), -1)
      << "a provider that has delivered nothing in its place should have lost it instead";
}

TEST(PlainTcp, ConnectsAgainTenSecondsAfterAnEndIfTheMatchLasts) {
  ChannelRig rig;
  auto offer = rig_offer(ChannelMode::one_to_many_stream, "tcp");
  Socket provider = *open_listener({"127.0.0.1", 0});
  offer.port = port_of(provider);
  offer.attributes[std::string(channel_attribute)] = to_string(Life{77});
  auto wish = rig_wish(ChannelMode::one_to_many_stream);
  auto subscriber = *SubscriberChannel::open(rig, 1, wish, {});
  subscriber->on_daemon_keys(false);
  subscriber->on_event(provider_event(offer));
  rig.settle();
  const auto first = accept(provider);
  ASSERT_TRUE(first);
  const auto end = frame_bytes({FrameKind::end, Life{77}, 0, {}});
  EXPECT_GT(::send(first->get(), end.data(), end.size(), MSG_NOSIGNAL), 0);
  rig.settle();
  EXPECT_THAT(rig.changes<ProviderChange>(), ElementsAre("added", "removed withdrawn"));
  rig.pass(again_patience - 10ms);
  EXPECT_FALSE(accept(provider));
  rig.pass(10ms);
  EXPECT_TRUE(accept(provider));
  EXPECT_THAT(rig.changes<ProviderChange>(), ElementsAre("added", "removed withdrawn", "added"));
}

}  // namespace
}  // namespace geminga::client
