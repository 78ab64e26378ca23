#include "daemon/supervisor/supervisor.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "daemon/log/journal_writer.hpp"
#include "daemon/log/log.hpp"
#include "supervising.hpp"

namespace geminga::daemon {
namespace {

std::string own_process() { return std::to_string(::getpid()); }

TEST(Supervisor, IsToldOfTheStartAReloadItsEndSignsOfLifeAndTheStop) {
  const Listener systemd;
  const Supervisor supervisor = supervised_by({"NOTIFY_SOCKET=" + systemd.path()});
  supervisor.say_ready("ready: gcnp 127.0.0.1:4717");
  EXPECT_EQ(systemd.next(), "READY=1\nSTATUS=ready: gcnp 127.0.0.1:4717\n");
  supervisor.say_reloading(base::Instant(std::chrono::microseconds(123456789)));
  EXPECT_EQ(systemd.next(), "RELOADING=1\nMONOTONIC_USEC=123456789\n");
  supervisor.say_alive();
  EXPECT_EQ(systemd.next(), "WATCHDOG=1\n");
  supervisor.say_stopping();
  EXPECT_EQ(systemd.next(), "STOPPING=1\nSTATUS=saying goodbye\n");
}

TEST(Supervisor, IsNotWaitedForWhereNobodyReads) {
  const Listener systemd;
  const Supervisor supervisor = supervised_by({"NOTIFY_SOCKET=" + systemd.path()});
  for (int notice = 0; notice < 100000; ++notice) supervisor.say_alive();
  EXPECT_EQ(systemd.next(), "WATCHDOG=1\n");
}

TEST(Supervisor, ThatIsNotThereIsToldNothing) {
  for (const char* variable : {"NOTIFY_SOCKET=", "NOTIFY_SOCKET=relative", "NOTIFY_SOCKET=/nobody/is/here",
                               "OTHER=/tmp", "NOTIFY_SOCKET=vsock:1:2"}) {
    const Supervisor supervisor = supervised_by({variable});
    supervisor.say_ready("");
    EXPECT_FALSE(supervisor.watchdog());
    EXPECT_THAT(supervisor.sockets(), testing::IsEmpty());
  }
  EXPECT_FALSE(supervised_by({"NOTIFY_SOCKET=/" + std::string(200, 'a')}).watchdog());
}

TEST(Supervisor, WantsSignsOfLifeOfTheProcessThatItNames) {
  EXPECT_EQ(supervised_by({"WATCHDOG_USEC=30000000"}).watchdog(), std::chrono::seconds(30));
  EXPECT_EQ(supervised_by({"WATCHDOG_USEC=30000000", "WATCHDOG_PID=" + own_process()}).watchdog(),
            std::chrono::seconds(30));
  EXPECT_FALSE(supervised_by({"WATCHDOG_USEC=30000000", "WATCHDOG_PID=1"}).watchdog());
  for (const char* wrong : {"WATCHDOG_USEC=0", "WATCHDOG_USEC=-1", "WATCHDOG_USEC=1s", "WATCHDOG_USEC="})
    EXPECT_FALSE(supervised_by({wrong}).watchdog()) << wrong;
}

TEST(Supervisor, GivesSocketsToTheProcessThatItNamesOnly) {
  EXPECT_THAT(supervised_by({"LISTEN_FDS=1", "LISTEN_PID=1"}).sockets(), testing::IsEmpty());
  EXPECT_THAT(supervised_by({"LISTEN_FDS=1"}).sockets(), testing::IsEmpty());
  const bool is_three_open = ::fcntl(3, F_GETFD) >= 0;
  if (!is_three_open) {
    ASSERT_EQ(::dup2(STDERR_FILENO, 3), 3);
  }
  const Supervisor supervisor = supervised_by({"LISTEN_FDS=1", "LISTEN_PID=" + own_process()});
  EXPECT_THAT(supervisor.sockets(), testing::ElementsAre(3));
  EXPECT_NE(::fcntl(3, F_GETFD) & FD_CLOEXEC, 0) << "its children do not inherit it";
  if (!is_three_open) ::close(3);
}

TEST(Supervisor, GivesNoMoreSocketsThanTheLimit) {
  const Supervisor supervisor = supervised_by({"LISTEN_FDS=100000", "LISTEN_PID=" + own_process()});
  EXPECT_LE(supervisor.sockets().size(), static_cast<std::size_t>(max_given_sockets));
}

/// A field of an entry in the journal's protocol: its name, the length in eight octets, and the value.
std::string field(std::string_view name, std::string_view value) {
  std::string text(name);
  text += '\n';
  text += static_cast<char>(value.size());
  text.append(7, '\0').append(value) += '\n';
  return text;
}

TEST(JournalWriter, WritesAnEntryWithItsLevelAndFields) {
  const Listener journal;
  const auto writer = JournalWriter::open(journal.path());
  ASSERT_TRUE(writer);
  EXPECT_TRUE(writer->write(base::LogLevel::warning, "peer a floods", {.peer = "a", .code = "c"}));
  EXPECT_EQ(journal.next(), "SYSLOG_IDENTIFIER=gemingad\nPRIORITY=4\n" + field("MESSAGE", "peer a floods") +
                                field("GEMINGA_PEER", "a") + field("GEMINGA_CODE", "c"));
}

TEST(JournalWriter, LetsNoValueForgeAField) {
  const Listener journal;
  const auto writer = JournalWriter::open(journal.path());
  ASSERT_TRUE(writer);
  ASSERT_TRUE(writer->write(base::LogLevel::info, "x", {.peer = "a\nPRIORITY=0\n"}));
  EXPECT_THAT(journal.next(), testing::EndsWith(field("GEMINGA_PEER", "a\nPRIORITY=0\n")));
}

TEST(JournalWriter, DropsAnEntryForWhichThereIsNoRoom) {
  const Listener journal;
  const auto writer = JournalWriter::open(journal.path());
  ASSERT_TRUE(writer);
  int written = 0;
  while (written < 100000 && writer->write(base::LogLevel::info, "line", {})) ++written;
  EXPECT_LT(written, 100000);
  EXPECT_FALSE(journal.next().empty());
  EXPECT_TRUE(writer->write(base::LogLevel::info, "there is room again", {}));
  EXPECT_FALSE(JournalWriter::open("/nobody/is/here"));
}

TEST(JournalStream, IsTheOneWhoseDeviceAndInodeTheVariableNames) {
  struct stat status{};
  ASSERT_EQ(::fstat(STDERR_FILENO, &status), 0);
  const std::string variable = std::to_string(status.st_dev) + ':' + std::to_string(status.st_ino);
  EXPECT_TRUE(is_journal_stream(STDERR_FILENO, variable));
  EXPECT_FALSE(is_journal_stream(STDERR_FILENO, variable + "0"));
  for (const char* wrong : {"", ":", "1", "1:", ":1", "a:b", "1:2:3"})
    EXPECT_FALSE(is_journal_stream(STDERR_FILENO, wrong));
}

TEST(Log, GoesToTheJournalWhereStandardErrorIsItsStream) {
  const Listener journal;
  struct stat status{};
  ASSERT_EQ(::fstat(STDERR_FILENO, &status), 0);
  ::setenv("JOURNAL_STREAM", (std::to_string(status.st_dev) + ':' + std::to_string(status.st_ino)).c_str(), 1);
  Log log(base::LogLevel::info, LogFormat::text, journal.path());
  ::unsetenv("JOURNAL_STREAM");
  log.write(base::LogLevel::debug, "less severe than the level");
  log.write(base::LogLevel::error, "clash", {.participant = "00000001", .code = "clash"});
  EXPECT_THAT(journal.next(),
              testing::AllOf(testing::HasSubstr("PRIORITY=3"), testing::HasSubstr("GEMINGA_PARTICIPANT")));
  EXPECT_EQ(journal.next(), "");
}

}  // namespace
}  // namespace geminga::daemon
