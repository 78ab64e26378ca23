#include "daemon/child.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <optional>

namespace geminga::daemon {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

/// Runs `sh -c SCRIPT` as a child to its end.
ChildEnd shell(const std::string& script, const ChildLimits& limits = {}) {
  boost::asio::io_context context;
  std::optional<ChildEnd> end;
  const auto child = Child::start(context, "/bin/sh", {"-c", script}, limits, [&](const ChildEnd& it) { end = it; });
  EXPECT_TRUE(child) << child.error();
  context.run();
  return end.value_or(ChildEnd{});
}

TEST(Child, TellsHowItEnded) {
  EXPECT_TRUE(shell("exit 0").has_succeeded);
  const ChildEnd failed = shell("echo this is wrong >&2; exit 2");
  EXPECT_FALSE(failed.has_succeeded);
  EXPECT_EQ(failed.how, "exit status 2");
  EXPECT_EQ(failed.words, "this is wrong\n");
  EXPECT_EQ(shell("kill -9 $$").how, "killed by signal 9");
}

TEST(Child, ThatDoesNotExistFails) {
  boost::asio::io_context context;
  std::string how;
  const auto child = Child::start(context, "/no/such/program", {}, {}, [&](const ChildEnd& end) { how = end.how; });
  context.run();
  EXPECT_THAT(how, HasSubstr("could not be executed"));
}

TEST(Child, ThatTakesTooLongIsKilledWithAllThatItStarted) {
  ChildLimits limits;
  limits.time = std::chrono::seconds(1);
  const ChildEnd end = shell("sleep 1000 & sleep 1000", limits);
  EXPECT_FALSE(end.has_succeeded);
  EXPECT_EQ(end.how, "stopped after 1 s");
}

TEST(Child, IsHeardUpToItsBoundAndNotHeldUpBeyond) {
  ChildLimits limits;
  for (const std::size_t size :
       {limits.words_bytes - 1, limits.words_bytes, limits.words_bytes + 1, 100 * limits.words_bytes}) {
    const ChildEnd end = shell("head -c " + std::to_string(size) + " /dev/zero >&2", limits);
    EXPECT_TRUE(end.has_succeeded);
    EXPECT_THAT(end.words, SizeIs(std::min(size, limits.words_bytes)));
  }
}

TEST(Child, MayNotWriteALongerFileThanItsBound) {
  ChildLimits limits;
  limits.file_bytes = 4096;
  EXPECT_FALSE(shell("f=$(mktemp); head -c 8192 /dev/zero > $f; s=$?; rm $f; exit $s", limits).has_succeeded);
  EXPECT_TRUE(shell("f=$(mktemp); head -c 4096 /dev/zero > $f; s=$?; rm $f; exit $s", limits).has_succeeded);
}

TEST(Child, HasNoNetwork) {
  const ChildEnd end = shell("exec bash -c ': > /dev/udp/127.0.0.1/9'");
  EXPECT_FALSE(end.has_succeeded);
  EXPECT_THAT(end.words, HasSubstr("Permission denied"));
}

TEST(Child, HasNeitherOurFilesNorOurInput) {
  EXPECT_EQ(shell("read line; ls /proc/self/fd | wc -l >&2").words, "4\n") << "0, 1, 2 and the folder itself";
}

TEST(Child, IsKilledWithItsOwner) {
  boost::asio::io_context context;
  bool was_called = false;
  {
    const auto child =
        Child::start(context, "/bin/sh", {"-c", "sleep 1000"}, {}, [&](const ChildEnd&) { was_called = true; });
    ASSERT_TRUE(child);
  }
  context.run();  // ends at once, because nothing is left to wait for
  EXPECT_FALSE(was_called);
}

}  // namespace
}  // namespace geminga::daemon
