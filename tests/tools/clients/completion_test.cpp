// The completions of bash, zsh and fish ask the living daemon, and take what robots say for nothing but text.
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>

#include "tools/clients/query.hpp"

namespace geminga::tools {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + '\'';
}

/// A shell at a terminal, with a user who types.
class TypedShell {
 public:
  TypedShell(const system::Lab& lab, std::vector<std::string> words, std::map<std::string, std::string> environment) {
    terminal_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    EXPECT_EQ(::grantpt(terminal_), 0);
    EXPECT_EQ(::unlockpt(terminal_), 0);
    const winsize size{.ws_row = 50, .ws_col = 200, .ws_xpixel = 0, .ws_ypixel = 0};
    EXPECT_EQ(::ioctl(terminal_, TIOCSWINSZ, &size), 0);
    auto start = lab.on(0, std::move(words));
    start.environment = std::move(environment);
    start.before = [inner = start.before, name = std::string(::ptsname(terminal_))] {
      if (inner) inner();
      ::setsid();
      const int side = ::open(name.c_str(), O_RDWR);  // the terminal of the new session
      for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(side, descriptor);
    };
    shell_ = std::make_unique<Process>(std::move(start));
  }
  ~TypedShell() {
    shell_.reset();
    ::close(terminal_);
  }
  TypedShell(const TypedShell&) = delete;
  TypedShell& operator=(const TypedShell&) = delete;

  void type(const std::string& keys) {
    EXPECT_EQ(::write(terminal_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }
  /// Waits until the text is shown, behind what was waited for before.
  [[nodiscard]] bool shows(const std::string& text) {
    const auto until = std::chrono::steady_clock::now() + system::patience;
    while (!shown_.contains(text)) {
      pollfd waiting{.fd = terminal_, .events = POLLIN, .revents = 0};
      const auto left = until - std::chrono::steady_clock::now();
      if (::poll(&waiting, 1, static_cast<int>(std::max<std::int64_t>(left / std::chrono::milliseconds(1), 0))) <= 0) {
        ADD_FAILURE() << "not shown: " << text << "\nbut: " << shown_;
        return false;
      }
      std::array<char, 4096> chunk{};
      const ssize_t size = ::read(terminal_, chunk.data(), chunk.size());
      if (size <= 0) return false;
      shown_.append(chunk.data(), static_cast<std::size_t>(size));
    }
    shown_.erase(0, shown_.find(text) + text.size());
    return true;
  }

 private:
  int terminal_ = -1;
  std::unique_ptr<Process> shell_;
  std::string shown_;
};

class Completion : public Query {
 protected:
  Completion() {
    std::string path = fs::temp_directory_path() / "geminga-completion-XXXXXX";
    if (::mkdtemp(path.data()) != nullptr) folder_ = path;
    for (const char* form : {"bash", "fish", "zsh"}) {
      // A user at a key waits for half a second; a test on a busy machine for as long as it takes.
      std::string script = shipped(form);
      const auto at = script.find(half_a_second);
      if (at == std::string::npos) {
        ADD_FAILURE() << script;
      } else {
        script.replace(at, half_a_second.size(), "--timeout 100");
      }
      std::ofstream(folder_ / (std::string(form) == "zsh" ? "_geminga-query" : form)) << script;
    }
  }
  ~Completion() override { fs::remove_all(folder_); }

  static constexpr std::string_view half_a_second = "--timeout 0.5";
  /// The completion script as it is installed.
  [[nodiscard]] std::string shipped(const std::string& form) const { return bench_.query({"--describe", form}).out; }

  [[nodiscard]] std::map<std::string, std::string> environment(const std::string& connect = {}) {
    const char* path = std::getenv("PATH");
    return {{"PATH", GEMINGA_BINARY_DIR "/bin:" + std::string(path == nullptr ? "/usr/bin:/bin" : path)},
            {"GEMINGA_CONNECT", connect.empty() ? address() : connect},
            {"LC_ALL", "C.UTF-8"},
            {"HOME", folder_}};
  }
  [[nodiscard]] std::string address() { return "127.0.0.1:" + std::to_string(bench_.lab().gcnp_port(0)); }

  /// The words that bash offers at the end of the line, which is given as bash splits it. `type` is COMP_TYPE: 9 for
  /// the first key, 63 for the list.
  std::vector<std::string> offered(const std::vector<std::string>& parts, const std::string& line, int type = 9,
                                   const std::string& connect = {}) {
    std::string script = "cd " + quoted(folder_) + "; . " + quoted(folder_ / "bash") + "\nCOMP_WORDS=(";
    for (const std::string& part : parts) script += ' ' + quoted(part);
    script += ")\nCOMP_LINE=" + quoted(line) + " COMP_TYPE=" + std::to_string(type) +
              " COMP_CWORD=" + std::to_string(parts.size() - 1) +
              "\n_geminga_query\nfor word in \"${COMPREPLY[@]}\"; do printf '%s\\n' \"$word\"; done\n";
    auto start = bench_.lab().on(0, {"/bin/bash", "-euc", script});
    start.environment = environment(connect);
    const auto ran = system::run(std::move(start));
    EXPECT_EQ(ran.status, 0) << ran.said;
    std::vector<std::string> words;
    std::istringstream lines(ran.said);
    for (std::string word; std::getline(lines, word);) words.push_back(word);
    return words;
  }

  fs::path folder_;
};

TEST_F(Completion, OffersTheRequestsAndServicesOfTheDaemon) {
  const std::string request = word({"requests", "mode=oto"}, "subscription");
  const std::string ball = word({"services", "mode=otm/stream"}, "service");
  EXPECT_THAT(offered({"geminga-query", "why", ""}, "geminga-query why "), testing::SizeIs(4));
  EXPECT_THAT(offered({"geminga-query", "why", ""}, "geminga-query why "), Contains(request));
  EXPECT_THAT(offered({"geminga-query", "why", request.substr(0, 5)}, "geminga-query why " + request.substr(0, 5)),
              Contains(ball));
  EXPECT_THAT(offered({"geminga-query", "why", request, ""}, "geminga-query why " + request + ' '),
              testing::AllOf(testing::SizeIs(2), Contains(ball), Not(Contains(request))));
  EXPECT_THAT(offered({"geminga-query", "--json", "why", "--service", ""}, "geminga-query --json why --service "),
              testing::AllOf(testing::SizeIs(2), Contains(ball)));
  EXPECT_THAT(offered({"geminga-query", "why", "--service", "=", ""}, "geminga-query why --service="), Contains(ball));
  EXPECT_THAT(offered({"geminga-query", "why", "--service", "=", ball.substr(0, 3)},
                      "geminga-query why --service=" + ball.substr(0, 3)),
              Contains(ball));
}

TEST_F(Completion, SaysWhatEachIsWhereBashListsThem) {
  const std::string request = word({"requests", "mode=oto"}, "subscription");
  const auto listed = offered({"geminga-query", "why", ""}, "geminga-query why ", 63);
  EXPECT_THAT(listed, Contains(request + "  (vision@robot0 asks for 77, nobody serves it)"));
  EXPECT_THAT(offered({"geminga-query", "why", request}, "geminga-query why " + request, 63), ElementsAre(request))
      << "a word alone may be inserted";
}

TEST_F(Completion, OffersConceptsWithTheirPrefixBehindTheColonThatBashSplitsAt) {
  EXPECT_THAT(
      offered({"geminga-query", "match", "soccer", ":", "SharedBallI"}, "geminga-query match soccer:SharedBallI"),
      ElementsAre("SharedBallInfo"));
  EXPECT_THAT(offered({"geminga-query", "match", "soccer", ":"}, "geminga-query match soccer:"),
              testing::IsSupersetOf({"SharedBallInfo", "RefereeBoxInfo"}))
      << "what is offered, and what only the ontology knows";
  EXPECT_THAT(offered({"geminga-query", "match", "soccer:Referee"}, "geminga-query match soccer:Referee"),
              Contains("soccer:RefereeBoxInfo"))
      << "where the user has told bash not to split";
  EXPECT_THAT(
      offered({"geminga-query", "match", "'soccer:RefereeBoxInfo"}, "geminga-query match 'soccer:RefereeBoxInfo"),
      Contains("soccer:RefereeBoxInfo"));
  EXPECT_THAT(offered({"geminga-query", "explain", "soccer", ":", "BallInfo", "soccer", ":", "RefereeBoxI"},
                      "geminga-query explain soccer:BallInfo soccer:RefereeBoxI"),
              ElementsAre("RefereeBoxInfo", "RefereeBoxInfoBody"));
  EXPECT_THAT(offered({"geminga-query", "match", "--provider", "rob"}, "geminga-query match --provider rob"),
              ElementsAre("robot0", "robot0/vision"));
  EXPECT_THAT(offered({"geminga-query", "match", "--text", "l"}, "geminga-query match --text l"),
              ElementsAre("lonely"));
}

TEST_F(Completion, FindsTheDaemonThatTheLineNames) {
  const std::string port = std::to_string(bench_.lab().gcnp_port(0));
  EXPECT_THAT(offered({"geminga-query", "--connect", "127.0.0.1", ":", port, "match", "--text", ""},
                      "geminga-query --connect 127.0.0.1:" + port + " match --text ", 9, nobody()),
              ElementsAre("lonely"));
  EXPECT_THAT(offered({"geminga-query", "match", "--connect", "=", "127.0.0.1", ":", port, "--text", ""},
                      "geminga-query match --connect=127.0.0.1:" + port + " --text ", 9, nobody()),
              ElementsAre("lonely"));
}

TEST_F(Completion, IsSilentWithoutADaemonAndEndsWithADeafOne) {
  EXPECT_THAT(offered({"geminga-query", "why", ""}, "geminga-query why ", 9, nobody()), IsEmpty());
  EXPECT_THAT(offered({"geminga-query", "why", ""}, "geminga-query why ", 9, "no address at all"), IsEmpty());
  std::ofstream(folder_ / "bash") << shipped("bash");
  bench_.lab().daemon(0).signal(SIGSTOP);  // it accepts connections, and says nothing
  EXPECT_THAT(offered({"geminga-query", "why", ""}, "geminga-query why "), IsEmpty());
  bench_.lab().daemon(0).signal(SIGCONT);
}

TEST_F(Completion, TakesWhatRobotsSayForTextAndNothingElse) {
  const fs::path trap = folder_ / "trap";
  const std::string touch = "touch " + trap.string();
  const std::vector<std::string> texts{"$(" + touch + ")",
                                       "`" + touch + "`",
                                       "; " + touch + " #",
                                       "a'; " + touch + "; '",
                                       "a\"$(" + touch + ")\"",
                                       "x\\$(" + touch + ")",
                                       "[$(" + touch + ")]",
                                       "{a,b}* ~ !! && | > <",
                                       "#",
                                       "-e"};
  Talk robot = bench_.talk();
  robot.say("0 sys hello name=\"n$(touch trap)\"");
  for (std::size_t i = 0; i < texts.size(); ++i) {
    std::string text;
    for (const char c : texts[i]) text += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
    robot.say(std::to_string(i + 1) + " pub create mode=oto port=5000 text=\"" + text + '"');
  }
  EXPECT_TRUE(robot.line_with({"0 msg hello"}));
  EXPECT_THAT(robot.lines_until_pong(), IsEmpty());
  const auto words = offered({"geminga-query", "match", "--text", ""}, "geminga-query match --text ");
  EXPECT_THAT(words, testing::SizeIs(texts.size() + 1));
  std::vector<std::string> meant;
  for (const std::string& word : words) {
    meant.push_back(
        system::run({.words = {"/bin/bash", "-c", "printf %s " + word}, .environment = {}, .before = {}}).said);
  }
  EXPECT_THAT(meant, testing::IsSupersetOf(texts)) << "bash understands each word as the text that it is";
  EXPECT_THAT(offered({"geminga-query", "match", "--text", "\""}, "geminga-query match --text \""),
              Not(Contains(testing::AnyOf(HasSubstr("$"), HasSubstr("`"), HasSubstr("'")))));
  EXPECT_THAT(offered({"geminga-query", "why", ""}, "geminga-query why ", 63),
              Contains(HasSubstr("n$(touch trap)@robot0 offers")));
  EXPECT_FALSE(fs::exists(trap));
}

TEST_F(Completion, WorksForWhoTypesInBash) {
  Talk robot = bench_.talk();
  const fs::path trap = folder_ / "trap";
  robot.say("1 pub create mode=oto port=5000 text=\"$(touch " + trap.string() + ")\"");
  EXPECT_THAT(robot.lines_until_pong(), IsEmpty());
  auto settings = environment();
  settings.insert({{"TERM", "dumb"}, {"PS1", "ready$ "}, {"INPUTRC", "/dev/null"}});
  TypedShell bash(bench_.lab(), {"/bin/bash", "--norc", "--noprofile", "-i"}, settings);
  ASSERT_TRUE(bash.shows("ready$ "));
  bash.type(". " + (folder_ / "bash").string() + "; echo com''plete\n");
  ASSERT_TRUE(bash.shows("complete"));
  bash.type("geminga-query match soccer:SharedBallI\t");
  EXPECT_TRUE(bash.shows("soccer:SharedBallInfo "));
  bash.type("\n");
  EXPECT_TRUE(bash.shows("5000"));
  EXPECT_TRUE(bash.shows("ready$ "));
  bash.type("geminga-query why \t\t\t");
  EXPECT_TRUE(bash.shows("(vision@robot0 asks for 77, nobody serves it)"));
  bash.type("\x15geminga-query match --text \\$\t");
  EXPECT_TRUE(bash.shows("\\)"));
  bash.type("\necho en''d\n");
  EXPECT_TRUE(bash.shows("end"));
  EXPECT_FALSE(fs::exists(trap));
}

TEST_F(Completion, WorksInFish) {
  if (!fs::exists("/usr/bin/fish")) GTEST_SKIP() << "fish is not installed";
  Talk robot = bench_.talk();
  const fs::path trap = folder_ / "trap";
  robot.say("1 pub create mode=oto port=5000 text=\"(touch " + trap.string() + ")\"");
  EXPECT_THAT(robot.lines_until_pong(), IsEmpty());
  const auto offered = [&](const std::string& line) {
    auto start = bench_.lab().on(0, {"/usr/bin/fish", "--no-config", "-c", "source $argv[1]; complete -C $argv[2]",
                                     (folder_ / "fish").string(), line});
    start.environment = environment(nobody());
    return system::run(start).said;
  };
  const std::string query = "geminga-query --connect " + address() + ' ';
  EXPECT_THAT(offered(query + "match soccer:SharedBallI"), HasSubstr("soccer:SharedBallInfo"));
  EXPECT_THAT(offered(query + "why "), HasSubstr("vision@robot0 asks for 77, nobody serves it"));
  EXPECT_THAT(offered(query + "match --text "), HasSubstr("touch"));
  EXPECT_THAT(offered(query + "partic"), HasSubstr("participants\t"));
  EXPECT_THAT(offered(query + "doctor --repo"), HasSubstr("--report\t"));
  EXPECT_FALSE(fs::exists(trap));
}

TEST_F(Completion, WorksForWhoTypesInZsh) {
  if (!fs::exists("/usr/bin/zsh")) GTEST_SKIP() << "zsh is not installed";
  Talk robot = bench_.talk();
  const fs::path trap = folder_ / "trap";
  robot.say("1 pub create mode=oto port=5000 text=\"$(touch " + trap.string() + ")\"");
  EXPECT_THAT(robot.lines_until_pong(), IsEmpty());
  auto settings = environment(nobody());
  settings.insert({{"TERM", "dumb"}, {"PS1", "ready$ "}});
  TypedShell zsh(bench_.lab(), {"/usr/bin/zsh", "-f", "-i"}, settings);
  ASSERT_TRUE(zsh.shows("ready$ "));
  zsh.type("fpath=(" + folder_.string() + " $fpath); autoload -Uz compinit; compinit -D -u; echo com''plete\n");
  ASSERT_TRUE(zsh.shows("complete\r"));
  zsh.type("geminga-query --connect " + address() + " match soccer:SharedBallI\t");
  EXPECT_TRUE(zsh.shows("SharedBallInfo"));
  zsh.type("\x15geminga-query --connect " + address() + " why \t\t");
  EXPECT_TRUE(zsh.shows("vision@robot0 asks for 77, nobody serves it"));
  zsh.type("\x15geminga-query --connect " + address() + " match --text \\$\t");
  EXPECT_TRUE(zsh.shows("\\)"));
  zsh.type("\necho en''d\n");
  EXPECT_TRUE(zsh.shows("end\r"));
  EXPECT_FALSE(fs::exists(trap));
}

}  // namespace
}  // namespace geminga::tools
