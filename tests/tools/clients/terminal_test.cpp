// geminga-query on a terminal: colour, and tables that fit.
#include "shell/terminal.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/json/array.hpp>
#include <iterator>
#include <regex>
#include <set>
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
    status_ = system::run(start).status;
    EXPECT_LE(status_, 1);
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

  /// The words of a text, as wrapped() keeps them whole.
  static std::set<std::string> words_of(std::string text) {
    text = std::regex_replace(text, std::regex("[,;|]"), "$& ");
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
  }

  Bench bench_;
  Talk peer_ = bench_.talk();
  int status_ = -1;  ///< of the last program
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

/// Seven robots on one host, with 35 requests that nobody serves, for five reasons.
class UnmatchedOnATerminal : public OnATerminal {
 protected:
  UnmatchedOnATerminal() {
    for (int robot = 1; robot <= 7; ++robot) {
      Talk& module = modules_.emplace_back(bench_.talk());
      module.say("0 sys hello name=Behaviour-" + std::to_string(robot));
      module.say("1 sub create mode=otm/pubsub concept=soccer:SharedBallInfo");
      module.say("2 sub create mode=otm/stream concept=soccer:SharedBallInfo where=\"rate >= 50 and frame = map\"");
      module.say("3 sub create mode=otm/stream concept=soccer:RefereeBoxInfo match=exact scope=!host");
      module.say("4 sub create mode=oto text=camera-of-the-left-eye");
      module.say("5 sub create mode=otm/stream concept=soccer:SharedBallInfo representation=soccer:PolarFieldFrame");
      EXPECT_TRUE(module.line_with({"0 msg hello"}));
      EXPECT_THAT(module.lines_until_pong(), testing::IsEmpty());
    }
  }

  std::vector<Talk> modules_;
};

TEST_F(UnmatchedOnATerminal, SaysEachReasonOnceAndNamesEachRequest) {
  const auto requests = bench_.json({"requests", "--unmatched"});
  ASSERT_EQ(requests.as_array().size(), 35U);
  std::set<std::string> reasons;
  for (const auto& request : requests.as_array()) reasons.emplace(request.at("because").as_string().c_str());
  ASSERT_EQ(reasons.size(), 5U);
  for (const unsigned short columns : std::array<unsigned short, 4>{60, 80, 100, 200}) {
    const std::string text = shown({"requests", "--unmatched"}, columns);
    expect_fits(text, columns);
    EXPECT_THAT(std::ranges::count(text, '\n'), Le(columns < 80 ? 100 : 70)) << text;
    for (const auto& request : requests.as_array()) {
      EXPECT_THAT(text, HasSubstr(request.at("subscription").as_string().c_str())) << columns;
    }
    const std::string in_one_line = std::regex_replace(text, std::regex("\n"), " ");
    for (const std::string& reason : reasons) {
      const auto at = in_one_line.find(reason);
      EXPECT_NE(at, std::string::npos) << reason << '\n' << text;
      EXPECT_EQ(in_one_line.find(reason, at + 1), std::string::npos) << reason << '\n' << text;
    }
  }
}

TEST_F(UnmatchedOnATerminal, BreaksNoWord) {
  const std::string request = bench_.json({"requests", "--unmatched"}).at(0).at("subscription").as_string().c_str();
  const std::string service = bench_.json({"services"}).at(0).at("service").as_string().c_str();
  const std::vector<std::vector<std::string>> commands{
      {"participants"}, {"services"}, {"services", "--unused"}, {"requests"},     {"requests", "--unmatched"},
      {"match"},        {"status"},   {"why", request},         {"why", service}, {"why", request, service},
      {"security"}};
  const std::regex changing("[0-9.]+|s|min|MiB|[(]a|wider|terminal|or|--json|shows|all[)]|Not|shown|here:|[A-Z,]+");
  for (const auto& command : commands) {
    const auto whole = words_of(bench_.query(command).out);
    for (const unsigned short columns : std::array<unsigned short, 4>{60, 80, 100, 200}) {
      const std::string text = shown(command, columns);
      expect_fits(text, columns);
      for (const std::string& word : words_of(text)) {
        EXPECT_TRUE(whole.contains(word) || std::regex_match(word, changing)) << word << " in\n" << text;
      }
    }
  }
}

TEST_F(UnmatchedOnATerminal, NeverHidesTheWordsThatWhyNeeds) {
  const std::string service = bench_.json({"services"}).at(0).at("service").as_string().c_str();
  for (const unsigned short columns : std::array<unsigned short, 4>{40, 60, 80, 200}) {
    EXPECT_THAT(shown({"services"}, columns), HasSubstr(service));
    EXPECT_THAT(shown({"match"}, columns), HasSubstr(service));
    EXPECT_THAT(shown({"why", "--concept", "soccer:BallInfo"}, columns), HasSubstr(service));
  }
}

}  // namespace
}  // namespace geminga::tools
