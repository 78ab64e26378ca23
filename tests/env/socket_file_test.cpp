// Unix sockets: users that may connect and have connected, and files that may be replaced or removed.
#include "env/asio/socket_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/write.hpp>
#include <filesystem>
#include <fstream>

#include "env/loop.hpp"

namespace geminga::env {
namespace {

namespace net = boost::asio;
using net::local::stream_protocol;
using testing::ElementsAre;
using testing::HasSubstr;

class SocketFileTest : public testing::Test {
 protected:
  SocketFileTest() {
    std::string pattern = testing::TempDir() + "socket-XXXXXX";
    folder = ::mkdtemp(pattern.data());
    path = folder + "/gcnp";
  }
  ~SocketFileTest() override { std::filesystem::remove_all(folder); }

  std::string folder;
  std::string path;
};

TEST_F(SocketFileTest, LetsInTheUserAndTheGroupAndSaysWhoCame) {
  net::io_context context;
  KeptLog log;
  KeptEvents events;
  AsioEnv env{context, log};
  ASSERT_TRUE(env.listen(path));
  struct stat made{};
  ASSERT_EQ(::lstat(path.c_str(), &made), 0);
  EXPECT_TRUE(S_ISSOCK(made.st_mode));
  EXPECT_EQ(made.st_mode & 0777U, 0660U);
  env.serve(events);
  stream_protocol::socket client(context);
  client.connect(stream_protocol::endpoint(path));
  net::write(client, net::buffer("hello", 5));
  ASSERT_TRUE(run_until(context, [&] { return !events.said.empty(); }));
  const passwd* user = ::getpwuid(::geteuid());
  EXPECT_THAT(events.users, ElementsAre(user == nullptr ? std::to_string(::geteuid()) : user->pw_name));
  env.event([&] { env.write(events.opened[0], "answer"); });
  ASSERT_TRUE(run_until(context, [&] { return client.available() == 6; }));
}

TEST_F(SocketFileTest, IsRemovedAtTheEnd) {
  {
    const auto file = SocketFile::make(path);
    ASSERT_TRUE(file);
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(SocketFileTest, OfADeadDaemonIsReplaced) {
  {
    net::io_context context;
    const stream_protocol::acceptor dead(context, stream_protocol::endpoint(path));
  }
  ASSERT_TRUE(std::filesystem::exists(path));
  EXPECT_TRUE(SocketFile::make(path));
}

TEST_F(SocketFileTest, OfALivingDaemonIsNot) {
  const auto living = SocketFile::make(path);
  ASSERT_TRUE(living);
  const auto second = SocketFile::make(path);
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error(), HasSubstr("already in use"));
  EXPECT_TRUE(std::filesystem::exists(path));
}

TEST_F(SocketFileTest, NeverRemovesAnythingElse) {
  std::ofstream(path) << "precious";
  const auto over_file = SocketFile::make(path);
  ASSERT_FALSE(over_file);
  EXPECT_THAT(over_file.error(), HasSubstr("is no socket"));
  EXPECT_EQ(std::filesystem::file_size(path), 8U);

  const std::string link = folder + "/link";
  std::filesystem::create_symlink(path, link);
  EXPECT_FALSE(SocketFile::make(link));
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_FALSE(SocketFile::make(folder));
}

TEST_F(SocketFileTest, LeavesAFileThatIsNotItsOwnAnyMore) {
  {
    const auto file = SocketFile::make(path);
    ASSERT_TRUE(file);
    std::filesystem::remove(path);
    std::ofstream(path) << "another's";
  }
  EXPECT_TRUE(std::filesystem::exists(path));
}

TEST_F(SocketFileTest, HasAPathOfAtMostItsLimit) {
  const std::string longest = folder + "/" + std::string(max_socket_path_bytes - folder.size() - 1, 'x');
  EXPECT_TRUE(SocketFile::make(longest.substr(0, max_socket_path_bytes - 1)));
  EXPECT_TRUE(SocketFile::make(longest));
  EXPECT_FALSE(SocketFile::make(longest + "x"));
  EXPECT_FALSE(SocketFile::make(""));
  EXPECT_FALSE(SocketFile::make(folder + "/missing/gcnp"));
}

/// A listening socket on a port of the system's choice, as a supervisor makes it.
int given_socket(const char* address) {
  net::io_context context;
  net::ip::tcp::acceptor acceptor(context, {net::ip::make_address(address), 0});
  return acceptor.release();
}

TEST(GivenSocket, IsServedLikeAnotherAndItsPlaceIsNotListenedOnAgain) {
  net::io_context context;
  KeptLog log;
  KeptEvents events;
  AsioEnv env{context, log};
  const auto place = env.adopt(given_socket("127.0.0.1"));
  ASSERT_TRUE(place) << place.error();
  const auto endpoint = parse_endpoint(*place);
  ASSERT_TRUE(endpoint);
  EXPECT_TRUE(env.listen(*endpoint, false)) << "it is there already";
  env.serve(events);
  net::ip::tcp::socket client(context);
  client.connect({net::ip::make_address(endpoint->address), endpoint->port});
  net::write(client, net::buffer("hello", 5));
  EXPECT_TRUE(run_until(context, [&] { return !events.said.empty(); }));
}

TEST_F(SocketFileTest, MayBeGivenByASupervisor) {
  net::io_context context;
  KeptLog log;
  AsioEnv env{context, log};
  stream_protocol::acceptor acceptor(context, stream_protocol::endpoint(path));
  EXPECT_EQ(env.adopt(acceptor.release()), path);
  EXPECT_TRUE(env.listen(path)) << "it is there already";
}

TEST(GivenSocket, IsRefusedWhereOtherHostsCanReachItOrItDoesNotListen) {
  net::io_context context;
  KeptLog log;
  AsioEnv env{context, log};
  const int open_to_all = given_socket("0.0.0.0");
  EXPECT_THAT(env.adopt(open_to_all).error(), HasSubstr("which other hosts can reach"));
  ::close(open_to_all);
  EXPECT_THAT(env.adopt(STDERR_FILENO).error(), HasSubstr("no listening stream socket"));
  EXPECT_THAT(env.adopt(-1).error(), HasSubstr("no listening stream socket"));
  net::ip::udp::socket datagrams(context, net::ip::udp::v4());
  EXPECT_THAT(env.adopt(datagrams.native_handle()).error(), HasSubstr("no listening stream socket"));
}

}  // namespace
}  // namespace geminga::env
