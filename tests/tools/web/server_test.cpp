// HTTP on the wire: limits at their edges, patience, and readers that mean harm.
#include "web/server/server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <future>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "client/scripted_daemon.hpp"
#include "tools/web/fake_asker.hpp"
#include "tools/web/reader.hpp"

namespace geminga::web {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// Times that no test reaches, unless it sets one of them.
Limits patient() {
  Limits limits;
  limits.request_patience = limits.response_patience = limits.heartbeat = std::chrono::hours(1);
  return limits;
}

/// A server on a thread of its own.
class Hall {
 public:
  explicit Hall(Limits limits = patient()) : server_(context_, site_, limits) {
    EXPECT_TRUE(server_.listen(env::Endpoint{"127.0.0.1", port_}));
    server_.serve();
    thread_ = std::thread([this] { context_.run(); });
  }
  ~Hall() {
    context_.stop();
    thread_.join();
  }
  Hall(const Hall&) = delete;
  Hall& operator=(const Hall&) = delete;

  [[nodiscard]] std::uint16_t port() const { return port_; }
  /// Does this on the server's thread, and waits until it is done.
  void act(const std::function<void(FakeAsker&, Server&)>& action) {
    std::promise<void> done;
    boost::asio::post(context_, [&] {
      action(asker_, server_);
      done.set_value();
    });
    done.get_future().wait();
  }
  /// Waits until this holds on the server's thread.
  bool until(const std::function<bool(FakeAsker&, Server&)>& holds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    bool is_so = false;
    while (!is_so && std::chrono::steady_clock::now() < end) {
      act([&](FakeAsker& asker, Server& server) { is_so = holds(asker, server); });
    }
    return is_so;
  }

 private:
  const std::uint16_t port_ = client::free_port();
  boost::asio::io_context context_{1};
  FakeAsker asker_;
  History history_{asker_, std::chrono::seconds(0)};
  Site site_{asker_, history_, {}};
  Server server_;
  std::thread thread_;
};

/// The status that a fresh connection is told after these octets; 0: it is closed without a word.
int status_after(const Hall& hall, std::string_view octets) {
  Reader reader(hall.port());
  reader.send(octets);
  const auto reply = reader.reply();
  return reply ? reply->status : 0;
}

TEST(Server, AnswersGetAndHeadAndKeepsTheConnection) {
  Hall hall;
  Reader reader(hall.port());
  ASSERT_TRUE(reader.send(get_request("/livez")));
  const auto reply = reader.reply();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, 200);
  EXPECT_EQ(reply->body, "ok\n");
  EXPECT_EQ(reply->fields.at("x-content-type-options"), "nosniff");
  EXPECT_EQ(reply->fields.at("cross-origin-resource-policy"), "same-origin");
  EXPECT_THAT(reply->fields.at("content-security-policy"), HasSubstr("default-src 'none'"));
  EXPECT_FALSE(reply->fields.contains("access-control-allow-origin"));
  EXPECT_FALSE(reply->fields.contains("server"));
  ASSERT_TRUE(reader.send("HEAD /livez HTTP/1.1\r\nHost: localhost\r\n\r\n"));
  const auto head = reader.reply(false);
  ASSERT_TRUE(head);
  EXPECT_EQ(head->status, 200);
  EXPECT_EQ(head->fields.at("content-length"), "3");
  EXPECT_TRUE(reader.is_quiet());
}

TEST(Server, AnswersPipelinedRequestsInTheirOrder) {
  Hall hall;
  Reader reader(hall.port());
  std::string requests;
  for (int i = 0; i < 200; ++i) requests += get_request(i % 2 == 0 ? "/livez" : "/nothing");
  ASSERT_TRUE(reader.send(requests));
  for (int i = 0; i < 200; ++i) {
    const auto reply = reader.reply();
    ASSERT_TRUE(reply) << i;
    EXPECT_EQ(reply->status, i % 2 == 0 ? 200 : 404) << i;
  }
}

TEST(Server, SpeaksHttp10AndClosesThen) {
  Hall hall;
  Reader reader(hall.port());
  ASSERT_TRUE(reader.send("GET /livez HTTP/1.0\r\nHost: localhost\r\n\r\n"));
  EXPECT_EQ(reader.reply()->status, 200);
  EXPECT_TRUE(reader.is_closed());
  EXPECT_EQ(status_after(hall, "GET /livez HTTP/1.0\r\n\r\n"), 400) << "it has to say its Host, too";
}

TEST(Server, RefusesWhatIsNoRequest) {
  Hall hall;
  for (const std::string& octets :
       {std::string("\r\n\r\n\r\n"), std::string("GARBAGE\r\n\r\n"),
        std::string("GET  /livez HTTP/1.1\r\nHost: localhost\r\n\r\n"),
        std::string("GET /livez HTTP/1.1\r\nHost localhost\r\n\r\n"),
        std::string("GET /livez HTTP/1.1\r\nHost: a\r\n: b\r\n\r\n"),
        std::string("GET /livez HTTP/1.1\r\nHost: local\0host\r\n\r\n", 42),
        std::string("GET /li\0vez HTTP/1.1\r\nHost: localhost\r\n\r\n", 42),
        std::string("GET /livez HTTP/1.1\r\nHost: localhost\r\nX Y: 1\r\n\r\n"), std::string("GET / HTTP/1.1\r\n\r\n"),
        std::string("GET / HTTP/1.1\r\nHost: a\r\nContent-Length: 1\r\nContent-Length: 2\r\n\r\n"),
        std::string("GET / HTTP/1.1\r\nHost: a\r\nContent-Length: -1\r\n\r\n"),
        std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", 11)}) {
    EXPECT_EQ(status_after(hall, octets), 400) << octets;
  }
  EXPECT_EQ(status_after(hall, "GET / HTTP/2.0\r\nHost: localhost\r\n\r\n"), 505);
  EXPECT_EQ(status_after(hall, "GET / HTTP/0.9\r\nHost: localhost\r\n\r\n"), 505);
  EXPECT_EQ(status_after(hall, "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"), 505);
  EXPECT_EQ(status_after(hall, "BREW / HTTP/1.1\r\nHost: localhost\r\n\r\n"), 405);
  EXPECT_EQ(get(hall.port(), "/livez").status, 200) << "and lives on";
}

TEST(Server, TakesNoBody) {
  Hall hall;
  EXPECT_EQ(status_after(hall, get_request("/livez", "Content-Length: 0\r\n")), 200);
  EXPECT_EQ(status_after(hall, get_request("/livez", "Content-Length: 1\r\n") + "x"), 413);
  EXPECT_EQ(status_after(hall, get_request("/livez", "Content-Length: 18446744073709551615\r\n")), 413);
  EXPECT_EQ(status_after(hall, get_request("/livez", "Transfer-Encoding: chunked\r\n") + "0\r\n\r\n"), 413);
  Reader reader(hall.port());
  reader.send(get_request("/livez", "Content-Length: 100000\r\n") + std::string(100'000, 'x'));
  EXPECT_EQ(reader.reply()->status, 413) << "though it sends all of it";
  EXPECT_TRUE(reader.is_closed());
}

TEST(Server, BoundsTheHead) {
  Limits limits = patient();
  limits.head_octets = 1000;
  Hall hall(limits);
  for (const int beyond : {-1, 0, 1}) {
    const std::string before = get_request("/livez", "X: \r\n");
    const auto filling = limits.head_octets - before.size() + static_cast<std::size_t>(beyond);
    const std::string request = get_request("/livez", "X: " + std::string(filling, 'a') + "\r\n");
    EXPECT_EQ(status_after(hall, request), beyond <= 0 ? 200 : 431) << beyond;
  }
  EXPECT_EQ(status_after(hall, std::string(1'000'000, 'A')), 431);
  EXPECT_EQ(status_after(hall, "GET /livez HTTP/1.1\r\nHost: localhost\r\n" + std::string(1'000'000, 'a')), 431);
  std::string fields;
  for (int i = 0; i < 10'000; ++i) fields += "a:\r\n";
  EXPECT_EQ(status_after(hall, get_request("/livez", fields)), 431);
}

TEST(Server, BoundsTheRequestsOfAConnection) {
  Limits limits = patient();
  limits.requests = 3;
  Hall hall(limits);
  Reader reader(hall.port());
  ASSERT_TRUE(
      reader.send(get_request("/livez") + get_request("/livez") + get_request("/livez") + get_request("/livez")));
  for (int i = 1; i <= 3; ++i) {
    const auto reply = reader.reply();
    ASSERT_TRUE(reply) << i;
    EXPECT_EQ(reply->fields.contains("connection"), i == 3) << i;
  }
  EXPECT_TRUE(reader.is_closed());
}

TEST(Server, ClosesTheOneThatHasWaitedLongestForOneMore) {
  Limits limits = patient();
  limits.connections = 3;
  Hall hall(limits);
  std::vector<Reader> readers;
  for (std::size_t i = 0; i < 3; ++i) {
    readers.emplace_back(hall.port());
    ASSERT_TRUE(readers.back().send(get_request("/livez")));
    ASSERT_TRUE(readers.back().reply());
  }
  ASSERT_TRUE(readers[0].send(get_request("/livez")));  // the second one waits longest from here on
  ASSERT_TRUE(readers[0].reply());
  EXPECT_EQ(get(hall.port(), "/livez").status, 200);
  EXPECT_TRUE(readers[1].is_closed());
  EXPECT_TRUE(readers[0].is_quiet());
  EXPECT_TRUE(readers[2].is_quiet());
}

TEST(Server, TurnsAwayWhereEachConnectionIsBeingAnswered) {
  Limits limits = patient();
  limits.connections = 2;
  Hall hall(limits);
  hall.act([](FakeAsker& asker, Server&) { asker.is_held = true; });
  Reader one(hall.port());
  Reader two(hall.port());
  ASSERT_TRUE(one.send(get_request("/readyz")));
  ASSERT_TRUE(two.send(get_request("/readyz")));
  ASSERT_TRUE(hall.until([](FakeAsker& asker, Server&) { return asker.held.size() == 2; }));
  Reader three(hall.port());
  const auto reply = three.reply();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, 503);
  EXPECT_EQ(reply->body, "{\"error\":\"there are as many connections as may be: try it later\"}\n");
  EXPECT_TRUE(three.is_closed());
  hall.act([](FakeAsker& asker, Server&) { asker.release(); });
  EXPECT_EQ(one.reply()->status, 503);
  EXPECT_EQ(two.reply()->body, "nobody is there\n");
}

TEST(Server, AnswersWhileThousandsConnectAndSayNothing) {
  Limits limits = patient();
  limits.connections = 8;
  Hall hall(limits);
  std::vector<Reader> idle;
  for (int i = 0; i < 900; ++i) {
    idle.emplace_back(hall.port());
    if (i % 100 != 0) continue;
    EXPECT_EQ(get(hall.port(), "/livez").status, 200) << i;
  }
  EXPECT_EQ(get(hall.port(), "/livez").status, 200);
  EXPECT_TRUE(hall.until([](FakeAsker&, Server& server) { return server.connection_count() <= 8; }));
  for (int i = 0; i < 3000; ++i) Reader{hall.port()};
  EXPECT_EQ(get(hall.port(), "/livez").status, 200);
}

TEST(Server, ClosesAReaderThatSendsItsHeadTooSlowly) {
  Limits limits = patient();
  limits.request_patience = std::chrono::milliseconds(100);
  Hall hall(limits);
  Reader silent(hall.port());
  EXPECT_FALSE(silent.reply()) << "nothing is said to a reader that says nothing";
  // Where this host is so slow that nothing came in time, the reader is silent, too, and another one tries.
  std::optional<Reply> reply;
  while (!reply) {
    Reader slow(hall.port());
    slow.send("GET /livez HTTP/1.1\r\nHost: ");
    // Each octet in time does not make the whole in time.
    while (slow.is_quiet() && slow.send("a")) {
    }
    reply = slow.reply();
  }
  EXPECT_THAT(reply->status, testing::AnyOf(408, 431));
}

TEST(Server, ClosesAReaderThatDoesNotTakeItsResponse) {
  Limits limits = patient();
  limits.response_patience = std::chrono::milliseconds(100);
  Hall hall(limits);
  hall.act([](FakeAsker& asker, Server&) {
    asker.outcomes["services"] = answered({record("services", {{"service", std::string(15'000'000, 'a')}})});
  });
  Reader reader(hall.port());
  ASSERT_TRUE(reader.send(get_request("/api/services")));
  EXPECT_TRUE(hall.until(
      [](FakeAsker& asker, Server& server) { return !asker.asked.empty() && server.connection_count() == 0; }));
}

TEST(Server, ForgetsAReaderThatGoesBeforeItsAnswer) {
  Hall hall;
  hall.act([](FakeAsker& asker, Server&) { asker.is_held = true; });
  {
    Reader reader(hall.port());
    ASSERT_TRUE(reader.send(get_request("/readyz")));
    ASSERT_TRUE(hall.until([](FakeAsker& asker, Server&) { return asker.held.size() == 1; }));
  }
  hall.act([](FakeAsker& asker, Server&) { asker.release(); });
  EXPECT_TRUE(hall.until([](FakeAsker&, Server& server) { return server.connection_count() == 0; }));
}

Outcome services(int port) {
  return answered({record("services", {{"service", "a/1/1"}, {"port", std::to_string(port)}})});
}

TEST(Server, StreamsEventsUntilTheReaderGoes) {
  Hall hall;
  hall.act([](FakeAsker& asker, Server&) { asker.outcomes["services"] = services(5000); });
  {
    Reader reader(hall.port());
    ASSERT_TRUE(reader.send(get_request("/api/events?of=services")));
    const auto reply = reader.reply();
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->fields.at("content-type"), "text/event-stream");
    EXPECT_TRUE(reader.wait_for("data: {\"event\":\"add\""));
    hall.act([](FakeAsker& asker, Server&) { asker.outcomes["services"] = services(5001); });
    EXPECT_TRUE(reader.wait_for("\"former\":{\"port\":5000}"));
  }
  EXPECT_TRUE(hall.until(
      [](FakeAsker&, Server& server) { return server.stream_count() == 0 && server.connection_count() == 0; }));
}

TEST(Server, BoundsTheStreams) {
  for (const std::size_t limit : {std::size_t{1}, std::size_t{2}, std::size_t{3}}) {
    Limits limits = patient();
    limits.streams = limit;
    Hall hall(limits);
    hall.act([](FakeAsker& asker, Server&) { asker.outcomes["services"] = services(5000); });
    std::vector<Reader> readers;
    for (std::size_t i = 1; i <= limit + 1; ++i) {
      readers.emplace_back(hall.port());
      ASSERT_TRUE(readers.back().send(get_request("/api/events?of=services")));
      EXPECT_EQ(readers.back().reply()->status, i <= limit ? 200 : 503) << i << " of " << limit;
    }
  }
}

TEST(Server, SaysNowAndThenThatAStreamLives) {
  Limits limits = patient();
  limits.heartbeat = std::chrono::milliseconds(0);
  Hall hall(limits);
  hall.act([](FakeAsker& asker, Server&) { asker.outcomes["services"] = answered({}); });
  Reader reader(hall.port());
  ASSERT_TRUE(reader.send(get_request("/api/events?of=services")));
  ASSERT_TRUE(reader.reply());
  EXPECT_TRUE(reader.wait_for(":\n\n"));
}

TEST(Server, BringsASlowReaderUpToDateOrLeavesIt) {
  Limits limits = patient();
  limits.response_patience = std::chrono::milliseconds(200);
  Hall hall(limits);
  // Each answer is another one of 4 MB, which a reader that takes nothing cannot be told.
  int port = 0;
  hall.act([](FakeAsker& asker, Server&) {
    asker.outcomes["services"] = answered({record("services", {{"service", "a"}, {"x", std::string(4'000'000, 'a')}})});
  });
  Reader reader(hall.port());
  ASSERT_TRUE(reader.send(get_request("/api/events?of=services")));
  EXPECT_TRUE(hall.until([&](FakeAsker& asker, Server& server) {
    asker.outcomes["services"] = answered(
        {record("services", {{"service", "a"}, {"x", std::string(4'000'000, static_cast<char>('b' + port++ % 20))}})});
    return asker.asked.size() > 1 && server.stream_count() == 0;
  }));
}

TEST(Server, SaysThatTheAddressIsTaken) {
  Hall hall;
  boost::asio::io_context context;
  FakeAsker asker;
  const History history(asker, std::chrono::seconds(0));
  Site site(asker, history, {});
  Server second(context, site);
  const auto listening = second.listen(env::Endpoint{"127.0.0.1", hall.port()});
  ASSERT_FALSE(listening);
  EXPECT_THAT(listening.error(), HasSubstr("is another geminga-web running?"));
}

}  // namespace
}  // namespace geminga::web
