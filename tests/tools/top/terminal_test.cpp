// geminga-query top on a terminal of its own, with a real daemon.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <boost/json/array.hpp>
#include <boost/json/object.hpp>
#include <csignal>

#include "tools/clients/bench.hpp"
#include "tools/top/emulated_terminal.hpp"

namespace geminga::tools {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A program that has a terminal for itself, as in a window.
class Window {
 public:
  Window(Bench& bench, std::vector<std::string> words, unsigned short rows = 24)
      : terminal_(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)), screen_(rows) {
    EXPECT_EQ(::grantpt(terminal_), 0);
    EXPECT_EQ(::unlockpt(terminal_), 0);
    const std::string name = ::ptsname(terminal_);
    other_end_ = ::open(name.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    resize(rows, 100);
    EXPECT_EQ(::tcgetattr(other_end_, &former_), 0);
    words.insert(words.begin(), system::program("geminga-query"));
    auto start = bench.lab().on(0, std::move(words));
    start.environment = {{"GEMINGA_CONNECT", "127.0.0.1:" + std::to_string(bench.lab().gcnp_port(0))},
                         {"TERM", "xterm"},
                         {"LC_ALL", "C.UTF-8"}};
    start.before = [inner = start.before, &name] {
      if (inner) inner();
      ::setsid();
      const int end = ::open(name.c_str(), O_RDWR);  // becomes the controlling terminal
      for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(end, descriptor);
    };
    program_ = std::make_unique<Process>(std::move(start));
  }
  ~Window() {
    ::close(terminal_);
    ::close(other_end_);
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  void press(std::string_view keys) const {
    EXPECT_EQ(::write(terminal_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }
  void resize(unsigned short rows, unsigned short columns) {
    const winsize size{.ws_row = rows, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    screen_.resize(rows);
    EXPECT_EQ(::ioctl(other_end_, TIOCSWINSZ, &size), 0);
  }
  /// Reads until the screen fulfils a condition. False: patience ended.
  template <typename Condition>
  bool wait_until(Condition condition) {
    const auto end = std::chrono::steady_clock::now() + system::patience;
    while (!condition(screen_)) {
      pollfd output{.fd = terminal_, .events = POLLIN, .revents = 0};
      if (std::chrono::steady_clock::now() > end) return false;
      if (::poll(&output, 1, 1000) <= 0) continue;
      std::array<char, 4096> chunk{};
      const ssize_t size = ::read(terminal_, chunk.data(), chunk.size());
      if (size <= 0) return false;
      screen_.take({chunk.data(), static_cast<std::size_t>(size)});
    }
    return true;
  }
  bool shows(const std::string& text) {
    return wait_until([&](const EmulatedTerminal& screen) { return screen.text().contains(text); });
  }
  /// Whether the terminal is as it was before the program.
  bool is_given_back() {
    const bool is_left =
        wait_until([](const EmulatedTerminal& screen) { return !screen.is_other_screen() && screen.has_cursor(); });
    termios present{};
    EXPECT_EQ(::tcgetattr(other_end_, &present), 0);
    return is_left && present.c_lflag == former_.c_lflag && present.c_iflag == former_.c_iflag;
  }

  Process& program() { return *program_; }
  const EmulatedTerminal& screen() const { return screen_; }

 private:
  int terminal_;
  int other_end_ = -1;
  termios former_{};
  EmulatedTerminal screen_;
  std::unique_ptr<Process> program_;
};

class Top : public testing::Test {
 protected:
  Top() {
    peer_.say("0 sys hello name=vision");
    peer_.say("1 pub create mode=oto text=lamp port=5000");
    peer_.say("2 sub create mode=oto text=camera");
    peer_.say("3 sub create mode=oto text=microphone");
    EXPECT_TRUE(peer_.line_with({"0 msg hello"}));
    EXPECT_THAT(peer_.lines_until_pong(), testing::IsEmpty());
  }
  Bench bench_;
  Talk peer_ = bench_.talk();
};

TEST_F(Top, ShowsTheTeamAndEndsAtQ) {
  Window window(bench_, {"top"});
  ASSERT_TRUE(window.shows("> vision@robot0  \"camera\"")) << window.screen().text();
  EXPECT_TRUE(window.screen().is_other_screen());
  EXPECT_FALSE(window.screen().has_cursor());
  EXPECT_THAT(window.screen().text(), HasSubstr("1 participants, 1 services, 2 requests, 2 unmatched"));
  EXPECT_THAT(window.screen().text(), HasSubstr("this host"));
  peer_.say("4 sub create mode=oto text=radar");
  EXPECT_TRUE(window.shows("radar")) << "it lives: " << window.screen().text();
  window.press("q");
  EXPECT_TRUE(window.is_given_back());
  EXPECT_EQ(window.program().wait(), 0);
  EXPECT_THAT(window.screen().unknown(), testing::IsEmpty());
}

TEST_F(Top, AsksWhyOfTheSelectedRequest) {
  Window window(bench_, {"top"});
  ASSERT_TRUE(window.shows("> vision@robot0  \"camera\"")) << window.screen().text();
  window.press("\x1b[B");
  ASSERT_TRUE(window.shows("> vision@robot0  \"microphone\"")) << window.screen().text();
  window.press("\r");
  ASSERT_TRUE(window.shows("vision@robot0 asks for \"microphone\"")) << window.screen().text();
  EXPECT_THAT(window.screen().text(), HasSubstr("nobody offers text=microphone"));
  window.press(" ");
  EXPECT_TRUE(window.shows("UNMATCHED"));
  window.press("q");
  EXPECT_EQ(window.program().wait(), 0);
}

TEST_F(Top, FitsAnotherSizeAtOnce) {
  Window window(bench_, {"top", "--interval", "3600"});
  ASSERT_TRUE(window.shows("up/down select, enter why")) << window.screen().text();
  window.resize(10, 40);
  EXPECT_TRUE(window.shows("q quit   sort: n name, h heard, l loss…")) << window.screen().text();
  EXPECT_THAT(window.screen().unknown(), testing::IsEmpty());
  window.press("q");
  EXPECT_EQ(window.program().wait(), 0);
}

TEST_F(Top, GoesOnWhenTheDaemonIsThereAgain) {
  Window window(bench_, {"top", "--interval", "0.1"});
  ASSERT_TRUE(window.shows("camera")) << window.screen().text();
  bench_.stop_daemon();
  ASSERT_TRUE(window.shows("no daemon at ")) << window.screen().text();
  EXPECT_THAT(window.screen().text(), HasSubstr("camera")) << "the last table stays";
  bench_.start_daemon();
  EXPECT_TRUE(window.wait_until([](const EmulatedTerminal& screen) {
    return screen.text().contains("0 unmatched") && !screen.text().contains("no daemon");
  })) << window.screen().text();
  window.press("q");
  EXPECT_EQ(window.program().wait(), 0);
}

TEST_F(Top, GivesTheTerminalBackAtEverySignal) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGABRT, SIGSEGV}) {
    Window window(bench_, {"top"});
    ASSERT_TRUE(window.shows("camera")) << window.screen().text();
    window.program().signal(signal);
    EXPECT_TRUE(window.is_given_back()) << signal;
    const bool is_ordered = signal == SIGINT || signal == SIGTERM || signal == SIGHUP;
    EXPECT_EQ(window.program().wait(), is_ordered ? 0 : 128 + signal);
  }
}

TEST_F(Top, GivesTheTerminalBackToTheShellAtControlZAndTakesItAgain) {
  Window window(bench_, {"top", "--interval", "3600"});
  ASSERT_TRUE(window.shows("camera")) << window.screen().text();
  window.program().signal(SIGTSTP);
  EXPECT_TRUE(window.is_given_back());
  siginfo_t stopped{};
  ASSERT_EQ(::waitid(P_PID, static_cast<id_t>(window.program().pid()), &stopped, WSTOPPED | WNOWAIT), 0);
  window.program().signal(SIGCONT);
  EXPECT_TRUE(window.wait_until(
      [](const EmulatedTerminal& screen) { return screen.is_other_screen() && screen.text().contains("camera"); }));
  window.press("\x03");  // Ctrl-C
  EXPECT_TRUE(window.is_given_back());
  EXPECT_EQ(window.program().wait(), 0);
}

TEST_F(Top, PrintsOneTableWithoutATerminal) {
  const Outcome table = bench_.query({"top"});
  EXPECT_EQ(table.status, 0);
  EXPECT_THAT(table.out, HasSubstr("camera"));
  EXPECT_THAT(table.out, Not(HasSubstr("\x1b")));
  const auto document = parsed(bench_.query({"--json", "top"}).out).as_object();
  EXPECT_EQ(document.at("participants").as_array().size(), 1U);
  EXPECT_EQ(document.at("unmatched").as_array().size(), 2U);
  EXPECT_EQ(document.at("status").at("name"), "robot0");
  EXPECT_EQ(bench_.query({"top", "--sort", "size"}).status, 2);
  EXPECT_EQ(bench_.query({"--watch", "top"}).status, 2);
  EXPECT_EQ(bench_.query({"--connect", nobody(), "top"}).status, 3);
}

}  // namespace
}  // namespace geminga::tools
