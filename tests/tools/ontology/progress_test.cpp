#include "ontology/loading/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>

namespace geminga::ontology {
namespace {

/// A terminal of the test, and what is written to it.
class Terminal {
 public:
  Terminal() : controller_(posix_openpt(O_RDWR | O_NOCTTY)) {
    if (controller_ < 0 || grantpt(controller_) != 0 || unlockpt(controller_) != 0) return;
    const char* const name = ptsname(controller_);
    if (name != nullptr) terminal_ = open(name, O_RDWR | O_NOCTTY);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal() {
    close(terminal_);
    close(controller_);
  }

  [[nodiscard]] int number() const { return terminal_; }
  /// Reads until these words have been written.
  std::string read_until(const std::string& words) {
    while (read_.find(words) == std::string::npos) {
      std::array<char, 256> piece{};
      const ssize_t count = read(controller_, piece.data(), piece.size());
      if (count <= 0) break;
      read_.append(piece.data(), static_cast<std::size_t>(count));
    }
    return read_;
  }

 private:
  int controller_;
  int terminal_ = -1;
  std::string read_;
};

TEST(Progress, IsSeenOnATerminalAndRemovedAtTheEnd) {
  Terminal terminal;
  if (terminal.number() < 0) GTEST_SKIP() << "no terminal can be made here";
  {
    Progress progress(true, terminal.number(), Progress::Clock::duration::zero());
    progress.show("classifying", 0.25);
    EXPECT_NE(terminal.read_until("classifying 25%, ").find("\rclassifying 25%, "), std::string::npos);
    progress.show("deciding");
    EXPECT_NE(terminal.read_until("\rdeciding, ").find("\rdeciding, "), std::string::npos);
  }
  const std::string blanks = "\r             \r";  // as wide as "deciding, 0 s"
  EXPECT_NE(terminal.read_until(blanks).find(blanks), std::string::npos);
}

TEST(Progress, AnOverlongPhaseStaysOnOneLine) {
  Terminal terminal;
  if (terminal.number() < 0) GTEST_SKIP() << "no terminal can be made here";
  Progress progress(true, terminal.number(), Progress::Clock::duration::zero());
  progress.show(std::string(500, 'x'), 1.0);
  const std::string all = terminal.read_until(" s");
  EXPECT_LT(all.size(), 80U);
}

TEST(Progress, IsNotSeenBeforeItsTime) {
  Terminal terminal;
  if (terminal.number() < 0) GTEST_SKIP() << "no terminal can be made here";
  {
    Progress progress(true, terminal.number(), std::chrono::hours(1));
    progress.show("classifying");
    progress.clear();
  }
  ASSERT_EQ(write(terminal.number(), "end", 3), 3);
  EXPECT_EQ(terminal.read_until("end"), "end");
}

}  // namespace
}  // namespace geminga::ontology
