#include "manual/mistake.hpp"

#include <gtest/gtest.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>
#include <string>
#include <utility>
#include <vector>

namespace geminga::manual {
namespace {

/// `kitchen` with two commands and some flags.
class Mistake : public testing::Test {
 protected:
  Mistake() {
    app_.require_subcommand(1);
    app_.fallthrough();
    app_.add_option("--spoon", spoon_);
    app_.add_option("--hidden", spoon_)->group("");
    CLI::App* cook = app_.add_subcommand("cook", "");
    cook->add_option("DISH", dishes_);
    cook->add_option("--salt", spoon_);
    cook->add_option("--recipe", spoon_)->check(CLI::ExistingFile);
    cook->add_flag("--hot", is_hot_);
    cook->add_option("--pan", spoon_)->check([](const std::string&) { return std::string("is lost"); });
    CLI::App* wash = app_.add_subcommand("wash", "");
    wash->add_option("--water", spoon_)->check(CLI::IsMember({"cold", "hot"}));
    wash->add_option("--times", times_)->check(CLI::Range(1, 9));
  }

  /// The words about a command line, or nothing where it is right.
  std::string said(const std::vector<std::string>& words) {
    std::vector<const char*> line{"kitchen"};
    for (const std::string& word : words) line.push_back(word.c_str());
    try {
      app_.parse(static_cast<int>(line.size()), line.data());
    } catch (const CLI::ParseError& error) {
      return mistake(app_, error);
    }
    return empty_text(app_).value_or("");
  }

 private:
  CLI::App app_{"", "kitchen"};
  std::string spoon_;
  int times_ = 0;
  bool is_hot_ = false;
  std::vector<std::string> dishes_;
};

TEST_F(Mistake, NamesWhatMayBeMeantOrWhatThereIs) {
  const std::string see = "see kitchen --help";
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"cok"}, "'cok' is no command: did you mean cook? " + see},
      {{"dance"}, "'dance' is no command: the commands are cook, wash: " + see},
      {{"--spoon", "x", "cok"}, "'cok' is no command: did you mean cook? " + see},
      {{"--spon=x"}, "'--spon' is no flag: did you mean --spoon? " + see},
      {{"cook", "--sallt", "x"}, "'--sallt' is no flag: did you mean --salt? " + see},
      {{"cook", "--spon=x"}, "'--spon' is no flag: did you mean --spoon? " + see},
      {{"cook", "--hiden", "x"}, "'--hiden' is no flag: " + see},
      {{"cook", "-x"}, "'-x' is no flag: " + see},
      {{"wash", "cook\x1b[2J"}, "'cook?[2J' is one word too many: " + see},
      {{}, "a command is missing: the commands are cook, wash: " + see},
      {{"cook", "--salt"}, "--salt: TEXT is missing: " + see},
      {{"wash", "--water", "icy"}, "--water: icy is none of cold, hot: " + see},
      {{"wash", "--times", "10"}, "--times: 10 is not from 1 to 9: " + see},
      {{"cook", "--recipe", "/nowhere"}, "--recipe: there is no file /nowhere: " + see},
      {{"cook", "--pan", "x"}, "--pan is lost: " + see},
      {{"cook", "--hot=x"}, "--hot takes no value such as x: " + see},
      {{"cook", "soup", "--salt", "1"}, ""},
  };
  for (const auto& [words, text] : cases) EXPECT_EQ(said(words), text) << testing::PrintToString(words);
}

TEST(MistakeInWhatIsRequired, IsTheFlagThatIsNone) {
  CLI::App app{"", "kitchen"};
  std::string dish;
  app.add_subcommand("cook", "")->add_option("DISH", dish)->required();
  const auto said = [&](const std::vector<const char*>& words) -> std::string {
    try {
      app.parse(static_cast<int>(words.size()), words.data());
    } catch (const CLI::ParseError& error) {
      return mistake(app, error);
    }
    return "";
  };
  EXPECT_EQ(said({"kitchen", "cook"}), "DISH is required: see kitchen --help");
  EXPECT_EQ(said({"kitchen", "cook", "-soup"}), "'-soup' is no flag: see kitchen --help");
}

TEST_F(Mistake, IsAnEmptyText) {
  const std::string rest =
      " is empty: leave it out, or see whether the variable that it comes from is set: see kitchen --help";
  EXPECT_EQ(said({"cook", ""}), "DISH" + rest);
  EXPECT_EQ(said({"cook", "soup", ""}), "DISH" + rest);
  EXPECT_EQ(said({"cook", "--salt", ""}), "--salt" + rest);
  EXPECT_EQ(said({"--spoon", "", "wash"}), "--spoon" + rest);
  EXPECT_EQ(said({"cook", " "}), "");
}

}  // namespace
}  // namespace geminga::manual
