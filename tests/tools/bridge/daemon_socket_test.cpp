// Words from beyond on their way to the daemon: as many as a second takes, of any size that a word has.
#include "bridge/words/daemon_socket.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <vector>

namespace geminga::bridge {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using Given = DaemonSocket::Given;

TEST(Allowance, BeginsASecondWithTheFirstThatIsTakenAfterTheFormerOne) {
  Allowance allowance(2);
  base::Instant now{milliseconds(700)};
  EXPECT_TRUE(allowance.take(now));
  now += milliseconds(999);
  EXPECT_TRUE(allowance.take(now));
  EXPECT_FALSE(allowance.take(now));
  now += milliseconds(1);
  for (const bool is_given : {true, true, false}) EXPECT_EQ(allowance.take(now), is_given);
  now += seconds(60);
  for (const bool is_given : {true, true, false}) EXPECT_EQ(allowance.take(now), is_given) << "nothing is saved up";
}

TEST(DaemonSocket, TakesSoManyWordsASecondAndNoneThatIsTooLong) {
  base::Instant now{seconds(10)};
  client::Reactor reactor([](const std::string& why) { ADD_FAILURE() << why; }, [&now] { return now; });
  Tally tally(reactor, [](const std::string&) {});
  const auto daemon = client::open_datagrams({.address = "127.0.0.1", .port = 0});
  ASSERT_TRUE(daemon);
  const client::Endpoint own{.address = "127.0.0.1", .port = 0};
  const client::Endpoint its{.address = "127.0.0.1", .port = client::port_of(*daemon)};
  auto socket = DaemonSocket::open(own, its, reactor, tally, {.word = {}});
  ASSERT_TRUE(socket) << socket.error();
  const std::vector<std::byte> word(max_word_bytes + 1, std::byte{7});
  const DaemonSocket::Word whole(word);
  EXPECT_EQ((*socket)->give({}), Given::too_long);
  EXPECT_EQ((*socket)->give(whole), Given::too_long);
  for (int second = 0; second < 2; ++second, now += seconds(1)) {
    for (std::uint32_t given = 0; given < words_per_second; ++given) {
      ASSERT_EQ((*socket)->give(whole.first(given == 0 ? max_word_bytes : 1)), Given::given) << given;
    }
    EXPECT_EQ((*socket)->give(whole.first(1)), Given::too_many);
  }
}

}  // namespace
}  // namespace geminga::bridge
