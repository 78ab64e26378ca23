// Frames over UDP that overtake the daemon's word of who sends them (src/client/CHANNELS.md, Early frames).
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <string>
#include <vector>

#include "client/channels/subscriber_channel.hpp"
#include "client/protocol/early_frames.hpp"
#include "client/protocol/life.hpp"

namespace geminga::client {
namespace {

using namespace std::chrono_literals;

constexpr Life one_life{7};
constexpr Life other_life{8};
constexpr base::Instant start{5s};

Frame message(std::uint64_t sequence, std::span<const std::byte> payload = {}, Life life = one_life) {
  return {FrameKind::message, life, sequence, payload};
}

void put(EarlyFrames& early, const PeerAddress& from, const Frame& frame, base::Instant now) {
  const auto octets = frame_bytes(frame);
  early.put(from, frame_of(octets), now);
}

std::vector<std::uint64_t> sequences(const std::vector<EarlyFrames::Kept>& frames) {
  std::vector<std::uint64_t> all;
  for (const auto& kept : frames) all.push_back(kept.frame().sequence);
  return all;
}

TEST(EarlyFrames, AreTakenByAddressAndLife) {
  EarlyFrames early;
  const PeerAddress here{{}, 0, 1};
  const PeerAddress there{{}, 0, 2};
  put(early, here, message(1), start);
  put(early, there, message(2), start);
  put(early, here, message(3, {}, other_life), start);
  put(early, here, message(4), start);
  EXPECT_EQ(sequences(early.take(here, one_life, start)), (std::vector<std::uint64_t>{1, 4}));
  EXPECT_TRUE(early.take(here, one_life, start).empty());
  EXPECT_EQ(sequences(early.take(there, one_life, start)), std::vector<std::uint64_t>{2});
}

TEST(EarlyFrames, AreKeptForASecond) {
  EarlyFrames early;
  put(early, PeerAddress{}, message(1), start);
  put(early, PeerAddress{}, message(2), start + 1ms);
  EXPECT_EQ(sequences(early.take({}, one_life, start + early_patience)), std::vector<std::uint64_t>{2});
}

TEST(EarlyFrames, AreTheLastOnesWhereThereAreMany) {
  EarlyFrames early;
  for (std::size_t i = 0; i < max_early_frames + 1; ++i) put(early, PeerAddress{}, message(i), start);
  const auto kept = early.take({}, one_life, start);
  EXPECT_EQ(kept.size(), max_early_frames);
  EXPECT_EQ(kept.front().frame().sequence, 1U);
}

TEST(EarlyFrames, AreTheLastOnesWhereTheyAreLarge) {
  EarlyFrames early;
  const std::vector<std::byte> half(max_early_octets / 2);
  for (const std::uint64_t sequence : {1U, 2U}) put(early, PeerAddress{}, message(sequence, half), start);
  put(early, PeerAddress{}, message(3), start);
  EXPECT_EQ(early.take({}, one_life, start).size(), 3U) << "at the limit";
  for (const std::uint64_t sequence : {1U, 2U}) put(early, PeerAddress{}, message(sequence, half), start);
  put(early, PeerAddress{}, message(3, std::array<std::byte, 1>{}), start);
  EXPECT_EQ(sequences(early.take({}, one_life, start)), (std::vector<std::uint64_t>{2, 3}));
}

/// Keeps what a subscriber reports, and holds its reactor.
class Host final : public ChannelHost {
 public:
  Reactor& reactor() override { return reactor_; }
  void tell(ChannelEvent event) override { told.push_back(std::move(event)); }
  void on_message(ChannelNumber) override {}
  void state_port(ChannelNumber, std::uint16_t) override {}
  void state_attribute(ChannelNumber, const std::string&, const std::string&) override {}
  std::optional<SealingMode> sealing_mode() const override { return SealingMode::plain; }
  bool is_settling() const override { return false; }
  bool is_own_process() const override { return true; }
  std::span<std::byte> datagram_room() override { return room_; }

  std::vector<ChannelEvent> told;

 private:
  Reactor reactor_{[](const std::string& text) { ADD_FAILURE() << text; }};
  std::vector<std::byte> room_ = std::vector<std::byte>(65'536);
};

/// A subscriber, and a provider of which no daemon has told it.
class EarlyProvider : public testing::Test {
 protected:
  EarlyProvider() {
    NamedSubscription wish;
    wish.identity = TextIdentity{"ball"};
    wish.mode = ChannelMode::one_to_many_pubsub;
    wish.address = "127.0.0.1";
    subscriber_ = *SubscriberChannel::open(host_, 1, wish, {});
    subscriber_->on_daemon_keys(false);
    to_ = *peer_address("127.0.0.1", wish.port);
    socket_ = *open_datagrams({"127.0.0.1", 0});
  }

  /// On this host a datagram has arrived when the call that sent it returns.
  void send(const Frame& frame) {
    const auto bytes = frame_bytes(frame);
    const std::array parts{part(bytes)};
    EXPECT_EQ(send_datagram(socket_, to_, parts), 0);
    host_.reactor().process();
  }
  void add(Life life) {
    ServiceEvent event;
    event.change = Change::add;
    event.publication.identity = TextIdentity{"ball"};
    event.publication.mode = ChannelMode::one_to_many_pubsub;
    event.publication.address = "127.0.0.1";
    event.publication.port = port_of(socket_);
    event.publication.protocol = "udp";
    event.publication.attributes[std::string(channel_attribute)] = to_string(life);
    subscriber_->on_event(event);
  }
  /// The sequences of all that is delivered.
  std::vector<std::uint64_t> delivered() {
    std::vector<std::uint64_t> all;
    while (const auto message = subscriber_->take()) all.push_back(message->sequence);
    return all;
  }

  Host host_;
  std::unique_ptr<SubscriberChannel> subscriber_;
  PeerAddress to_;
  Socket socket_;
};

TEST_F(EarlyProvider, IsHeardWhenTheDaemonTellsOfIt) {
  send(message(1));
  send(message(2));
  EXPECT_EQ(subscriber_->count().dropped, 2U);
  EXPECT_TRUE(delivered().empty()) << "nobody knows whose it is";
  add(one_life);
  EXPECT_EQ(subscriber_->count().dropped, 0U);
  EXPECT_EQ(delivered(), (std::vector<std::uint64_t>{1, 2}));
  send(message(3));
  EXPECT_EQ(delivered(), std::vector<std::uint64_t>{3});
}

TEST_F(EarlyProvider, IsNobodyWithAnotherLife) {
  send(message(1));
  add(other_life);
  EXPECT_TRUE(delivered().empty());
  EXPECT_EQ(subscriber_->count().dropped, 1U);
}

TEST_F(EarlyProvider, MayBeTheNextLifeOfAnother) {
  add(other_life);
  send(message(1));
  EXPECT_TRUE(delivered().empty());
  add(one_life);
  EXPECT_EQ(delivered(), std::vector<std::uint64_t>{1});
}

TEST_F(EarlyProvider, MayHaveEndedAlready) {
  send(message(1));
  send({FrameKind::end, one_life, 3, {}});
  add(one_life);
  EXPECT_EQ(delivered(), std::vector<std::uint64_t>{1});
  ASSERT_EQ(host_.told.size(), 1U) << "anybody can say that";
  ServiceEvent gone;
  gone.change = Change::del;
  gone.reason = "expired";
  subscriber_->on_event(gone);
  ASSERT_EQ(host_.told.size(), 2U) << "but the daemon says it, too";
  EXPECT_EQ(std::get<ProviderChange>(host_.told[1]).reason, "withdrawn");
  EXPECT_EQ(subscriber_->count().missed, 2U);
}

TEST_F(EarlyProvider, LosesItsEldestDatagramWhereTheProgramTakesNone) {
  add(one_life);
  for (std::uint64_t i = 1; i <= max_waiting_messages + 1; ++i) send(message(i));
  EXPECT_EQ(subscriber_->count().received, max_waiting_messages);
  EXPECT_EQ(subscriber_->count().missed, 1U);
  EXPECT_EQ(subscriber_->count().dropped, 0U);
  const auto first = subscriber_->take();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->sequence, 2U);
  EXPECT_EQ(first->missed, 1U);
  EXPECT_EQ(delivered().back(), max_waiting_messages + 1);
}

}  // namespace
}  // namespace geminga::client
