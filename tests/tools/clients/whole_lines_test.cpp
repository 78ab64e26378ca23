// The output of a program comes in whole lines, each in one system call.
#include "shell/whole_lines.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <ostream>
#include <string>
#include <vector>

namespace geminga::shell {
namespace {

/// A pipe that keeps the octets of one system call together.
class WholeLinesTest : public testing::Test {
 protected:
  WholeLinesTest() { EXPECT_EQ(::pipe2(ends_.data(), O_DIRECT | O_NONBLOCK), 0); }
  ~WholeLinesTest() override {
    for (const int end : ends_) ::close(end);
  }

  [[nodiscard]] int in() const { return ends_[1]; }
  /// The octets of each system call.
  std::vector<std::string> written() {
    std::vector<std::string> all;
    std::array<char, 8192> room{};
    for (ssize_t size = 0; (size = ::read(ends_[0], room.data(), room.size())) > 0;) {
      all.emplace_back(room.data(), static_cast<std::size_t>(size));
    }
    return all;
  }

 private:
  std::array<int, 2> ends_{};
};

using Strings = std::vector<std::string>;

TEST_F(WholeLinesTest, ALineIsWrittenAtItsEnd) {
  LineBuffer buffer(in(), false);
  std::ostream stream(&buffer);
  stream << "geminga-query" << ": " << 7;
  EXPECT_EQ(written(), Strings{});
  stream << " days" << '\n';
  EXPECT_EQ(written(), Strings{"geminga-query: 7 days\n"});
  stream << "one\ntwo\nthr";
  EXPECT_EQ(written(), Strings{"one\ntwo\n"});
  stream << "ee" << std::flush;
  EXPECT_EQ(written(), Strings{"three"});
}

TEST_F(WholeLinesTest, LinesThatMayWaitAreWrittenWhenTheyAreFlushed) {
  LineBuffer buffer(in(), true);
  std::ostream stream(&buffer);
  stream << "one\n" << "two" << '\n';
  EXPECT_EQ(written(), Strings{});
  stream << std::flush;
  EXPECT_EQ(written(), Strings{"one\ntwo\n"});
}

TEST_F(WholeLinesTest, LinesThatAreManyDoNotWait) {
  LineBuffer buffer(in(), true);
  std::ostream stream(&buffer);
  const std::string line(max_waiting_bytes / 2 - 2, 'x');
  stream << line << '\n' << line << '\n' << 'y';
  EXPECT_EQ(written(), Strings{}) << "one less than so many";
  stream << 'z';
  std::string all;
  for (const std::string& one : written()) all += one;
  EXPECT_EQ(all, line + '\n' + line + '\n') << "and what is no whole line waits";
  stream << std::flush;
  EXPECT_EQ(written(), Strings{"yz"});
}

TEST(WholeLines, FailWhereNobodyCanRead) {
  LineBuffer buffer(-1, true);
  std::ostream stream(&buffer);
  stream << "lost\n" << std::flush;
  EXPECT_FALSE(stream);
}

}  // namespace
}  // namespace geminga::shell
