// How many connections a publisher over TCP has, at the limits; and which events wait in a node.
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <string>
#include <vector>

#include "client/channels/engine.hpp"
#include "client/channels/socket.hpp"
#include "client/protocol/frame.hpp"
#include "client/scripted_daemon.hpp"

namespace geminga::client {
namespace {

using namespace std::chrono_literals;

/// A publisher of a stream that lets everybody listen, without a daemon.
class TcpLimits : public testing::Test {
 protected:
  TcpLimits()
      : engine_({{Endpoint{"127.0.0.1", free_port()}}, "", 5s},
                [this](std::string_view line) { lines_.emplace_back(line); }) {
    NamedPublication offer;
    offer.identity = TextIdentity{"ball"};
    offer.mode = ChannelMode::one_to_many_stream;
    offer.protocol = "tcp";
    number_ = *engine_.publish(offer);
    publisher().set_keys(ChannelKeys());
    port_ = std::get<NamedPublication>(engine_.find(number_)->stated).port;
  }

  /// Connects and waits until the publisher has accepted it.
  Socket connect() {
    auto socket = open_connection(*peer_address("127.0.0.1", port_));
    settle();
    return std::move(*socket);
  }
  PublisherChannel& publisher() { return *engine_.publisher(number_); }
  void say_hello(const Socket& socket, std::uint64_t life) {
    say(socket, {FrameKind::hello, Life{life}, 0, greeting_payload({publisher().life(), 1, 0})});
  }
  void say(const Socket& socket, const Frame& frame) {
    const auto octets = frame_bytes(frame);
    EXPECT_EQ(::send(socket.get(), octets.data(), octets.size(), 0), static_cast<ssize_t>(octets.size()));
    settle();
  }
  std::vector<std::string> problems() {
    std::vector<std::string> texts;
    while (const auto event = engine_.news().next_event()) {
      if (const auto* problem = std::get_if<Problem>(&*event)) texts.push_back(problem->text);
    }
    return texts;
  }
  /// On this host everything has arrived when the call that sent it returns.
  void settle() {
    engine_.process();
    engine_.process();
  }
  static bool is_closed(const Socket& socket) {
    pollfd waiting{socket.get(), POLLIN, 0};
    std::byte octet{};
    return ::poll(&waiting, 1, 0) > 0 && ::recv(socket.get(), &octet, 1, MSG_PEEK) <= 0;
  }

  std::vector<std::string> lines_;
  Engine engine_;
  ChannelNumber number_ = 0;
  std::uint16_t port_ = 0;
};

TEST_F(TcpLimits, OneStrangerMoreIsClosed) {
  std::vector<Socket> strangers;
  for (std::size_t i = 0; i < max_strangers; ++i) strangers.push_back(connect());
  for (const Socket& one : strangers) EXPECT_FALSE(is_closed(one));
  EXPECT_TRUE(is_closed(connect()));
  EXPECT_FALSE(is_closed(strangers[0]));
  say_hello(strangers[1], 7);
  strangers.push_back(connect());
  EXPECT_FALSE(is_closed(strangers.back())) << "who said hello is no stranger any more";
}

TEST_F(TcpLimits, OneConsumerMoreIsClosed) {
  std::vector<Socket> consumers;
  for (std::size_t i = 1; i <= max_tcp_consumers; ++i) {
    consumers.push_back(connect());
    say_hello(consumers.back(), i);
  }
  EXPECT_FALSE(is_closed(consumers.back()));
  const Socket last = connect();
  EXPECT_TRUE(problems().empty());
  say_hello(last, max_tcp_consumers + 1);
  std::array<std::byte, 2 * (frame_header_bytes + greeting_bytes)> answer{};
  ASSERT_EQ(::recv(last.get(), answer.data(), answer.size(), 0), static_cast<ssize_t>(answer.size() / 2));
  const auto full = read_frame(std::span(answer).first(answer.size() / 2));
  ASSERT_TRUE(full);
  EXPECT_EQ(full->kind, FrameKind::full);
  EXPECT_EQ(read_greeting(full->payload), (Greeting{Life{max_tcp_consumers + 1}, 1, 0}));
  EXPECT_TRUE(is_closed(last));
  EXPECT_EQ(problems(), std::vector<std::string>{"all 256 places for consumers are taken"});
  const Socket again = connect();
  say_hello(again, 1);
  EXPECT_FALSE(is_closed(again)) << "a second connection takes the place of the first";
  EXPECT_TRUE(is_closed(consumers.front()));
}

TEST_F(TcpLimits, WhoSaysSomethingElseIsClosed) {
  const Socket mute = connect();
  say_hello(mute, 0);
  EXPECT_TRUE(is_closed(mute)) << "a hello without a life";
  const auto greeting = greeting_payload({publisher().life(), 1, 0});
  const auto wrong = greeting_payload({Life{99}, 1, 0});
  const auto unchallenged = greeting_payload({publisher().life(), 0, 0});
  std::vector<std::byte> longer(greeting.begin(), greeting.end());
  longer.emplace_back();
  for (const std::span<const std::byte> payload :
       {std::span<const std::byte>(wrong), std::span<const std::byte>(unchallenged), std::span<const std::byte>(),
        std::span<const std::byte>(greeting).first(8), std::span<const std::byte>(longer)}) {
    const Socket stranger = connect();
    say(stranger, {FrameKind::hello, Life{7}, 0, payload});
    EXPECT_TRUE(is_closed(stranger)) << payload.size() << " octets: at once";
  }
  const Socket sealed = connect();
  Sealer sealer(Life{7}, Direction::back);
  const ChannelKeys keys(SealingMode::encrypted, {{1, Secret::random(), Secret::random()}});
  const auto octets = *sealer.frame(keys, FrameKind::hello, 0, greeting);
  EXPECT_EQ(::send(sealed.get(), octets.data(), octets.size(), 0), static_cast<ssize_t>(octets.size()));
  settle();
  EXPECT_TRUE(is_closed(sealed)) << "a host without keys opens nothing";
  const Socket other = connect();
  EXPECT_GT(::send(other.get(), "GET / HTTP/1.1\r\nHost: robot\r\n\r\n", 31, 0), 0);
  settle();
  EXPECT_TRUE(is_closed(other));
}

TEST_F(TcpLimits, OnlyTheLastEventsWaitAndTheProgramIsToldOfTheOthers) {
  for (std::size_t i = 0; i < max_waiting_events + 1; ++i) engine_.tell(Problem{static_cast<ChannelNumber>(i), ""});
  const auto lost = std::get<Problem>(*engine_.news().next_event());
  EXPECT_EQ(lost.channel, 0U);
  EXPECT_EQ(lines_.back(), lost.text);
  EXPECT_EQ(lost.text, "1 events were thrown away: take them more often");
  EXPECT_EQ(std::get<Problem>(*engine_.news().next_event()).channel, 1U);
}

TEST(Log, SaysAfterASecondThatThereIsNoDaemonAndWhenItIsThere) {
  const std::uint16_t port = free_port();
  const std::string where = "127.0.0.1:" + std::to_string(port);
  base::Instant now{1000s};
  std::vector<std::string> lines;
  Engine engine(
      {{Endpoint{"127.0.0.1", port}}, "", 5s}, [&](std::string_view line) { lines.emplace_back(line); },
      [&] { return now; });
  const auto pass = [&](base::Duration time) {
    now += time;
    for (int i = 0; i < 5; ++i) engine.process();
  };
  pass(0s);
  pass(999ms);
  EXPECT_TRUE(lines.empty());
  pass(1ms);
  const std::string missing = "no daemon at " + where +
                              " for 1 s (Connection refused): start gemingad, or say where it is with GEMINGA_CONNECT";
  EXPECT_EQ(lines, std::vector<std::string>{missing});
  for (int i = 0; i < 20; ++i) pass(1s);
  EXPECT_EQ(lines.size(), 1U) << "once";
}

TEST_F(TcpLimits, AProcessThatWasForkedDoesNotSend) {
  const Socket consumer = connect();
  say_hello(consumer, 7);
  const pid_t child = ::fork();
  if (child == 0) {
    const auto sent = publisher().send({});
    engine_.withdraw_all();
    engine_.process();
    ::_exit(!sent && sent.error().text == "this node belongs to another process" ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_FALSE(is_closed(consumer)) << "the child ends nothing";
  EXPECT_TRUE(publisher().send({}));
  EXPECT_EQ(publisher().count().sent, 1U);
  say_hello(connect(), 8);
  EXPECT_TRUE(publisher().send({})) << "its sockets are watched as ever";
}

TEST_F(TcpLimits, ASocketThatCannotBeWatchedIsToldOf) {
  const auto watch = engine_.reactor().watch(Socket(), [](Reactor::Ready) {});
  const auto event = engine_.news().next_event();
  ASSERT_TRUE(event);
  EXPECT_EQ(std::get<Problem>(*event).text, "a socket cannot be watched: Bad file descriptor");
}

}  // namespace
}  // namespace geminga::client
