#include "daemon/log/log.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/json/parse.hpp>
#include <csignal>

namespace geminga::daemon {
namespace {

using base::LogLevel;
using testing::HasSubstr;
using testing::Not;

TEST(Log, WritesOneLineOfText) {
  testing::internal::CaptureStderr();
  Log log(LogLevel::info, LogFormat::text);
  log.write(LogLevel::warning, "robot2\nhas two lines {} %v");
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, testing::EndsWith(" warning robot2?has two lines {} %v\n"));
}

TEST(Log, WritesOneJsonObjectALine) {
  testing::internal::CaptureStderr();
  Log log(LogLevel::info, LogFormat::json);
  const std::string line = "a \"quoted\" \\ name, \xc3\xa4 and \xff, {} %v";
  log.write(LogLevel::error, line);
  const std::string said = testing::internal::GetCapturedStderr();
  const auto object = boost::json::parse(said).as_object();
  EXPECT_EQ(object.at("level"), "error");
  EXPECT_EQ(object.at("text"), "a \"quoted\" \\ name, \xc3\xa4 and \xef\xbf\xbd, {} %v");
  EXPECT_THAT(std::string(object.at("time").as_string()), testing::MatchesRegex(".*T.*[+-].*"));
}

TEST(Log, DropsWhatIsLessSevereThanItsLevel) {
  testing::internal::CaptureStderr();
  Log log(LogLevel::warning, LogFormat::text);
  log.write(LogLevel::info, "not this");
  log.write(LogLevel::warning, "but this");
  log.set(LogLevel::debug, LogFormat::text);
  log.write(LogLevel::debug, "and now this");
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, Not(HasSubstr("not this")));
  EXPECT_THAT(said, HasSubstr("but this"));
  EXPECT_THAT(said, HasSubstr("and now this"));
}

/// Makes this descriptor standard error for its life.
class AsStandardError {
 public:
  explicit AsStandardError(int descriptor) : before_(::dup(STDERR_FILENO)) { ::dup2(descriptor, STDERR_FILENO); }
  ~AsStandardError() {
    ::dup2(before_, STDERR_FILENO);
    ::close(before_);
  }
  AsStandardError(const AsStandardError&) = delete;
  AsStandardError& operator=(const AsStandardError&) = delete;

 private:
  int before_;
};

/// Everything that can be read from it at once.
std::string read_all(int descriptor) {
  ::fcntl(descriptor, F_SETFL, O_NONBLOCK);
  std::string text;
  std::array<char, 4096> chunk;
  for (ssize_t size = 0; (size = ::read(descriptor, chunk.data(), chunk.size())) > 0;)
    text.append(chunk.data(), static_cast<std::size_t>(size));
  return text;
}

constexpr int many = 10'000;  // far more than any pipe or socket holds

/// Logs more than the pipe holds, reads all, and logs on.
void stall(std::array<int, 2> reader_and_writer) {
  const auto [reader, writer] = reader_and_writer;
  const AsStandardError standard_error(writer);
  Log log(LogLevel::info, LogFormat::text);
  for (int number = 0; number < many; ++number) log.write(LogLevel::info, "line " + std::to_string(number));
  const std::uint64_t dropped = log.dropped();
  EXPECT_GT(dropped, 0U);
  EXPECT_LT(dropped, many);
  std::string said = read_all(reader);
  const auto written = std::ranges::count(said, '\n') + (said.ends_with('\n') ? 0 : 1);
  EXPECT_EQ(static_cast<std::uint64_t>(written) + dropped, many) << "a line is written whole or dropped";
  log.catch_up();
  log.write(LogLevel::info, "the next line");
  said += read_all(reader);
  EXPECT_THAT(said, HasSubstr("warning " + std::to_string(dropped) + " lines of this log dropped"));
  EXPECT_THAT(said, testing::EndsWith("the next line\n"));
  log.catch_up();
  EXPECT_EQ(read_all(reader), "") << "a gap is said once";
  EXPECT_EQ(log.dropped(), dropped);
}

TEST(Log, DoesNotWaitForAPipeThatNobodyReads) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  stall(ends);
  EXPECT_EQ(::fcntl(ends[1], F_GETFL) & O_NONBLOCK, 0) << "the flags belong to whoever shares the pipe";
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(Log, FinishesALineThatWasBegunWithoutWaitingForTheNext) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  {
    const AsStandardError standard_error(ends[1]);
    Log log(LogLevel::info, LogFormat::text);
    const std::string line(4000, 'x');
    // With the time stamp each line is longer than the octets that a pipe takes whole or not at all.
    while (log.dropped() == 0) log.write(LogLevel::info, line + std::string(96, 'y'));
    std::string said = read_all(ends[0]);
    log.catch_up();
    said += read_all(ends[0]);
    EXPECT_THAT(said, testing::EndsWith("nobody was reading it\n"));
    EXPECT_EQ(std::ranges::count(said, 'x') % 4000, 0);
  }
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(Log, DoesNotWaitForASocketThatNobodyReads) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
  stall(ends);
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(Log, DoesNotWaitForATerminalThatNobodyReads) {
  const int reader = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (reader < 0 || ::grantpt(reader) != 0 || ::unlockpt(reader) != 0) GTEST_SKIP() << "no terminal can be made here";
  const int writer = ::open(::ptsname(reader), O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (writer < 0) GTEST_SKIP() << "no terminal can be opened here";
  termios settings{};
  ::tcgetattr(writer, &settings);
  ::cfmakeraw(&settings);
  ::tcsetattr(writer, TCSANOW, &settings);
  {
    const AsStandardError standard_error(writer);
    Log log(LogLevel::info, LogFormat::text);
    for (int number = 0; number < many; ++number) log.write(LogLevel::info, "line " + std::to_string(number));
    EXPECT_GT(log.dropped(), 0U);
  }
  ::close(writer);
  ::close(reader);
}

TEST(Log, CountsWhatAClosedPipeDoesNotTake) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  ::close(ends[0]);
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  {
    const AsStandardError standard_error(ends[1]);
    Log log(LogLevel::info, LogFormat::text);
    log.write(LogLevel::info, "to nobody");
    EXPECT_EQ(log.dropped(), 1U);
  }
  std::signal(SIGPIPE, before);
  ::close(ends[1]);
}

}  // namespace
}  // namespace geminga::daemon
