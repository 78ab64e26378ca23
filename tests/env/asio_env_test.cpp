// AsioEnv on the loopback interface: time, datagrams, and clients from connect to close.
#include "env/asio/asio_env.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/asio/ip/multicast.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>

#include "env/asio/streams.hpp"
#include "env/loop.hpp"

namespace geminga::env {
namespace {

namespace net = boost::asio;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// One AsioEnv with its log.
struct Station {
  explicit Station(net::io_context& context) : env(context, log) {}
  void open(std::uint16_t port, std::vector<std::string> groups = {"239.192.47.17", "ff02::4717"},
            std::vector<HostPort> peers = {}) {
    env.open_air({.interfaces = {"lo"}, .groups = std::move(groups), .port = port, .peers = std::move(peers)});
    env.serve(events);
  }
  void send(std::string_view text) {
    for (const Interface& interface : env.interfaces()) env.send(interface.index, bytes_of(text));
  }
  KeptLog log;
  KeptEvents events;
  AsioEnv env;
};

TEST(AsioEnvTime, StandsStillWithinAnEventAndGoesOnBetween) {
  net::io_context context;
  Station station(context);
  base::Instant first;
  station.env.event([&] {
    first = station.env.now();
    while (std::chrono::steady_clock::now().time_since_epoch() <= first.time_since_epoch()) {
    }
    EXPECT_EQ(station.env.now(), first);
  });
  station.env.event([&] { EXPECT_GT(station.env.now(), first); });
}

TEST(AsioEnvTimer, ComesAtItsInstantAndNotBefore) {
  net::io_context context;
  Station station(context);
  station.env.serve(station.events);
  base::Instant wanted;
  station.env.event([&] {
    wanted = station.env.now() + std::chrono::milliseconds(30);
    station.env.wake_at(wanted);
  });
  station.events.on_event = [&] { EXPECT_GE(station.env.now(), wanted); };
  EXPECT_TRUE(run_until(context, [&] { return station.events.timers == 1; }));
}

TEST(AsioEnvTimer, IsReplacedByALaterCallEarlierOrLater) {
  net::io_context context;
  Station station(context);
  station.env.serve(station.events);
  base::Instant wanted;
  station.env.event([&] {
    wanted = station.env.now() + std::chrono::milliseconds(40);
    station.env.wake_at(station.env.now() + std::chrono::milliseconds(5));
    station.env.wake_at(wanted);  // later than the first
    station.env.wake_at(base::never);
    station.env.wake_at(wanted);
  });
  station.events.on_event = [&] { EXPECT_GE(station.env.now(), wanted); };
  EXPECT_TRUE(run_until(context, [&] { return station.events.timers == 1; }));
  station.env.event([&] {
    wanted = station.env.now() + std::chrono::milliseconds(5);
    station.env.wake_at(station.env.now() + std::chrono::hours(10));
    station.env.wake_at(wanted);  // earlier than the first
  });
  EXPECT_TRUE(run_until(context, [&] { return station.events.timers == 2; }));
}

TEST(AsioEnvTimer, InThePastComesAtOnceButNotWithinTheCall) {
  net::io_context context;
  Station station(context);
  station.env.serve(station.events);
  station.env.event([&] {
    station.env.wake_at(base::Instant());
    EXPECT_EQ(station.events.timers, 0);
  });
  EXPECT_TRUE(run_until(context, [&] { return station.events.timers == 1; }));
}

TEST(AsioEnvRandom, GivesDifferentBits) {
  net::io_context context;
  Station station(context);
  EXPECT_NE(station.env.random_bits(), station.env.random_bits());
}

TEST(AsioEnvAir, CarriesDatagramsBetweenDaemonsOfOneHostAndNoEcho) {
  net::io_context context;
  const std::uint16_t port = free_port();
  Station a(context);
  Station b(context);
  a.open(port);
  b.open(port);
  ASSERT_THAT(a.env.interfaces(), SizeIs(1));
  a.send("from a");
  b.send("from b");
  ASSERT_TRUE(run_until(context, [&] { return !a.events.datagrams.empty() && !b.events.datagrams.empty(); }));
  a.send("end");
  ASSERT_TRUE(run_until(context, [&] { return b.events.datagrams.size() == 2; }));
  ASSERT_THAT(a.events.datagrams, SizeIs(1)) << "a does not hear itself";
  EXPECT_EQ(a.events.datagrams[0].bytes, "from b");
  EXPECT_EQ(a.events.datagrams[0].source, "127.0.0.1");
  EXPECT_EQ(a.events.datagrams[0].interface, a.env.interfaces()[0].index);
  EXPECT_EQ(b.events.datagrams[0].bytes, "from a");
}

TEST(AsioEnvAir, CutsADatagramThatIsTooLongToOneOctetMore) {
  net::io_context context;
  const std::uint16_t port = free_port();
  Station a(context);
  Station b(context);
  a.open(port);
  b.open(port);
  for (const std::size_t size :
       {max_datagram_bytes - 1, max_datagram_bytes, max_datagram_bytes + 1, std::size_t{9000}}) {
    a.send(std::string(size, 'x'));
  }
  ASSERT_TRUE(run_until(context, [&] { return b.events.datagrams.size() == 4; }));
  EXPECT_THAT(b.events.datagrams[0].bytes, SizeIs(max_datagram_bytes - 1));
  EXPECT_THAT(b.events.datagrams[1].bytes, SizeIs(max_datagram_bytes));
  EXPECT_THAT(b.events.datagrams[2].bytes, SizeIs(max_datagram_bytes + 1));
  EXPECT_THAT(b.events.datagrams[3].bytes, SizeIs(max_datagram_bytes + 1));
}

TEST(AsioEnvAir, SaysOnceThatANamedInterfaceIsMissing) {
  net::io_context context;
  Station station(context);
  station.env.open_air({.interfaces = {"no-such-link"}, .groups = {"239.192.47.17"}, .port = free_port(), .peers = {}});
  station.env.serve(station.events);
  EXPECT_THAT(station.env.interfaces(), IsEmpty());
  EXPECT_THAT(station.log.lines, ElementsAre(HasSubstr("interface no-such-link is not there or not up")));
}

TEST(AsioEnvUnicast, ReachesANamedPeerAndTakesOnlyNamedPeers) {
  net::io_context context;
  const std::uint16_t port_a = free_port();
  const std::uint16_t port_b = free_port();
  Station a(context);
  Station b(context);
  a.open(port_a, {}, {{"127.0.0.1", port_b}});
  // 127.1 is no numeric address for us, so it is resolved as a name. It needs no hosts file, which a fresh system may
  // lack.
  b.open(port_b, {}, {{"127.1", port_a}, {"127.0.0.1", port_b}});  // a list may name oneself
  net::ip::udp::socket stranger(context, {net::ip::make_address("127.0.0.2"), 0});
  stranger.send_to(net::buffer("from a stranger", 15), {net::ip::address_v4::loopback(), port_b});
  a.send("hello b");
  ASSERT_TRUE(run_until(context, [&] { return !b.events.datagrams.empty(); }));
  EXPECT_THAT(b.events.datagrams, SizeIs(1));
  EXPECT_EQ(b.events.datagrams[0].bytes, "hello b");
  EXPECT_EQ(b.env.air_counts().no_peer, 1U) << "what is not taken is counted";
  EXPECT_EQ(a.env.air_counts().no_peer, 0U);
  // A name is resolved while the loop runs: earlier datagrams go nowhere.
  net::steady_timer again(context);
  const std::function<void()> send_again = [&] {
    b.send("hello a");
    again.expires_after(std::chrono::milliseconds(5));
    again.async_wait([&](const boost::system::error_code& error) {
      if (!error) send_again();
    });
  };
  send_again();
  ASSERT_TRUE(run_until(context, [&] { return !a.events.datagrams.empty(); })) << testing::PrintToString(b.log.lines);
  EXPECT_EQ(a.events.datagrams[0].bytes, "hello a");
  again.cancel();
  for (const auto& datagram : b.events.datagrams) EXPECT_NE(datagram.bytes, "hello a") << "a list that names oneself";
}

TEST(AsioEnvAir, CountsWhatTheKernelDropsInAFlood) {
  net::io_context context;
  const std::uint16_t port = free_port();
  Station station(context);
  station.open(port, {"239.192.47.17"});
  // Nobody reads while these come: they are more than any receive buffer that we may have.
  net::ip::udp::socket flood(context, {net::ip::make_address("127.0.0.1"), 0});
  flood.set_option(net::ip::multicast::outbound_interface(net::ip::address_v4::loopback()));
  const std::string bytes(1400, 'x');
  for (int i = 0; i < 4000; ++i) {
    flood.send_to(net::buffer(bytes), {net::ip::make_address("239.192.47.17"), port});
  }
  ASSERT_TRUE(run_until(context, [&] { return !station.events.datagrams.empty(); }));
  // The count comes with the next datagram that found room.
  std::size_t sent = 0;
  EXPECT_TRUE(run_until(context, [&] {
    if (sent++ < 10'000) flood.send_to(net::buffer("more", 4), {net::ip::make_address("239.192.47.17"), port});
    return station.env.air_counts().overrun > 0;
  }));
}

TEST(AsioEnvUnicast, SaysThatTheAddressIsInUseInsteadOfStealing) {
  net::io_context context;
  const std::uint16_t port = free_port();
  Station a(context);
  Station b(context);
  a.open(port, {"239.192.47.17"}, {{"192.0.2.1", port}});
  b.open(port, {"239.192.47.17"}, {{"192.0.2.1", port}});
  EXPECT_THAT(b.log.lines, testing::Contains(HasSubstr("another gemingad? give one of them another --port")));
}

}  // namespace
}  // namespace geminga::env
