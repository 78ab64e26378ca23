// The man page and the completions of a program with the most awkward flags.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "manual/bash_completion.hpp"
#include "manual/describe.hpp"
#include "manual/fish_completion.hpp"
#include "manual/man_page.hpp"
#include "manual/outline.hpp"
#include "manual/zsh_completion.hpp"
#include "support/process.hpp"

namespace geminga::manual {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// `awkward`, with flags and commands of all kinds.
class Manual : public testing::Test {
 protected:
  Manual() {
    app_.footer(
        "Examples:\n  awkward 'a\\b' --mode fast\n\nIt's `said` here.\n.And here.\n\nExit status: 0 done,\n2 not.");
    app_.set_version_flag("--version", "awkward 1.2.3 (parts 4, others 5)", "Print the version");
    app_.fallthrough();
    app_.add_option("-m,--mode", mode_, "How: [fast] or 'slow'\\")->type_name("fast|very-slow|COST");
    app_.add_option("--config", config_, "Where Protégé is")->type_name("FILE");
    app_.add_option("--name", name_, ".dotted")->type_name("NAME");
    app_.add_flag("--hidden", flag_, "Nobody sees it")->group("");
    CLI::App* draw = app_.add_subcommand("draw", "Draws: \"quickly\"");
    draw->add_option("FILES", files_, "What to draw")->required();
    draw->add_option("--format", format_, "In which form")->check(CLI::IsMember({"dot", "svg"}));
    draw->add_flag("--big", flag_, "Larger")->group("For the eyes");
    app_.add_subcommand("show", "Shows")->add_option("WHAT", name_, "What to show");
  }

  [[nodiscard]] Outline outline() const { return outline_of(app_); }

  /// The words that bash offers for the last one.
  [[nodiscard]] std::vector<std::string> offered(const std::vector<std::string>& words) const {
    std::string script = bash_completion(outline()) + "\nCOMP_WORDS=(";
    std::string line;  // bash splits at `=` what stands together
    for (const std::string& word : words) {
      script += " '" + word + "'";
      line += (line.empty() || word == "=" || line.ends_with('=') ? "" : " ") + word;
    }
    script += ")\nCOMP_LINE='" + line + "'\nCOMP_CWORD=" + std::to_string(words.size() - 1) +
              "\ncd '" GEMINGA_SOURCE_DIR + "/src'\n_awkward\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
    const auto ran = system::run({.words = {"/bin/bash", "-uc", script}, .environment = {}, .before = {}});
    EXPECT_EQ(ran.status, 0) << ran.said;
    std::vector<std::string> found;
    std::istringstream lines(ran.said);
    for (std::string one; std::getline(lines, one);) {
      if (!one.empty()) found.push_back(one);
    }
    return found;
  }

  CLI::App app_{"Does\nwhat it can.", "awkward"};
  std::string mode_;
  std::string config_;
  std::string name_;
  std::string format_;
  std::vector<std::string> files_;
  bool flag_ = false;
};

TEST_F(Manual, OutlineHasWhatHelpShows) {
  const Outline all = outline();
  EXPECT_EQ(all.version, "awkward 1.2.3 (parts 4, others 5)");
  ASSERT_EQ(all.flags.size(), 5U);
  EXPECT_THAT(all.flags[2].names, ElementsAre("-m", "--mode"));
  EXPECT_THAT(all.flags[2].choices, ElementsAre("fast", "very-slow"));
  EXPECT_TRUE(all.flags[3].is_file);
  ASSERT_EQ(all.commands.size(), 2U);
  EXPECT_THAT(all.commands[0].flags[1].choices, ElementsAre("dot", "svg"));
  EXPECT_EQ(all.commands[0].flags[1].value, "TEXT");
  EXPECT_EQ(all.commands[0].flags[2].group, "For the eyes");
  EXPECT_TRUE(all.commands[0].words[0].is_repeated);
}

TEST_F(Manual, ManPageHasItsSections) {
  const std::string page = man_page(outline(), 8, "2026-11-23");
  EXPECT_THAT(page, HasSubstr(".TH AWKWARD 8 2026-11-23 \"Geminga 1.2.3\" \"Geminga\"\n"));
  EXPECT_THAT(page, HasSubstr(".SH NAME\nawkward \\- Does\n"));
  EXPECT_THAT(page, HasSubstr("\\fBawkward draw\\fR [\\fIOPTIONS\\fR] \\fIFILES\\fR ..."));
  EXPECT_THAT(page, HasSubstr(".SH EXAMPLES\n.EX\n  awkward \\(aqa\\eb\\(aq \\-\\-mode fast\n.EE\n.SH NOTES\n"));
  EXPECT_THAT(page, HasSubstr("It\\(aqs \\(gasaid\\(ga here.\n\\&.And here.\n.SH EXIT STATUS\n0 done,\n2 not.\n"));
  EXPECT_THAT(page, HasSubstr("\\fB\\-m\\fR, \\fB\\-\\-mode\\fR \\fIfast|very\\-slow|COST\\fR"));
  EXPECT_THAT(page, HasSubstr("Where Prot\\[u00E9]g\\[u00E9] is"));
  EXPECT_THAT(page, HasSubstr("\n\\&.dotted\n"));
  EXPECT_THAT(page, Not(HasSubstr("hidden")));
  EXPECT_TRUE(std::ranges::all_of(page, [](char c) { return c == '\n' || (c >= ' ' && c < 0x7f); }));
}

TEST_F(Manual, BashOffersCommandsFlagsChoicesAndFiles) {
  EXPECT_THAT(offered({"awkward", ""}), ElementsAre("draw", "show"));
  EXPECT_THAT(offered({"awkward", "dr"}), ElementsAre("draw"));
  EXPECT_THAT(offered({"awkward", "--m"}), ElementsAre("--mode"));
  EXPECT_THAT(offered({"awkward", "--mode", ""}), ElementsAre("fast", "very-slow"));
  EXPECT_THAT(offered({"awkward", "-m", "v"}), ElementsAre("very-slow"));
  EXPECT_THAT(offered({"awkward", "--mode", "=", "f"}), ElementsAre("fast"));
  EXPECT_THAT(offered({"awkward", "--mode", "="}), ElementsAre("fast", "very-slow"));
  EXPECT_THAT(offered({"awkward", "--name", "draw", "sh"}), ElementsAre("show")) << "draw is a name there";
  EXPECT_THAT(offered({"awkward", "--name", "=", "draw", "sh"}), ElementsAre("show"));
  EXPECT_THAT(offered({"awkward", "--name", ""}), IsEmpty());
  EXPECT_THAT(offered({"awkward", "--config", "manual/man"}),
              testing::UnorderedElementsAre("manual/man_page.cpp", "manual/man_page.hpp"));
  EXPECT_THAT(offered({"awkward", "--hid"}), IsEmpty());
  EXPECT_THAT(offered({"awkward", "draw", "--f"}), ElementsAre("--format"));
  EXPECT_THAT(offered({"awkward", "draw", "--format", ""}), ElementsAre("dot", "svg"));
  EXPECT_THAT(offered({"awkward", "draw", "manual/out"}),
              testing::UnorderedElementsAre("manual/outline.cpp", "manual/outline.hpp"));
  EXPECT_THAT(offered({"awkward", "draw", "--mo"}), ElementsAre("--mode")) << "flags of the program hold everywhere";
  EXPECT_THAT(offered({"awkward", "draw", "--mode", "f"}), ElementsAre("fast"));
  EXPECT_THAT(offered({"awkward", "show", "--format", "d"}), IsEmpty()) << "that is of another command";
  EXPECT_THAT(offered({"awkward", "$(touch /nowhere)", "`false`", ""}), ElementsAre("draw", "show"));
}

TEST_F(Manual, FlagsOfTheProgramStandBeforeTheCommandWhereTheyDoNotFallThrough) {
  app_.fallthrough(false);
  EXPECT_THAT(offered({"awkward", "draw", "--mo"}), IsEmpty());
  EXPECT_THAT(offered({"awkward", "--mo"}), ElementsAre("--mode"));
}

TEST_F(Manual, ZshIsToldWhatEachMeans) {
  const std::string text = zsh_completion(outline());
  EXPECT_THAT(text, testing::StartsWith("#compdef awkward\n"));
  EXPECT_THAT(
      text,
      HasSubstr(R"x('(-m --mode)--mode=[How\: \[fast\] or '\''slow'\''\\]:fast|very-slow|COST:(fast very-slow)')x"));
  EXPECT_THAT(text, HasSubstr(R"('draw:Draws: "quickly"')"));
  EXPECT_THAT(text, HasSubstr("'*:FILES:_files'"));
  EXPECT_THAT(text, Not(HasSubstr("hidden")));
}

TEST_F(Manual, FishIsToldWhatEachMeans) {
  const std::string text = fish_completion(outline());
  EXPECT_THAT(text, HasSubstr("\ncomplete -c awkward -f\n"));
  EXPECT_THAT(text,
              HasSubstr(R"x(complete -c awkward -s m -l mode -x -a 'fast very-slow' -d 'How: [fast] or \'slow\'\\')x"));
  EXPECT_THAT(text, HasSubstr("-n 'not __fish_seen_subcommand_from draw show' -a draw -d 'Draws: \"quickly\"'\n"));
  EXPECT_THAT(text, HasSubstr("complete -c awkward -n '__fish_seen_subcommand_from draw' -F\n")) << "its files";
  EXPECT_THAT(text, HasSubstr("complete -c awkward -n '__fish_seen_subcommand_from draw' -l format -x -a 'dot svg'"));
  EXPECT_THAT(text, Not(HasSubstr("hidden")));
}

TEST_F(Manual, IsAskedForByTwoWordsOnly) {
  const auto asked = [&](std::vector<const char*> words) {
    return described(app_, static_cast<int>(words.size()), words.data());
  };
  for (const char* form : {"man", "bash", "zsh", "fish"}) EXPECT_TRUE(asked({"awkward", "--describe", form})) << form;
  EXPECT_FALSE(asked({"awkward", "--describe"}));
  EXPECT_FALSE(asked({"awkward", "--describe", "tcsh"}));
  EXPECT_FALSE(asked({"awkward", "draw", "--describe", "man"}));
  ::setenv("SOURCE_DATE_EPOCH", "86400", 1);
  EXPECT_THAT(*asked({"awkward", "--describe", "man"}), HasSubstr(" 1970-01-02 "));
  ::setenv("SOURCE_DATE_EPOCH", "-99999999999999999999", 1);
  EXPECT_THAT(*asked({"awkward", "--describe", "man"}), HasSubstr(" 1970-01-01 "));
  ::unsetenv("SOURCE_DATE_EPOCH");
}

}  // namespace
}  // namespace geminga::manual
