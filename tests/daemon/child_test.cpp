#include "daemon/child/child.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <boost/asio/io_context.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "base/private_file.hpp"

namespace geminga::daemon {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

/// Runs `sh -c SCRIPT` as a child to its end. The shell can run its own commands, and become another program.
ChildEnd shell(const std::string& script, const ChildLimits& limits = {}, int output = -1) {
  boost::asio::io_context context;
  std::optional<ChildEnd> end;
  const auto child =
      Child::start(context, "/bin/sh", {"-c", script}, limits, [&](const ChildEnd& it) { end = it; }, output);
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

TEST(Child, ThatTakesTooLongIsKilled) {
  ChildLimits limits;
  limits.time = std::chrono::seconds(1);
  const ChildEnd end = shell("exec sleep 1000", limits);
  EXPECT_FALSE(end.has_succeeded);
  EXPECT_EQ(end.how, "stopped after 1 s");
}

TEST(Child, IsHeardUpToItsBoundAndNotHeldUpBeyond) {
  ChildLimits limits;
  for (const std::size_t size :
       {limits.words_bytes - 1, limits.words_bytes, limits.words_bytes + 1, 100 * limits.words_bytes}) {
    const ChildEnd end = shell("exec head -c " + std::to_string(size) + " /dev/zero >&2", limits);
    EXPECT_TRUE(end.has_succeeded);
    EXPECT_THAT(end.words, SizeIs(std::min(size, limits.words_bytes)));
  }
}

TEST(Child, MayNotWriteMoreThanItsBound) {
  ChildLimits limits;
  limits.file_bytes = 4096;
  for (const std::size_t size : {limits.file_bytes - 1, limits.file_bytes, limits.file_bytes + 1}) {
    const auto file = base::PrivateFile::in_memory();
    ASSERT_TRUE(file);
    const ChildEnd end = shell("exec head -c " + std::to_string(size) + " /dev/zero", limits, file->descriptor());
    EXPECT_EQ(end.has_succeeded, size <= limits.file_bytes) << size;
    struct stat status{};
    ASSERT_EQ(::fstat(file->descriptor(), &status), 0);
    EXPECT_EQ(static_cast<std::size_t>(status.st_size), std::min(size, limits.file_bytes));
  }
}

TEST(Child, StartsNothingWritesNothingAndSignalsNobody) {
  const std::string path = testing::TempDir() + "/geminga-child-" + std::to_string(::getpid());
  EXPECT_FALSE(shell("(exit 0)").has_succeeded) << "another process";
  EXPECT_FALSE(shell(": > " + path).has_succeeded) << "a new file";
  EXPECT_FALSE(shell("exec touch " + path).has_succeeded);
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_FALSE(shell("kill -0 $PPID").has_succeeded) << "a signal to us";
  EXPECT_FALSE(shell("exec unshare --user true").has_succeeded) << "a namespace";
  EXPECT_TRUE(shell("exec true").has_succeeded);
}

TEST(Child, CannotWriteIntoOurMemory) {
  EXPECT_FALSE(shell("exec 3<> /proc/$PPID/mem").has_succeeded);
  EXPECT_FALSE(shell("exec 3< /proc/$PPID/mem").has_succeeded) << "nor read it";
}

TEST(Child, ClosesOurMemoryOnlyForAsLongAsItLives) {
  ASSERT_EQ(::prctl(PR_GET_DUMPABLE), 1);
  boost::asio::io_context context;
  {
    const auto child = Child::start(context, "/bin/sh", {"-c", "exec sleep 1000"}, {}, [](const ChildEnd&) {});
    EXPECT_EQ(::prctl(PR_GET_DUMPABLE), 0);
  }
  EXPECT_EQ(::prctl(PR_GET_DUMPABLE), 1);
  (void)shell("exit 0");
  EXPECT_EQ(::prctl(PR_GET_DUMPABLE), 1);
}

TEST(Child, HasNoNetwork) {
  const ChildEnd end = shell("exec bash -c ': > /dev/udp/127.0.0.1/9'");
  EXPECT_FALSE(end.has_succeeded);
  EXPECT_THAT(end.words, HasSubstr("Permission denied"));
}

TEST(Child, HasNeitherOurFilesNorOurInput) {
  EXPECT_EQ(shell("read line; exec ls /proc/self/fd >&2").words, "0\n1\n2\n3\n") << "0, 1, 2 and the folder itself";
}

TEST(Child, IsKilledWithItsOwner) {
  boost::asio::io_context context;
  bool was_called = false;
  {
    const auto child =
        Child::start(context, "/bin/sh", {"-c", "exec sleep 1000"}, {}, [&](const ChildEnd&) { was_called = true; });
    ASSERT_TRUE(child);
  }
  context.run();  // ends at once: no event is left
  EXPECT_FALSE(was_called);
}

}  // namespace
}  // namespace geminga::daemon
