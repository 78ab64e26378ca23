// GCNP clients on real sockets: order, limits, slow readers, and how a connection ends.
#include "env/asio/streams.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>

#include "env/loop.hpp"

namespace geminga::env {
namespace {

namespace net = boost::asio;
using net::ip::tcp;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// A listening AsioEnv, and clients to it. The clients' sockets block only where the test has run the loop before.
class StreamsTest : public testing::Test {
 protected:
  StreamsTest() {
    const auto listening = env.listen({"127.0.0.1", port}, false);
    EXPECT_TRUE(listening) << listening.error();
    env.serve(events);
  }

  /// Connects, and runs until the sink knows the client.
  tcp::socket connect() {
    tcp::socket client(context);
    client.connect({net::ip::address_v4::loopback(), port});
    const std::size_t before = events.opened.size();
    EXPECT_TRUE(run_until(context, [&] { return events.opened.size() > before; }));
    return client;
  }

  /// The octets that the client can read at this moment.
  std::string take(tcp::socket& client) {
    std::string bytes(client.available(), '\0');
    net::read(client, net::buffer(bytes));
    return bytes;
  }

  /// Whether the other side has closed, once everything that was sent was read.
  bool has_ended(tcp::socket& client) {
    client.non_blocking(true);
    char chunk[65536];
    boost::system::error_code error;
    while (client.read_some(net::buffer(chunk), error) > 0) {
    }
    return error == net::error::eof || error == net::error::connection_reset;
  }

  net::io_context context;
  std::uint16_t port = free_port();
  KeptLog log;
  KeptEvents events;
  AsioEnv env{context, log};
};

TEST_F(StreamsTest, CarryBytesBothWaysInTheirOrder) {
  tcp::socket client = connect();
  net::write(client, net::buffer("one\r\ntwo\r\n", 10));
  const StreamId id = events.opened[0];
  ASSERT_TRUE(run_until(context, [&] { return events.said[id].size() == 10; }));
  EXPECT_EQ(events.said[id], "one\r\ntwo\r\n");
  env.event([&] {
    env.write(id, "three ");
    env.write(id, "four");
    EXPECT_EQ(client.available(), 0U) << "written at the end of the event";
  });
  ASSERT_TRUE(run_until(context, [&] { return client.available() == 10; }));
  EXPECT_EQ(take(client), "three four");
}

TEST_F(StreamsTest, EndWhenTheClientCloses) {
  tcp::socket client = connect();
  const StreamId id = events.opened[0];
  net::write(client, net::buffer("last words", 10));
  client.close();
  ASSERT_TRUE(run_until(context, [&] { return !events.closed.empty(); }));
  EXPECT_THAT(events.closed, ElementsAre(id));
  EXPECT_EQ(events.said[id], "last words");
  env.event([&] { env.write(id, "to nobody"); });
}

TEST_F(StreamsTest, GiveTheirAnswersToAClientThatOnlyEndedItsSide) {
  tcp::socket client = connect();
  const StreamId id = events.opened[0];
  net::write(client, net::buffer("question", 8));
  client.shutdown(tcp::socket::shutdown_send);
  events.on_event = [&] {
    if (events.said[id] == "question" && events.closed.empty()) env.write(id, "answer");
  };
  ASSERT_TRUE(run_until(context, [&] { return !events.closed.empty() && client.available() == 6; }));
  EXPECT_EQ(take(client), "answer");
  EXPECT_TRUE(run_until(context, [&] { return has_ended(client); }));
}

TEST_F(StreamsTest, WriteWhatIsQueuedBeforeTheyClose) {
  tcp::socket client = connect();
  const StreamId id = events.opened[0];
  const std::string farewell(1'000'000, 'x');
  env.event([&] {
    env.write(id, farewell);
    env.close(id);
    env.write(id, "after the end");
  });
  client.non_blocking(true);
  std::string read;
  char chunk[65536];
  ASSERT_TRUE(run_until(context, [&] {
    boost::system::error_code error;
    while (const std::size_t size = client.read_some(net::buffer(chunk), error)) read.append(chunk, size);
    net::post(context, [] {});  // look again
    return error == net::error::eof;
  })) << read.size();
  EXPECT_EQ(read, farewell);
  EXPECT_THAT(events.closed, IsEmpty()) << "who closes is not told";
}

TEST_F(StreamsTest, CloseAClientThatHoldsFarTooMuchAndTellTheParticipant) {
  tcp::socket slow = connect();
  tcp::socket other = connect();
  const std::string chunk(1024 * 1024, 'x');
  std::size_t written = 0;
  while (events.closed.empty() && written < 4 * max_queued_bytes) {
    env.event([&] { env.write(events.opened[0], chunk); });
    written += chunk.size();
    context.restart();
    context.poll();
  }
  EXPECT_THAT(events.closed, ElementsAre(events.opened[0]));
  env.event([&] { env.write(events.opened[1], "you are served"); });
  ASSERT_TRUE(run_until(context, [&] { return other.available() == 14; }));
  EXPECT_FALSE(env.is_writing());
}

TEST_F(StreamsTest, CloseTheGreediestWhereAllTogetherHoldTooMuch) {
  std::vector<tcp::socket> stalled;
  for (std::size_t number = 0; number < 20; ++number) stalled.push_back(connect());
  tcp::socket innocent = connect();
  const std::string share(max_queued_bytes / 2 - 1, 'x');
  env.event([&] { env.write(events.opened[7], share + share); });
  env.event([&] {
    for (std::size_t number = 0; number < stalled.size(); ++number) {
      if (number != 7) env.write(events.opened[number], share);
    }
    env.write(events.opened.back(), "you are served");
  });
  ASSERT_TRUE(run_until(context, [&] { return !events.closed.empty() && innocent.available() == 14; }));
  EXPECT_EQ(events.closed.front(), events.opened[7]) << "the one that held the most";
  EXPECT_THAT(events.closed, testing::Not(testing::Contains(events.opened.back())));
}

TEST_F(StreamsTest, SayWhatIsUnsentAndWhenItHasGone) {
  tcp::socket client = connect();
  const StreamId id = events.opened[0];
  EXPECT_EQ(env.unsent(id), 0U);
  env.event([&] { env.write(id, std::string(max_queued_bytes / 2, 'x')); });
  EXPECT_GT(env.unsent(id), 0U) << "the kernel has not so much room";
  EXPECT_THAT(events.drained, IsEmpty());
  client.non_blocking(true);
  std::string chunk(65536, ' ');
  ASSERT_TRUE(run_until(context, [&] {
    boost::system::error_code error;
    client.read_some(net::buffer(chunk), error);
    net::post(context, [] {});  // look again
    return !events.drained.empty();
  }));
  EXPECT_THAT(events.drained, ElementsAre(id));
  EXPECT_EQ(env.unsent(id), 0U);
}

TEST_F(StreamsTest, SayThatAllHasGoneToWhomeverHeardThatItWaits) {
  tcp::socket first = connect();
  tcp::socket second = connect();
  env.event([&] {
    for (const StreamId id : events.opened) env.write(id, "the kernel takes this at the end of the event");
    EXPECT_GT(env.unsent(events.opened[1]), 0U);
  });
  ASSERT_TRUE(run_until(context, [&] { return !events.drained.empty(); }));
  EXPECT_THAT(events.drained, ElementsAre(events.opened[1])) << "nobody has asked about the other";
}

TEST_F(StreamsTest, AreNotReadFromWhileNothingIsWanted) {
  tcp::socket client = connect();
  const StreamId id = events.opened[0];
  env.event([&] { env.want(id, false); });
  net::write(client, net::buffer("one", 3));
  client.shutdown(tcp::socket::shutdown_send);
  context.restart();
  context.run_for(std::chrono::milliseconds(20));
  EXPECT_EQ(events.said.count(id), 0U);
  EXPECT_THAT(events.closed, IsEmpty()) << "its end is behind what it said";
  env.event([&] { env.want(id, true); });
  ASSERT_TRUE(run_until(context, [&] { return !events.closed.empty(); }));
  EXPECT_EQ(events.said[id], "one");
}

TEST_F(StreamsTest, OfAClientThatGoesOnTalkingAfterItsEndAreClosedHard) {
  tcp::socket client = connect();
  const StreamId id = events.opened[0];
  env.event([&] {
    env.write(id, "413 enough");
    env.close(id);
  });
  client.non_blocking(true);
  const std::string noise(65536, 'x');
  boost::system::error_code error;
  std::size_t said = 0;
  while (!error || error == net::error::would_block) {
    said += client.write_some(net::buffer(noise), error);
    context.restart();
    context.poll();
    ASSERT_LT(said, 4 * max_lingering_bytes);
  }
  EXPECT_EQ(events.said.count(id), 0U) << "what comes after the end is thrown away";
}

TEST_F(StreamsTest, AreAtMostMaxConnections) {
  std::vector<tcp::socket> clients;
  for (std::size_t number = 0; number < max_connections; ++number) clients.push_back(connect());
  tcp::socket one_more(context);
  one_more.connect({net::ip::address_v4::loopback(), port});
  EXPECT_TRUE(run_until(context, [&] {
    net::post(context, [] {});
    return has_ended(one_more);
  }));
  EXPECT_THAT(events.opened, SizeIs(max_connections));
  clients.pop_back();
  ASSERT_TRUE(run_until(context, [&] { return events.closed.size() == 1; }));
  tcp::socket next = connect();
  EXPECT_THAT(events.opened, SizeIs(max_connections + 1));
}

TEST_F(StreamsTest, ThatAreClosedAlreadyGiveWayToANewClient) {
  std::vector<tcp::socket> clients;
  for (std::size_t number = 0; number < max_connections; ++number) clients.push_back(connect());
  env.event([&] { env.close(events.opened[3]); });
  tcp::socket next = connect();
  EXPECT_THAT(events.opened, SizeIs(max_connections + 1));
}

TEST_F(StreamsTest, CannotListenWhereSomebodyDoes) {
  const auto again = env.listen({"127.0.0.1", port}, false);
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error(),
            "127.0.0.1:" + std::to_string(port) + " is already in use: another gemingad? choose another with --gcnp");
}

TEST_F(StreamsTest, GoWithoutAnAddressThatMayBeMissing) {
  EXPECT_TRUE(env.listen({"192.0.2.77", port}, true));
  EXPECT_THAT(log.lines, ElementsAre(HasSubstr("is not available on this host: going on without it")));
  const auto listening = env.listen({"192.0.2.77", port}, false);
  ASSERT_FALSE(listening);
  EXPECT_THAT(listening.error(), HasSubstr("cannot listen on 192.0.2.77:"));
}

}  // namespace
}  // namespace geminga::env
