// Publishers and subscribers without a daemon, in given time: the test tells them what a daemon would tell.
#ifndef GEMINGA_TESTS_CLIENT_CHANNELS_CHANNEL_RIG_HPP
#define GEMINGA_TESTS_CLIENT_CHANNELS_CHANNEL_RIG_HPP

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "client/channels/publisher_channel.hpp"
#include "client/channels/subscriber_channel.hpp"
#include "client/protocol/life.hpp"
#include "client/protocol/sealed_frame.hpp"

namespace geminga::client {

using namespace std::chrono_literals;

/// Keys of a mode; one ring in all tests, unless told.
inline ChannelKeys keys_of(SealingMode mode, std::uint16_t id = 7) {
  if (mode == SealingMode::plain) return {};
  const auto secret = [id](int number) {
    std::array<std::byte, secret_bytes> octets{};
    octets[0] = static_cast<std::byte>(id);
    octets[1] = static_cast<std::byte>(number);
    return Secret(octets);
  };
  return {mode, {{id, secret(1), secret(2)}}};
}

/// Keeps what channels report, and holds their reactor and its clock.
class ChannelRig final : public ChannelHost {
 public:
  Reactor& reactor() override { return reactor_; }
  void tell(ChannelEvent event) override { told.push_back(std::move(event)); }
  void on_message(ChannelNumber) override {}
  void state_port(ChannelNumber, std::uint16_t) override {}
  void state_attribute(ChannelNumber, const std::string& key, const std::string& value) override {
    stated.push_back(key + '=' + value);
  }
  std::optional<SealingMode> sealing_mode() const override { return mode; }
  bool is_settling() const override { return settles; }
  bool is_own_process() const override { return true; }
  std::span<std::byte> datagram_room() override { return room_; }

  /// Does all that is ready. On this host everything has arrived when the call that sent it returns.
  void settle() {
    for (int i = 0; i < 12; ++i) reactor_.process();
  }
  /// Lets time pass, in small steps.
  void pass(base::Duration time) {
    constexpr base::Duration step = 10ms;
    for (; time > base::Duration(0); time -= step) {
      now += std::min(step, time);
      settle();
    }
  }
  std::vector<std::string> problems() const {
    std::vector<std::string> texts;
    for (const auto& event : told) {
      if (const auto* problem = std::get_if<Problem>(&event)) texts.push_back(problem->text);
    }
    return texts;
  }
  /// "added", "removed slow", ... of the changes of this kind.
  template <typename Change>
  std::vector<std::string> changes() const {
    std::vector<std::string> words;
    for (const auto& event : told) {
      const auto* change = std::get_if<Change>(&event);
      if (change == nullptr) continue;
      words.push_back(std::string(to_string(change->what)) + (change->reason.empty() ? "" : ' ' + change->reason));
    }
    return words;
  }

  std::vector<ChannelEvent> told;
  std::vector<std::string> stated;
  std::optional<SealingMode> mode = SealingMode::plain;
  bool settles = false;
  base::Instant now{1000s};

 private:
  Reactor reactor_{[](const std::string& text) { ADD_FAILURE() << text; }, [this] { return now; }};
  std::vector<std::byte> room_ = std::vector<std::byte>(65'536);
};

inline NamedPublication rig_offer(ChannelMode mode, const std::string& protocol) {
  NamedPublication offer;
  offer.identity = TextIdentity{"ball"};
  offer.mode = mode;
  offer.protocol = protocol;
  offer.address = "127.0.0.1";
  return offer;
}

inline NamedSubscription rig_wish(ChannelMode mode) {
  NamedSubscription wish;
  wish.identity = TextIdentity{"ball"};
  wish.mode = mode;
  wish.address = "127.0.0.1";
  return wish;
}

inline ServiceKey rig_key(std::uint32_t number) { return {ParticipantId{7}, PeerId{1}, number}; }

/// The event by which a daemon tells a subscriber of an offer.
inline ServiceEvent provider_event(const NamedPublication& offer, std::uint32_t number = 1) {
  ServiceEvent event;
  event.service = rig_key(number);
  event.publication = offer;
  return event;
}

/// The event by which a daemon tells a publisher of a wish.
inline ConsumerEvent consumer_event(const NamedSubscription& wish, std::uint32_t number = 2) {
  ConsumerEvent event;
  event.subscription = rig_key(number);
  event.subscribed = wish;
  return event;
}

/// All messages that are here, as `SEQUENCE:MISSED`.
inline std::vector<std::string> received(SubscriberChannel& subscriber) {
  std::vector<std::string> all;
  while (const auto message = subscriber.take()) {
    all.push_back(std::to_string(message->sequence) + ':' + std::to_string(message->missed));
  }
  return all;
}

inline std::vector<std::byte> octets_of(std::string_view text) {
  const auto view = std::as_bytes(std::span(text));
  return {view.begin(), view.end()};
}

/// A UDP socket by which a test speaks itself.
class Speaker {
 public:
  explicit Speaker(ChannelRig& rig, const char* address = "127.0.0.1")
      : rig_(rig), socket_(*open_datagrams({address, 0})), address_(*peer_address(address, port_of(socket_))) {}

  [[nodiscard]] PeerAddress address() const { return address_; }
  void send(const PeerAddress& to, std::span<const std::byte> octets) {
    const std::array parts{part(octets)};
    EXPECT_EQ(send_datagram(socket_, to, parts), 0);
    for (int i = 0; i < 3; ++i) rig_.reactor().process();
  }
  void send(const PeerAddress& to, const Frame& frame) { send(to, frame_bytes(frame)); }
  /// The datagrams that have come.
  std::vector<std::vector<std::byte>> hear() {
    std::vector<std::vector<std::byte>> all;
    const auto room = rig_.datagram_room();
    while (true) {
      const auto count = ::recv(socket_.get(), room.data(), room.size(), MSG_DONTWAIT);
      if (count < 0) return all;
      all.emplace_back(room.begin(), room.begin() + count);
    }
  }

 private:
  ChannelRig& rig_;
  Socket socket_;
  PeerAddress address_;
};

}  // namespace geminga::client

#endif
