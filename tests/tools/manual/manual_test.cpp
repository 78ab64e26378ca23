// The man pages and completions of the installed programs have everything in --help, and their readers accept them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "support/process.hpp"
#include "tools/help_text.hpp"

namespace geminga::tools {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;

fs::path made(const std::string& file) { return fs::path(GEMINGA_BINARY_DIR) / "manual" / file; }

/// All that are installed; a kind of bridge where its library is.
const std::vector<std::string> programs = [] {
  std::vector<std::string> all{"gemingad",          "geminga-ontology", "geminga-query", "geminga-publish",
                               "geminga-subscribe", "geminga-unseal",   "geminga-web",   "geminga-bridge"};
  for (const char* kind :
       {"geminga-bridge-dds", "geminga-bridge-dns-sd", "geminga-bridge-mqtt", "geminga-bridge-nats"}) {
    if (fs::exists(made(std::string(kind) + ".1"))) all.emplace_back(kind);
  }
  return all;
}();

fs::path page_of(const std::string& program) { return made(program + (program == "gemingad" ? ".8" : ".1")); }

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  EXPECT_TRUE(in) << file;
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string help(const std::string& program, const std::string& command = "") {
  std::vector<std::string> words{system::program(program)};
  if (!command.empty()) words.push_back(command);
  words.emplace_back("--help");
  const auto ran = system::run({.words = words, .environment = {}, .before = {}});
  EXPECT_EQ(ran.status, 0) << program << ' ' << command;
  return ran.said;
}

/// The flags at the beginnings of lines, or the commands.
std::vector<std::string> flags_of(const std::string& help) {
  std::vector<std::string> flags;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    static const std::regex begin(R"(^  ((?:-\w,)?--[\w,-]+))");
    std::smatch found;
    if (!std::regex_search(line, found, begin)) continue;
    std::istringstream names(found[1]);
    for (std::string name; std::getline(names, name, ',');) flags.push_back(name);
  }
  return flags;
}

/// A text as roff has it.
std::string in_roff(const std::string& text) { return std::regex_replace(text, std::regex("-"), "\\-"); }

/// The words that bash offers for the last of these.
std::vector<std::string> offered(const std::string& program, const std::vector<std::string>& words) {
  std::string script = ". '" + made(program + ".bash").string() + "'\nCOMP_WORDS=(" + program;
  std::string line = program;  // bash splits at `=` what stands together
  for (const std::string& word : words) {
    script += " '" + word + "'";
    line += (word == "=" || line.ends_with('=') ? "" : " ") + word;
  }
  script += ")\nCOMP_LINE='" + line + "'\nCOMP_CWORD=" + std::to_string(words.size()) + "\ncomplete -p " + program +
            " >/dev/null\n_" + std::regex_replace(program, std::regex("-"), "_") +
            "\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
  const auto ran = system::run({.words = {"/bin/bash", "-euc", script}, .environment = {}, .before = {}});
  EXPECT_EQ(ran.status, 0) << ran.said;
  std::vector<std::string> found;
  std::istringstream lines(ran.said);
  for (std::string one; std::getline(lines, one);) found.push_back(one);
  return found;
}

/// The errors of a reader of the file; nothing where the reader is not installed.
std::optional<std::string> said_by(std::vector<std::string> words) {
  if (!fs::exists(words.front())) return std::nullopt;
  const auto ran = system::run({.words = std::move(words), .environment = {}, .before = {}});
  return ran.said + (ran.status == 0 ? "" : "exit status " + std::to_string(ran.status));
}

TEST(ManualOfThePrograms, HasEveryFlagOfTheHelp) {
  for (const std::string& program : programs) {
    const std::string page = text_of(page_of(program));
    const std::string zsh = text_of(made('_' + program));
    std::vector<std::string> commands = commands_of(help(program));
    EXPECT_EQ(commands.empty(), program != "geminga-query" && program != "geminga-ontology") << program;
    commands.emplace_back();
    for (const std::string& command : commands) {
      const auto flags = flags_of(help(program, command));
      EXPECT_THAT(flags, Contains("--help"));
      std::vector<std::string> words;
      if (!command.empty()) words.push_back(command);
      words.emplace_back("-");
      EXPECT_THAT(offered(program, words), IsSupersetOf(flags)) << program << ' ' << command;
      for (const std::string& flag : flags) {
        EXPECT_THAT(page, HasSubstr("\\fB" + in_roff(flag) + "\\fR")) << program << ' ' << command;
        EXPECT_TRUE(zsh.contains(flag + '[') || zsh.contains(flag + "=[")) << program << ' ' << command << flag;
      }
      if (command.empty()) continue;
      EXPECT_THAT(page, HasSubstr(".SS " + in_roff(command) + '\n'));
      EXPECT_THAT(zsh, HasSubstr('\'' + command + ':'));
      EXPECT_THAT(offered(program, {command}), testing::ElementsAre(command));
    }
  }
}

TEST(ManualOfThePrograms, HasItsExamplesAndExitStatuses) {
  for (const std::string& program : programs) {
    const std::string page = text_of(page_of(program));
    EXPECT_THAT(page, HasSubstr(".SH EXAMPLES\n.EX\n  " + in_roff(program) + ' ')) << program;
    EXPECT_TRUE(page.contains(".SH EXIT STATUS\n") || page.contains("status 0")) << program;
  }
  EXPECT_THAT(text_of(page_of("geminga-subscribe")), HasSubstr("GEMINGA_EVENT"));
}

TEST(ManualOfThePrograms, CompletesValuesInBash) {
  EXPECT_THAT(offered("geminga-subscribe", {"soccer:BallInfo", "--mode", "otm/p"}), testing::ElementsAre("otm/pubsub"));
  EXPECT_THAT(offered("geminga-query", {"match", "--degree", "=", "n"}), testing::ElementsAre("narrower"));
  EXPECT_THAT(offered("geminga-ontology", {"draw", "--format", "d"}), testing::ElementsAre("dot"));
  EXPECT_THAT(offered("geminga-ontology", {"convert", "-o", "/etc/host"}), Contains("/etc/hosts"));
  EXPECT_THAT(offered("geminga-ontology", {"convert", "--to", "t"}), testing::ElementsAre("turtle"));
  EXPECT_THAT(offered("gemingad", {"--log-level", ""}), testing::ElementsAre("debug", "info", "warning", "error"));
  EXPECT_THAT(offered("geminga-ontology", {"check", "/etc/host"}), Contains("/etc/hosts"));
  EXPECT_THAT(offered("gemingad", {"--config", "/etc/host"}), Contains("/etc/hosts"));
}

TEST(ManualOfThePrograms, IsTakenByMandocAndGroffWithoutAWord) {
  for (const std::string& program : programs) {
    const std::string page = page_of(program).string();
    const auto mandoc = said_by({"/usr/bin/mandoc", "-T", "lint", "-W", "warning", page});
    const auto groff = said_by({"/usr/bin/groff", "-man", "-ww", "-Tutf8", "-z", page});
    EXPECT_THAT(mandoc.value_or(""), IsEmpty()) << program;
    EXPECT_THAT(groff.value_or(""), IsEmpty()) << program;
    if (!mandoc && !groff) GTEST_SKIP() << "neither mandoc nor groff is installed";
  }
}

TEST(ManualOfThePrograms, IsTakenByBashAndZsh) {
  for (const std::string& program : programs) {
    EXPECT_EQ(said_by({"/bin/bash", "-n", made(program + ".bash").string()}).value_or("no bash"), "") << program;
    const auto zsh = said_by({"/usr/bin/zsh", "-n", made('_' + program).string()});
    EXPECT_THAT(zsh.value_or(""), IsEmpty()) << program;
    if (!zsh) GTEST_SKIP() << "zsh is not installed";
  }
}

}  // namespace
}  // namespace geminga::tools
