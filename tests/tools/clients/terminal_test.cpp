// geminga-query on a terminal: colour, and tables that fit.
#include "shell/terminal.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <sstream>

#include "tools/clients/bench.hpp"

namespace geminga::tools {
namespace {

using testing::HasSubstr;
using testing::Le;
using testing::Not;

/// One service whose row is far wider than 80 columns.
class OnATerminal : public testing::Test {
 protected:
  OnATerminal() {
    peer_.say("0 sys hello name=vision-of-the-left-eye");
    peer_.say(
        "1 pub create mode=otm/stream concept=soccer:SharedBallInfo representation=soccer:CartesianFieldFrame "
        "port=5000 "
        "priority=3 rate=30 lens=\"wide angle\" frame=Ölstand");
    EXPECT_TRUE(peer_.line_with({"0 msg hello"}));
    EXPECT_THAT(peer_.lines_until_pong(), testing::IsEmpty());
  }

  /// The output of geminga-query on a terminal of so many columns; 0: the terminal does not say.
  std::string shown(std::vector<std::string> words, unsigned short columns,
                    std::map<std::string, std::string> environment = {}) {
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    EXPECT_EQ(::grantpt(terminal), 0);
    EXPECT_EQ(::unlockpt(terminal), 0);
    const std::string name = ::ptsname(terminal);
    const int keeps_open = ::open(name.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    winsize size{};
    size.ws_col = columns;
    EXPECT_EQ(::ioctl(keeps_open, TIOCSWINSZ, &size), 0);
    words.insert(words.begin(), system::program("geminga-query"));
    auto start = bench_.lab().on(0, std::move(words));
    environment.insert({{"GEMINGA_CONNECT", "127.0.0.1:" + std::to_string(bench_.lab().gcnp_port(0))},
                        {"TERM", "xterm"},
                        {"NO_COLOR", "1"},
                        {"COLUMNS", ""},
                        {"LC_ALL", "C.UTF-8"}});
    start.environment = std::move(environment);
    start.before = [inner = start.before, &name] {
      if (inner) inner();
      ::dup2(::open(name.c_str(), O_RDWR | O_NOCTTY), STDOUT_FILENO);
    };
    EXPECT_EQ(system::run(start).status, 0);
    ::close(keeps_open);  // so that reading ends behind the output
    std::array<char, 8192> written{};
    std::string text;
    for (ssize_t count = 0; (count = ::read(terminal, written.data(), written.size())) > 0;) {
      text.append(written.data(), static_cast<std::size_t>(count));
    }
    ::close(terminal);
    std::erase(text, '\r');
    return text;
  }

  static void expect_fits(const std::string& text, std::size_t columns) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_THAT(shell::width(line), Le(columns)) << text;
  }

  Bench bench_;
  Talk peer_ = bench_.talk();
};

TEST_F(OnATerminal, TablesFitTheirTerminal) {
  // The sentences around the tables of `ontology` do not fit the width.
  const std::vector<std::string> commands{"services", "match", "participants", "status"};
  for (const auto& command : commands) {
    for (const unsigned short columns : std::array<unsigned short, 6>{60, 79, 80, 81, 120, 200})
      expect_fits(shown({command}, columns), columns);
  }
}

TEST_F(OnATerminal, HasEightyColumnsUnlessItSaysOtherwise) {
  EXPECT_EQ(shown({"services"}, 0), shown({"services"}, 80));
  EXPECT_EQ(shown({"services"}, 80, {{"COLUMNS", "60"}}), shown({"services"}, 60));
  for (const char* nonsense : {"0", "-1", "wide", "10001", "99999999999999999999"}) {
    EXPECT_EQ(shown({"services"}, 80, {{"COLUMNS", nonsense}}), shown({"services"}, 80)) << nonsense;
  }
}

TEST_F(OnATerminal, ShowsTheWholeIdentityAndNamesTheColumnsThatItLeavesOut) {
  const std::string text = shown({"services"}, 80);
  EXPECT_THAT(text, HasSubstr("soccer:SharedBallInfo"));
  EXPECT_THAT(text, HasSubstr("soccer:CartesianFieldFrame"));
  EXPECT_THAT(text, HasSubstr("Not shown here: AGE"));
  EXPECT_THAT(text, Not(HasSubstr("…")));
  EXPECT_THAT(shown({"services"}, 300), Not(HasSubstr("Not shown here")));
}

TEST_F(OnATerminal, UsesColourUnlessToldNotTo) {
  EXPECT_THAT(shown({"services"}, 80, {{"NO_COLOR", ""}}), HasSubstr("\x1b[1mPROVIDER"));
  EXPECT_THAT(shown({"services"}, 80, {{"NO_COLOR", "1"}}), Not(HasSubstr("\x1b[")));
  EXPECT_THAT(shown({"services"}, 80, {{"NO_COLOR", ""}, {"TERM", "dumb"}}), Not(HasSubstr("\x1b[")));
  EXPECT_THAT(bench_.query({"services"}).out, Not(HasSubstr("\x1b["))) << "no terminal";
}

TEST_F(OnATerminal, WritesAsciiWhereTheLocaleHasNoUtf8) {
  EXPECT_THAT(shown({"services"}, 300), HasSubstr("frame=Ölstand"));
  EXPECT_THAT(shown({"services"}, 300, {{"LC_ALL", "C"}}), HasSubstr("frame=?lstand"));
  EXPECT_THAT(bench_.run("geminga-query", {"services"}).out, HasSubstr("frame=Ölstand")) << "no terminal";
}

}  // namespace
}  // namespace geminga::tools
